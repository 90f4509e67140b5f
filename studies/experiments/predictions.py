"""One prediction: a shot by a flow law and a method, next to what was measured."""

from dataclasses import replace
from typing import Any

import numpy as np

from core_models.cards import shipped_materials
from core_models.cards.reader import read_material
from core_models.errors import RunFailure
from studies.bar import profile
from studies.bar.shape import foot_height
from studies.experiments.shots import Shot, read_shots
from studies.runs.result import RunResult
from studies.runs.running import simulate
from studies.scenes.scene import Bar, End, Scene

CARDS = {
    "copper OFHC": (
        "copper_ofhc_johnson_cook",
        "copper_ofhc_zerilli_armstrong",
        "copper_ofhc_steinberg_cochran_guinan",
        "copper_ofhc_preston_tonks_wallace",
    ),
    "copper ETP": ("copper_etp_mts", "copper_ofhc_johnson_cook"),
    "aluminium 6061-T6": ("aluminium_6061_t6_johnson_cook",),
    "steel 4340": ("steel_4340_johnson_cook",),
}
"""Cards whose constants are those of a metal; ETP copper has no Johnson-Cook constants of its own."""

PERIODS = 4.0  # axial periods allowed beside the time in which the bar flies twice its length


def scene_of(shot: Shot, card: str) -> Scene:
    """The scene of a shot with the material of a card; its bar ends an axial period after it has left the wall."""
    material = read_material(shipped_materials()[card]).material
    bar = Bar(0.5 * shot.diameter, shot.length, -shot.velocity, shot.temperature)
    scene = Scene(shot.name, material, bar, End(time=1.0))
    latest = 2.0 * shot.length / shot.velocity + PERIODS * scene.axial_period
    return replace(scene, end=End(latest=latest))


def predict(shot: str, card: str, method: str, resolution: int, within: float) -> dict[str, Any]:
    """The row of one run: what it began with, what it has cost, predicted values and their errors.

    Errors are relative to what was measured; that of the undeformed length, which may be next to nothing, to L0.
    Raises RunFailure, which says how long the bar was by then, when the run goes wrong or does not end within so many
    seconds.
    """
    asked = next(each for each in read_shots() if each.name == shot)
    result = simulate(scene_of(asked, card), method, resolution, within=within)
    if result.failure is not None:
        raise RunFailure(f"{result.failure}; {_shortened(asked, result)}") from result.failure
    predicted = _values(result)
    errors = {
        name: (predicted[name] - value) / (asked.length if name == "undeformed_length" else value)
        for name, value in asked.measured.items()
        if name in predicted
    }
    return {
        "shot": shot,
        "material": asked.material,
        "temperature": asked.temperature,
        "velocity": asked.velocity,
        "card": card,
        "method": method,
        "resolution": resolution,
        "ended": result.ended,
        "points": result.points,
        "steps": result.cost.steps,
        "seconds": result.cost.cpu_s,
        "measured": asked.measured,
        "numerical_fracture": result.numerical_fracture,
        "predicted": predicted,
        "errors": errors,
        "profile_distance": _distance(asked, result),
    }


def _shortened(shot: Shot, result: RunResult) -> str:
    length, measured = result.history.column("length")[-1], shot.measured["final_length"]
    return f"the bar was {1e3 * length:.2f} mm long by then, measured are {1e3 * measured:.2f} mm"


def _values(result: RunResult) -> dict[str, float]:
    quantities = {name: quantity.value for name, quantity in result.quantities.items()}
    values = {
        "final_length": quantities["final_length"],
        "foot_diameter": 2.0 * quantities["foot_radius"],
        "undeformed_length": quantities["undeformed_length"],
    }
    wide = quantities["radius_at_0.2_L0"]
    return values if wide is None else values | {"diameter_at_02_L0": 2.0 * wide}


def _distance(shot: Shot, result: RunResult) -> float | None:
    """Root-mean-square distance between predicted and measured profile [m], both from their feet up."""
    if shot.profile is None:
        return None
    outline = result.final.outline
    side = outline["side"] - [0.0, foot_height(outline)]
    return profile.distance_between(side, np.asarray(shot.profile))
