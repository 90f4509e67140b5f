"""Necking scenes read from XML.

<necking name="..." title="...">
  <description>...</description>  <source>...</source>
  <material card="steel_weldox_460e_johnson_cook"/>    a shipped card, or a whole card of core_models.cards
  <round_bar radius="" length="" taper="" end="free|held"/>  or <square_bar ...>, <strip ...>, radius: half the width
  <pull distance="" duration=""/>                      of each end
  <run name="" method="" across="" along="" .../>      any number; other attributes: see `PlannedRun`, and options of
                                                       the solver: integration, cure, tolerance, interpolation, ...
  <curve label="" href="" force="column" .../>         a CSV file beside the scene with a column `elongation`
  <expect run="" quantity="" at="" low="" high="" source=""/>
  <agree run="" with="" quantity="" at="" within=""/>
  <near run="" curve="" quantity="" within="" beyond="" up_to=""/>
  <same_limit runs="a b c" others="d e f" quantity="" at=""/>
  <newton run="" least=""/>  <uniform_peak run="" within=""/>
</necking>
"""

import hashlib
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from lxml import etree

from core_models.cards import (
    check_attributes,
    load_document,
    named_children,
    parse_material,
    read_material,
    refusal,
    shipped_materials,
)
from core_models.errors import MeshError, SceneError
from core_models.flow.voce import Voce
from core_models.material import Material
from core_models.names import suggestion
from studies.methods.solver_options import SOLVER_OPTIONS
from studies.necking.bar_necking import QUANTITIES, NeckingHistory
from studies.necking.bodies import check_kind
from studies.necking.methods import DELETE, IMPLICIT, METHODS
from studies.necking.scene import (
    COUNTS,
    ROUND_BAR,
    SQUARE_BAR,
    STRIP,
    Agreement,
    Check,
    Expected,
    Limits,
    Nearness,
    NeckingCurve,
    NeckingScene,
    NewtonOrder,
    PlannedRun,
    UniformPeak,
)
from studies.scenes.attributes import (
    choice,
    local_file,
    number_attribute,
    required_number,
    required_text,
)
from studies.scenes.shipped import SCENES_FOLDER

FOLDER = SCENES_FOLDER / "necking"
BODIES = {"round_bar": ROUND_BAR, "square_bar": SQUARE_BAR, "strip": STRIP}
CHECKS = ("expect", "agree", "near", "same_limit", "newton", "uniform_peak")
REPEATABLE = ("run", "curve", *CHECKS)
TAGS = ("description", "source", "material", *BODIES, "pull", *REPEATABLE)
OPTIONS = tuple({name: None for options in SOLVER_OPTIONS.values() for name in options})
CHANGEABLE = ("increments", "tolerance", "note", "quick", "extra")


def necking_scenes() -> dict[str, Path]:
    """Name and file of every shipped necking scene."""
    return {path.stem: path for path in sorted(FOLDER.glob("*.xml"))}


