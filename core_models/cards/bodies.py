"""The bodies that a material block places."""

from dataclasses import dataclass

from lxml import etree

from core_models.cards.blocks import check_attributes, check_text, named_children, names_of
from core_models.cards.models import read_numbers
from core_models.cards.origins import refusal
from core_models.errors import UnsupportedError
from core_models.names import suggestion
from core_models.schema import BODY, CYLINDER, UNAVAILABLE_SHAPES

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Cylinder:
    """A cylinder of a `<geom_object>`: ends and radius [m], initial velocity [m/s] and temperature [K]."""

    label: str
    bottom: Vector
    top: Vector
    radius: float
    velocity: Vector
    temperature: float
    res: Vector | None


def read_body(element: etree._Element) -> Cylinder:
    """The cylinder of a `<geom_object>`."""
    check_attributes(element, ("name",))
    names = {"cylinder": "cylinder", **names_of(BODY)}
    for child in element:
        if child.tag in UNAVAILABLE_SHAPES:
            raise refusal(
                child, f"<{child.tag}> is known but not available", "use a <cylinder>", UnsupportedError
            )
    children = named_children(element, names)
    numbers = read_numbers(element, BODY, children, {})
    if "cylinder" not in children:
        raise refusal(element, "<geom_object> has no shape", suggestion("", ("cylinder",)))
    shape = children["cylinder"]
    check_attributes(shape, ("label",))
    check_text(shape)
    sizes = read_numbers(shape, CYLINDER, named_children(shape, names_of(CYLINDER)), {})
    if sizes["bottom"] == sizes["top"]:
        raise refusal(shape, "the cylinder's bottom and top are one point", "move one of them")
    return Cylinder(
        label=shape.get("label", element.get("name", "")), res=numbers.pop("res", None), **sizes, **numbers
    )
