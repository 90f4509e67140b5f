"""The numbers that effects were decided by, as a run has found them: each decision is verified by its result."""

from typing import Any

from core_models.laws import elastic_moduli, heat_capacity, melting_temperature
from studies.decisions.beforehand import HEATED, Decision, decisions
from studies.runs.result import RunResult


def verified(result: RunResult) -> list[tuple[Decision, float | None]]:
    """Every decision about a run with its number as the run has found it.

    The number is None where a run cannot tell: of an effect that it did not have, or if it has failed.
    """
    found = {} if result.failure is not None else afterwards(result)
    return [(each, found.get(each.effect)) for each in decisions(result.scene, result.wall)]


def is_confirmed(decision: Decision, found: float | None) -> bool | None:
    """Whether what the run has found is on the same side of the threshold as the scene's number.

    None where the run or the scene has none.
    """
    if found is None or decision.wanted is None:
        return None
    return (found >= decision.threshold) == decision.wanted


def decision_entry(decision: Decision, found: float | None) -> dict[str, Any]:
    """What a record says of a decision that a run has verified."""
    return {"found": found, "confirmed": is_confirmed(decision, found)}


def afterwards(result: RunResult) -> dict[str, float]:
    """By effect, the number of a run that has come to its end.

    plastic heating : largest rise of temperature by what is left to melting; without heating the mean rise that the
    plastic work would make. heat conduction : Fourier number of the time simulated. equation of state : largest mean
    pressure on the wall, on the section of the bar as it was, by K. bulk viscosity, wall friction : energy taken up, by
    the initial energy. damage : the largest. gravity : change of speed within the time simulated by that of the impact.
    inertia : initial energy by what is no longer kinetic.
    """
    scene, energies = result.scene, result.energies
    simulated = float(result.history.column("t")[-1]) / scene.end.limit(result.wall)
    asked = {each.effect: each.number for each in decisions(scene, result.wall)}
    taken_up = {"bulk viscosity": "viscosity", "wall friction": "friction"}
    has = {"bulk viscosity": scene.viscosity is not None, "wall friction": scene.friction > 0.0}
    found = {
        "plastic heating": _heating(result),
        "heat conduction": _scaled(asked["heat conduction"], simulated),
        "equation of state": _pressure(result),
        **{effect: energies[name] / energies["initial"] for effect, name in taken_up.items() if has[effect]},
        "damage": _damage(result),
        "gravity": _scaled(asked["gravity"], simulated),
        "inertia": energies["initial"] / max(energies["initial"] - energies["kinetic"], 1e-300),
    }
    return {effect: float(number) for effect, number in found.items() if number is not None}


def _scaled(number: float | None, factor: float) -> float | None:
    return None if number is None else number * factor


def _heating(result: RunResult) -> float | None:
    material, start = result.scene.material, result.scene.bar.temperature
    if material.specific_heat is None or material.melting is None:
        return None
    left = melting_temperature(material.melting, 1.0, 0.0) - start
    hottest = result.quantities["max_temperature"].value
    if material.heating is None or hottest is None:
        capacity = _mass(result) * heat_capacity(material.specific_heat, start)
        rise = HEATED * result.energies["plastic"] / capacity
    else:
        rise = hottest - start
    return rise / left if left > 0.0 else 0.0


def _pressure(result: RunResult) -> float:
    material = result.scene.material
    section = _mass(result) / (material.density * result.scene.bar.length)
    largest = float(abs(result.history.column("wall_force")).max())
    return largest / section / elastic_moduli(material.elasticity)[0]


def _mass(result: RunResult) -> float:
    """Of what is simulated: in three dimensions a quarter of the bar [kg]."""
    return 2.0 * result.energies["initial"] / result.scene.bar.velocity**2


def _damage(result: RunResult) -> float | None:
    damage = None if result.final is None else result.final.fields.get("damage")
    return None if damage is None else float(damage.max())