def read_necking_scene(name: str | Path) -> NeckingScene:
    """The necking scene of a shipped name or a file; CardError or SceneError naming file, line and remedy."""
    root = load_document(_find(name), ())
    if root.tag != "necking":
        raise refusal(root, f"the root is <{root.tag}>", 'write <necking name="...">', SceneError)
    check_attributes(root, ("name", "title"))
    children = named_children(root, {tag: tag for tag in TAGS}, REPEATABLE)
    bodies = [tag for tag in BODIES if tag in children]
    if len(bodies) != 1 or not {"material", "pull", "run"} <= set(children):
        wanted = "give one <material>, one <pull>, a <run>, and one of " + ", ".join(
            f"<{tag}>" for tag in BODIES
        )
        raise refusal(root, "the scene is not whole", wanted, SceneError)
    body, pull = children[bodies[0]], children["pull"]
    check_attributes(body, ("radius", "length", "taper", "end"))
    check_attributes(pull, ("distance", "duration"))
    folder = Path(name).parent if Path(name).suffix == ".xml" else FOLDER
    scene = NeckingScene(
        name=required_text(root, "name"),
        material=_material(children["material"]),
        radius=_above_zero(body, "radius"),
        length=_above_zero(body, "length"),
        taper=number_attribute(body, "taper", 1.0),
        pull=_above_zero(pull, "distance"),
        duration=1.0 if pull.get("duration") is None else _above_zero(pull, "duration"),
        body=BODIES[bodies[0]],
        held=body.get("end") is not None and choice(body, "end", ("free", "held")) == "held",
        title=root.get("title", required_text(root, "name")),
        description=_words(root, "description"),
        source=_words(root, "source"),
        runs=tuple(_run(element, BODIES[bodies[0]]) for element in root.findall("run")),
        curves=tuple(_curve(element, folder) for element in root.findall("curve")),
    )
    _refuse_twins(root, scene.runs)
    return replace(scene, checks=tuple(_check(element, scene) for element in root if element.tag in CHECKS))


def fingerprint(name: str | Path) -> str:
    """Hash of what the runs of a scene are made from: another for another material, body, pull or run.

    What a run may go on with in another way is no part of it: increments, tolerance, and what is said of it.
    """
    digest = hashlib.sha256()
    for element in load_document(_find(name), ()):
        if element.tag in ("material", *BODIES, "pull", "run"):
            if element.tag == "run":
                for attribute in CHANGEABLE:
                    element.attrib.pop(attribute, None)
            digest.update(etree.tostring(element, method="c14n", with_comments=False))
    return digest.hexdigest()[:16]


def _refuse_twins(root: etree._Element, runs: tuple[PlannedRun, ...]) -> None:
    # Each is kept in a file of its name, where ':' and '/' become '-'.
    files = [run.name.replace(":", "-").replace("/", "-") for run in runs]
    for run, file in zip(runs, files, strict=True):
        if files.count(file) > 1:
            raise refusal(
                root, f"two runs are called {run.name!r} or alike", "give each a name of its own", SceneError
            )


def _find(name: str | Path) -> Path:
    shipped = necking_scenes()
    if str(name) in shipped:
        return shipped[str(name)]
    if Path(name).suffix == ".xml":
        return Path(name)
    raise SceneError(
        f"no necking scene '{name}'; {suggestion(str(name), shipped)} (or give the path of an XML file)"
    )


def _words(root: etree._Element, tag: str) -> str:
    return " ".join((root.findtext(tag) or "").split())


def _material(element: etree._Element) -> Material:
    if element.get("card") is None:
        return parse_material(element).material
    check_attributes(element, ("card",))
    cards = shipped_materials()
    return read_material(cards[choice(element, "card", tuple(cards))]).material


def _run(element: etree._Element, body: str) -> PlannedRun:
    plain = {each.name: each.type for each in fields(PlannedRun) if each.name != "options"}
    check_attributes(element, (*plain, *OPTIONS))
    method = choice(element, "method", tuple(METHODS))
    if element.get("body") is not None:
        choice(element, "body", tuple(BODIES.values()))
    if element.get("erosion") is not None:
        choice(element, "erosion", (DELETE,))
    given: dict[str, Any] = {}
    for name, kind in plain.items():
        if element.get(name) is None:
            continue
        if kind is bool:
            given[name] = choice(element, name, ("yes", "no")) == "yes"
        elif kind is int:
            given[name] = _whole(element, name)
        elif kind in (str, str | None):
            given[name] = required_text(element, name)
        elif name in ("grading", "duration", "radius"):
            given[name] = _above_zero(element, name)
        else:
            given[name] = required_number(element, name)
    for name in ("name", "across", "along", *(("increments",) if method in IMPLICIT else ())):
        required_text(element, name)
    for name in ("periods", "damage_radius"):
        if given.get(name, 0.0) < 0.0:
            raise refusal(element, f'{name}="{given[name]:g}"', "write a number from 0", SceneError)
    plan = PlannedRun(**given, options=_options(element, method))
    try:
        check_kind(plan.body or body, plan.kind)
    except (MeshError, SceneError) as error:
        raise refusal(element, str(error), 'change kind="..."', SceneError) from None
    return plan


