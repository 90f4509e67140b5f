"""Scenes read from XML: the founding `<material>` block inside a small document.

<scene name="...">
  <description>...</description>                                   optional
  <material> ... with one geom_object cylinder ... </material>     core_models.cards
  <mesh href="bar.msh"/>  <laws href="my_laws.py"/>                optional, in the scene's folder
  <wall type="unilateral|plane" friction="0.1"/>                   default unilateral, without friction
  <end time="80e-6"/>                                              or:
  <end after="release" latest="150e-6" plane="120e-6"/>            plane: end under a wall without release
  <plastic_heating>off</plastic_heating>                           default: as the card says
  <conduction>on</conduction>                                      default off: every point keeps its heat
  <bulk_viscosity linear="0.06" quadratic="1.2"/>                  default as here; 0 and 0: off
  <resolution fem="8 12 16" mpm="12 16 24"/>                       elements, cells across the radius
  <reference quantity="foot_radius" value="..." (or low, high) wall="..." source="..."/>       any number
  <reference_curve kind="history|profile" href="..." wall="..." source="..."/>                 any number
</scene>
"""

import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from lxml import etree

from core_models import user_laws
from core_models.bulk_viscosity import BulkViscosity
from core_models.cards import check_attributes, load_document, named_children, parse_material, refusal
from core_models.conduction import missing_tags
from core_models.errors import MaterialError, SceneError
from core_models.material import Material
from core_models.walls import MEANING, Wall
from studies.bar.reader import read_bar
from studies.methods.method import METHODS
from studies.scenes.attributes import choice, local_file, number_attribute, required_number, whole_numbers
from studies.scenes.reference_reader import read_curve_entry, read_reference
from studies.scenes.scene import End, Scene
from studies.scenes.shipped import find_scene

NAME = re.compile(r"[^\W_][\w.-]{0,99}")  # it becomes a part of a folder's name
REPEATABLE = ("reference", "reference_curve")
TAGS = (
    "description",
    "material",
    "mesh",
    "laws",
    "wall",
    "end",
    "plastic_heating",
    "conduction",
    "bulk_viscosity",
    "resolution",
    *REPEATABLE,
)


def read_scene(
    name: str | Path, search_roots: Iterable[str | Path] = (), laws: str | Path | None = None
) -> Scene:
    """The scene of a shipped name or a file.

    search_roots: folders where includes are looked for; laws: a file with laws of the user's own.
    Raises CardError or SceneError naming file, line, wrong value and remedy.
    """
    path = find_scene(name)
    root = load_document(path, search_roots)
    if root.tag != "scene":
        raise refusal(
            root, f"the root is <{root.tag}>", 'a scene document has the root <scene name="...">', SceneError
        )
    check_attributes(root, ("name",))
    children = named_children(root, {tag: tag for tag in TAGS}, REPEATABLE)
    own_laws = _load_laws(children.get("laws"), path.parent, laws)
    for tag in ("material", "end"):
        if tag not in children:
            raise refusal(root, f"<scene> lacks <{tag}>", "add it", SceneError)
    card = parse_material(children["material"])
    material = _with_heating(card.material, children.get("plastic_heating"))
    wall = _wall(children.get("wall"))
    return Scene(
        name=_name(root, path),
        material=material,
        bar=read_bar(card.bodies, children["material"]),
        end=_end(children["end"]),
        wall=wall.kind,
        friction=wall.friction,
        viscosity=_viscosity(children.get("bulk_viscosity")),
        conduction=_conduction(children.get("conduction"), material),
        resolutions=_resolutions(children.get("resolution")),
        description=" ".join((root.findtext("description") or "").split()),
        references=tuple(read_reference(element) for element in root.findall("reference")),
        curves=tuple(read_curve_entry(element, path.parent) for element in root.findall("reference_curve")),
        mesh=_file(children.get("mesh"), path.parent),
        laws=own_laws,
        unused=tuple(f"{Path(tag.file).name}:{tag.line}: <{tag.tag}>" for tag in card.unused),
    )


def _name(root: etree._Element, path: Path) -> str:
    name = root.get("name", path.stem)
    if not NAME.fullmatch(name):
        raise refusal(
            root,
            f"the scene's name {name!r} cannot be used",
            'give <scene name="..."> a letter or digit, then letters, digits, ., - and _, 100 at most',
            SceneError,
        )
    return name


def _file(element: etree._Element | None, folder: Path) -> Path | None:
    if element is None:
        return None
    check_attributes(element, ("href",))
    return local_file(element, folder)


def _load_laws(element: etree._Element | None, folder: Path, extra: str | Path | None) -> Path | None:
    named = _file(element, folder)
    if named is not None and extra is not None:
        raise refusal(element, f"laws are given twice, here and as {extra}", "name one file", SceneError)
    path = named or (None if extra is None else Path(extra))
    if path is not None:
        user_laws.load(path)
    return path


def _wall(element: etree._Element | None) -> Wall:
    if element is None:
        return Wall()
    check_attributes(element, ("type", "friction"))
    kind = choice(element, "type", tuple(MEANING))
    try:
        return Wall(kind, number_attribute(element, "friction", 0.0))
    except SceneError as error:
        raise refusal(element, str(error), "delete it for a wall without friction", SceneError) from error


def _conduction(element: etree._Element | None, material: Material) -> bool:
    if element is None:
        return False
    check_attributes(element, ())
    if (element.text or "").strip() not in ("on", "off"):
        raise refusal(element, "<conduction> is neither on nor off", "write on or off", SceneError)
    missing = missing_tags(material)
    if element.text.strip() == "on" and missing:
        raise refusal(
            element,
            f"the card of {material.name} gives no {' and no '.join(missing)}, which conduction needs",
            "add it, or delete <conduction>",
            MaterialError,
        )
    return element.text.strip() == "on"


def _end(element: etree._Element) -> End:
    if element.get("after") is None:
        check_attributes(element, ("time",))
        times = {"time": required_number(element, "time")}
    else:
        check_attributes(element, ("after", "latest", "plane"))
        choice(element, "after", ("release",))
        times = {"latest": required_number(element, "latest"), "plane": number_attribute(element, "plane")}
    try:
        return End(**times)
    except SceneError as error:
        raise refusal(element, str(error), "correct it", SceneError) from error


def _viscosity(element: etree._Element | None) -> BulkViscosity | None:
    if element is None:
        return BulkViscosity()
    check_attributes(element, ("linear", "quadratic"))
    values = [number_attribute(element, name, 0.0) for name in ("linear", "quadratic")]
    if min(values) < 0.0:
        raise refusal(element, "negative bulk viscosity", "give 0 or more", SceneError)
    return BulkViscosity(*values) if any(values) else None


def _resolutions(element: etree._Element | None) -> dict[str, tuple[int, ...]]:
    if element is None:
        return {}
    check_attributes(element, tuple(method.scene_key for method in METHODS.values()))
    given = {name: whole_numbers(element, method.scene_key) for name, method in METHODS.items()}
    return {name: numbers for name, numbers in given.items() if numbers}


def _with_heating(material: Material, element: etree._Element | None) -> Material:
    if element is None:
        return material
    check_attributes(element, ())
    if (element.text or "").strip() != "off":
        raise refusal(
            element,
            "<plastic_heating> only turns off what the card brings",
            "write off, or delete it",
            SceneError,
        )
    return replace(material, heating=None)
