"""What is wrong with a material, and what should be known about it."""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from core_models.compatibility import clashes
from core_models.damage.gurson import VoidNucleation
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.spalling_mie_gruneisen import SpallingMieGruneisen
from core_models.flow.johnson_cook import JohnsonCook
from core_models.laws import (
    damage_of_porosity,
    elastic_moduli,
    evolve_hardening,
    flow_stress,
    melting_temperature,
    under_pressure,
)
from core_models.schema.checking import fault_of
from core_models.yield_condition.gurson import Gurson

LARGEST_MODULUS_GAP = 0.2  # between the card's moduli and those that the other laws have at rest
STRAINS = (0.0, 1e-3, 1e-2, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0)  # plastic strains where softening is looked for
UNREGULARISED = "nothing regularises the softening, so that results depend on the resolution"
SMALLEST_FALL = 1e-9  # of the flow stress, below which a slope is round-off


class Remark(NamedTuple):
    """A sentence about the law in a slot."""

    slot: str
    text: str


def complaints(m: Any) -> Iterator[Remark]:
    """What makes a material impossible: each names the problem and the remedy. The slots hold laws of their kind."""
    yield from _number_faults(m)
    yield from (Remark(clash.slot, f"{clash.why}: {clash.remedy}") for clash in clashes(m))
    yield from _constants(m)
    if m.eos is not None:
        yield from _stiffness(m)
    yield from _temperatures(m)
    if m.flow is not None:
        yield from _strength(m)
    if isinstance(m.yield_condition, Gurson) and isinstance(m.damage, VoidNucleation):
        yield from _voids(m)


def cautions(m: Any) -> Iterator[Remark]:
    """What is allowed and should be known."""
    for slot in m.model._fields:
        law = getattr(m, slot)
        told = law.caution() if hasattr(law, "caution") else ""
        if told:
            yield Remark(slot, told)
    if getattr(m.damage, "coupling", 0.0) > 0.0 and m.damage_radius is None:
        yield Remark("damage", f"damage weakens the flow stress: {UNREGULARISED}")
    if isinstance(m.damage, VoidNucleation) and m.damage_radius is None:
        yield Remark("damage", f"growing voids weaken the body: {UNREGULARISED}; give damage_radius")
    strain = _softening_strain(m) if m.flow is not None else math.inf
    if strain < math.inf:
        yield Remark(
            "flow",
            f"the flow stress falls with plastic strain from {strain:g} on: {UNREGULARISED}",
        )


def _number_faults(m: Any) -> Iterator[Remark]:
    for slot in m.model._fields:
        law = getattr(m, slot)
        fault = fault_of(slot, law) if isinstance(law, tuple) else ""
        if fault:
            yield Remark(slot, f"{type(law).__name__}: {fault}")


def _constants(m: Any) -> Iterator[Remark]:
    if not m.density > 0.0:
        yield Remark("update", f"density must be positive, not {m.density!r} kg/m^3")
    if m.thermal_conductivity is not None and not m.thermal_conductivity > 0.0:
        yield Remark(
            "update",
            f"thermal_conductivity must be positive, not {m.thermal_conductivity!r} W/(m K): leave it out if unknown",
        )
    if m.damage_radius is not None and not m.damage_radius > 0.0:
        yield Remark(
            "damage",
            f"damage_radius must be positive, not {m.damage_radius!r} m: leave it out for local damage",
        )
    if m.damage_radius is not None and m.damage is None:
        yield Remark(
            "damage", "damage_radius averages damage, and there is none: add a damage law or leave it out"
        )


def _stiffness(m: Any) -> Iterator[Remark]:
    bulk, shear = elastic_moduli(m.elasticity)
    if isinstance(m.eos, MieGruneisen | SpallingMieGruneisen):
        stiffness = m.eos.reference_density * m.eos.C_0**2
        if m.eos.reference_density != m.density:
            yield Remark(
                "eos",
                f"the equation of state has reference density {m.eos.reference_density!r}, the material {m.density!r}",
            )
        if abs(stiffness - bulk) > LARGEST_MODULUS_GAP * bulk:
            yield Remark(
                "eos",
                f"rho_0 C_0^2 = {stiffness:.4g} Pa and the bulk modulus {bulk:.4g} Pa differ by more than "
                f"{LARGEST_MODULUS_GAP:.0%}: they describe the same stiffness, correct one of them",
            )
    resting = m.shear_at_rest(m.room_temperature)
    if abs(resting - shear) > LARGEST_MODULUS_GAP * shear:
        yield Remark(
            "shear_modulus",
            f"{type(m.shear_modulus).__name__} gives {resting:.4g} Pa at room temperature, the card's shear modulus is "
            f"{shear:.4g} Pa: they describe the same stiffness, correct one of them",
        )


def _temperatures(m: Any) -> Iterator[Remark]:
    melting = float(melting_temperature(m.melting))
    if m.melting is not None and not melting > m.room_temperature:
        yield Remark("melting", f"melt_temp {melting!r} K must lie above room_temp {m.room_temperature!r} K")
    if isinstance(m.flow, JohnsonCook) and m.melting is not None and m.flow.T_m > melting:
        yield Remark(
            "flow",
            f"Johnson-Cook T_m = {m.flow.T_m!r} K lies above melt_temp = {melting!r} K: the point would melt first",
        )


def _strength(m: Any) -> Iterator[Remark]:
    shear = m.shear_at_rest(m.room_temperature)
    start = _strength_at(m, 0.0)[0]
    if not 0.0 <= start < shear:
        yield Remark(
            "flow",
            f"the initial flow stress {start:.4g} Pa must lie between 0 and the shear modulus {shear:.4g} Pa",
        )
    if start > 0.0:
        for strain in STRAINS:
            stress = _strength_at(m, strain)[0]
            if not stress > 0.0:
                yield Remark(
                    "flow",
                    f"the yield surface shrinks to nothing: the flow stress is {stress:.4g} Pa at a plastic strain of "
                    f"{strain:g}: let it soften to a stress above 0",
                )
                return


def _voids(m: Any) -> Iterator[Remark]:
    start = m.damage.initial_porosity
    if damage_of_porosity(m.yield_condition, start, 0.0) >= 1.0:
        yield Remark(
            "damage",
            f"the yield surface has shrunk to nothing at the initial porosity {start:g}: give less, with k = "
            f"{m.yield_condition.k:g} and f_c = {m.yield_condition.f_c:g} usually below f_c",
        )


def _strength_at(m: Any, strain: float) -> tuple[float, float]:
    """Flow stress [Pa] at room temperature and no rate, and its slope in the plastic strain [Pa]."""
    variable = getattr(m.flow, "hardening_variable", 0.0)
    flow = under_pressure(m.flow, 1.0, 0.0, melting_temperature(m.melting))
    stress, by_variable, by_strain = flow_stress(flow, variable, strain, 0.0, m.room_temperature)[:3]
    evolution = evolve_hardening(flow, variable, 0.0, 0.0, m.room_temperature)[1] if by_variable else 0.0
    return stress, by_strain + by_variable * evolution


def _softening_strain(m: Any) -> float:
    """The smallest of STRAINS where the flow stress falls; infinite if it falls nowhere."""
    for strain in STRAINS:
        stress, slope = _strength_at(m, strain)
        if slope < -SMALLEST_FALL * stress:
            return strain
    return math.inf