def _options(element: etree._Element, method: str) -> dict[str, str | float]:
    given, known = [name for name in OPTIONS if name in element.attrib], SOLVER_OPTIONS[method]
    for name in given:
        if name not in known:
            raise refusal(element, f"{method} has no option {name}", "it has " + ", ".join(known), SceneError)
    return {
        name: choice(element, name, known[name]) if known[name] else required_number(element, name)
        for name in given
    }


def _above_zero(element: etree._Element, name: str) -> float:
    value = required_number(element, name)
    if value <= 0.0:
        raise refusal(element, f'{name}="{value:g}"', "write a number above 0", SceneError)
    return value


def _whole(element: etree._Element, name: str) -> int:
    value = required_number(element, name)
    if value < 1.0 or value != int(value):
        raise refusal(element, f'{name}="{value:g}"', "write a whole number from 1", SceneError)
    return int(value)


def _curve(element: etree._Element, folder: Path) -> NeckingCurve:
    check_attributes(element, ("label", "href", *NeckingHistory.COLUMNS))
    columns = {name: element.get(name) for name in NeckingHistory.COLUMNS if element.get(name)}
    return NeckingCurve(required_text(element, "label"), local_file(element, folder), columns)


def _check(element: etree._Element, scene: NeckingScene) -> Check:
    runs = tuple(run.name for run in scene.runs)
    if element.tag == "same_limit":
        check_attributes(element, ("runs", "others", "quantity", "at"))
        families = [_family(element, name, runs) for name in ("runs", "others")]
        return Limits(*families, *_quantity(element))
    run = choice(element, "run", runs)
    if element.tag == "expect":
        check_attributes(element, ("run", "quantity", "at", "low", "high", "source"))
        name, at = _quantity(element)
        low, high = required_number(element, "low"), required_number(element, "high")
        return Expected(run, name, low, high, at, element.get("source", ""))
    if element.tag == "agree":
        check_attributes(element, ("run", "with", "quantity", "at", "within"))
        name, at = _quantity(element)
        return Agreement(run, choice(element, "with", runs), name, required_number(element, "within"), at)
    if element.tag == "near":
        check_attributes(element, ("run", "curve", "quantity", "within", "beyond", "up_to"))
        curve = choice(element, "curve", tuple(curve.label for curve in scene.curves))
        columns = next(each.columns for each in scene.curves if each.label == curve)
        column = choice(element, "quantity", tuple(columns))
        within, up_to = required_number(element, "within"), required_number(element, "up_to")
        return Nearness(run, curve, column, within, number_attribute(element, "beyond", 0.0), up_to)
    if element.tag == "newton":
        check_attributes(element, ("run", "least"))
        return NewtonOrder(run, required_number(element, "least"))
    check_attributes(element, ("run", "within"))
    if not isinstance(scene.material.flow, Voce):
        raise refusal(
            element, "the closed form is that of a Voce law", "leave out <uniform_peak>", SceneError
        )
    return UniformPeak(run, required_number(element, "within"))


def _family(element: etree._Element, name: str, runs: tuple[str, ...]) -> tuple[str, ...]:
    words = tuple(required_text(element, name).split())
    for word in words:
        if word not in runs:
            raise refusal(element, f"no run is called {word!r}", suggestion(word, runs), SceneError)
    return words


def _quantity(element: etree._Element) -> tuple[str, float | None]:
    at = number_attribute(element, "at")
    known = (*QUANTITIES, *COUNTS) if at is None else NeckingHistory.COLUMNS
    return choice(element, "quantity", known), at
