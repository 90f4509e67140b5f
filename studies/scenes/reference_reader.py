"""References of a scene document: values and curves from elsewhere."""

from pathlib import Path

from lxml import etree

from core_models.cards import check_attributes, refusal
from core_models.errors import SceneError
from core_models.walls import MEANING
from studies.bar.quantity_names import QUANTITIES
from studies.scenes.attributes import choice, local_file, number_attribute, required_number, required_text
from studies.scenes.scene import Reference, ReferenceCurve


def read_reference(element: etree._Element) -> Reference:
    """One `<reference>`: a value, or low and high, in SI."""
    check_attributes(element, ("quantity", "value", "low", "high", "wall", "source"))
    value = number_attribute(element, "value")
    if value is not None and (element.get("low") or element.get("high")):
        raise refusal(element, "a value and a range are given", "keep one of them", SceneError)
    low, high = (value, value) if value is not None else _range(element)
    return Reference(
        choice(element, "quantity", QUANTITIES), low, high, required_text(element, "source"), _wall(element)
    )


def read_curve_entry(element: etree._Element, folder: Path) -> ReferenceCurve:
    """One `<reference_curve>`, its file in the scene's folder."""
    check_attributes(element, ("kind", "href", "wall", "source"))
    kind = choice(element, "kind", ("history", "profile"))
    return ReferenceCurve(kind, local_file(element, folder), required_text(element, "source"), _wall(element))


def _range(element: etree._Element) -> tuple[float, float]:
    low, high = required_number(element, "low"), required_number(element, "high")
    if low > high:
        raise refusal(element, f"low = {low:g} is above high = {high:g}", "swap them", SceneError)
    return low, high


def _wall(element: etree._Element) -> str | None:
    return None if element.get("wall") is None else choice(element, "wall", tuple(MEANING))
