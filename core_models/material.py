"""A material: one law per slot, and which slots fit together."""

from dataclasses import dataclass, fields
from typing import Any

from core_models.effects import Effect, material_effects
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.errors import MaterialError
from core_models.flow.johnson_cook import JohnsonCook
from core_models.laws import (
    advance_rows,
    back_stress_constants,
    damage_increment,
    elastic_moduli,
    eroded_stress,
    flow_stress,
    heat_capacity,
    heated_fraction,
    melting_temperature,
    pressure,
    return_to_surface,
    shear_modulus,
    shear_stiffness,
    under_pressure,
)
from core_models.model import Model
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.general import General
from core_models.updates.general_problem import return_stress
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises

SLOTS = {
    "update": advance_rows,
    "elasticity": elastic_moduli,
    "eos": pressure,
    "flow": flow_stress,
    "yield_condition": return_to_surface,
    "kinematic_hardening": back_stress_constants,
    "damage": damage_increment,
    "shear_modulus": shear_modulus,
    "melting": melting_temperature,
    "specific_heat": heat_capacity,
    "heating": heated_fraction,
    "erosion": eroded_stress,
}
EMPTY_SLOTS = ("stability",)
PLASTIC_SLOTS = (
    "eos", "flow", "yield_condition", "kinematic_hardening", "shear_modulus", "damage", "melting", "heating", "erosion",
)  # fmt: skip
LARGEST_MODULUS_GAP = 0.2  # between the card's moduli and those that the other laws have at rest


@dataclass(frozen=True)
class Material:
    """A material: density and one law per slot; `None` is an absent effect.

    Parameters
    ----------
    name : for messages and reports. density : reference density rho_0 [kg/m^3].
    update : HypoelasticPlastic, HyperelasticPlastic, or CompressibleNeoHookean, which takes nothing but an elasticity.
    The other slots : laws of core_models.<slot>; all but eos and elasticity may be left out.
    room_temperature : initial temperature unless a body gives its own [K].
    thermal_conductivity : k [W/(m K)], > 0, or None.

    Raises
    ------
    MaterialError : a law in the wrong slot, or laws that make no sense together.
    """

    name: str
    density: float
    update: HypoelasticPlastic | HyperelasticPlastic | CompressibleNeoHookean
    elasticity: Any
    eos: Any = None
    flow: Any = None
    yield_condition: Any = None
    shear_modulus: Any = None
    kinematic_hardening: Any = None
    damage: Any = None
    melting: Any = None
    specific_heat: Any = None
    heating: Any = None
    stability: Any = None
    erosion: Any = None
    room_temperature: float = 294.0
    thermal_conductivity: float | None = None

    def __post_init__(self) -> None:
        check_slots(self)
        check_combination(self)

    @property
    def model(self) -> Model:
        """The laws as compiled code sees them."""
        model = Model(*(getattr(self, name) for name in Model._fields))
        return (
            model._replace(update=General(self.update, self.update.tolerance))
            if has_general_return(self)
            else model
        )

    @property
    def laws(self) -> tuple:
        """All laws that are present."""
        return tuple(law for law in self.model if isinstance(law, tuple))

    def uses(self, need: str) -> bool:
        """Whether any law states the need `uses_temperature` or `uses_energy`."""
        return any(getattr(law, need, False) for law in self.laws)

    @property
    def needs_temperature(self) -> bool:
        """Whether points carry a temperature."""
        return self.uses("uses_temperature") or self.melting is not None or self.heating is not None

    def shear_at_rest(self, temperature: float) -> float:
        """Shear modulus [Pa] at a temperature [K], without stress."""
        melting = melting_temperature(self.melting)
        return shear_stiffness(self.shear_modulus, self.elasticity, 1.0, temperature, 0.0, melting)

    def effects(self) -> list[Effect]:
        """Which effects this material brings into a simulation, and why the others are absent."""
        return material_effects(self)


def has_general_return(material: Material) -> bool:
    """Whether the laws need more than the scalar radial return."""
    other = type(material.yield_condition) in return_stress.implementations.keys() - {VonMises}
    return other or material.kinematic_hardening is not None


def laws_for(slot: str) -> dict:
    """The classes of laws that a slot takes."""
    known = SLOTS[slot].implementations
    return known | return_stress.implementations if slot == "yield_condition" else known


def check_slots(material: Material) -> None:
    """Refuse a law in a slot whose generic function it does not implement."""
    for field in fields(material):
        value = getattr(material, field.name)
        if field.name in EMPTY_SLOTS and value is not None:
            raise MaterialError(
                f"{material.name}: the slot {field.name} takes no law yet ({type(value).__name__} given): leave it out"
            )
        if field.name in SLOTS and type(value) not in laws_for(field.name) and value is not None:
            known = ", ".join(sorted(c.__name__ for c in laws_for(field.name) if c is not type(None)))
            raise MaterialError(
                f"{material.name}: {type(value).__name__} is no law for the slot {field.name}: use one of {known}"
            )
    required = ("update", "elasticity") if is_whole(material) else ("update", "elasticity", "eos")
    for slot in required:
        if getattr(material, slot) is None:
            raise MaterialError(f"{material.name}: a material needs a law in the slot {slot}")


def is_whole(material: Material) -> bool:
    """Whether the stress follows from the deformation alone, so that no other law has a say in it."""
    return isinstance(material.update, CompressibleNeoHookean)


def check_combination(material: Material) -> None:
    """Refuse combinations of laws and parameters that make no sense together."""
    for wrong, remedy in _complaints(material):
        if wrong:
            raise MaterialError(f"{material.name}: {remedy}")


def feels_rate(m: Material) -> bool:
    """Whether the flow stress depends on the strain rate or on a history of its own."""
    if hasattr(m.flow, "hardening_variable"):
        return True
    return flow_stress(m.flow, 0.0, 0.01, 10.0, m.room_temperature)[3] != 0.0


def _complaints(m: Material):
    bulk, shear = elastic_moduli(m.elasticity)
    melting = melting_temperature(m.melting)
    yield (not m.density > 0.0, f"density must be positive, not {m.density!r} kg/m^3")
    yield (
        not (bulk > 0.0 and shear > 0.0),
        f"bulk and shear modulus must be positive, not {bulk!r} and {shear!r} Pa",
    )
    yield (
        m.thermal_conductivity is not None and not m.thermal_conductivity > 0.0,
        f"thermal_conductivity must be positive, not {m.thermal_conductivity!r} W/(m K): leave it out if unknown",
    )
    resting = m.shear_at_rest(m.room_temperature)
    yield (
        abs(resting - shear) > LARGEST_MODULUS_GAP * shear,
        f"{type(m.shear_modulus).__name__} gives {resting:.4g} Pa at room temperature and the card's shear modulus is "
        f"{shear:.4g} Pa: they describe the same stiffness, correct one of them",
    )
    for slot in PLASTIC_SLOTS:
        yield (
            is_whole(m) and getattr(m, slot) is not None,
            f"{type(m.update).__name__} is elastic, and its stress needs no other law: leave {slot} out",
        )
    yield (
        isinstance(m.update, HyperelasticPlastic) and isinstance(m.eos, DefaultHypoelastic),
        "the hyperelastic update needs a stored energy, which default_hypo has not: take neo_hookean or mie_gruneisen",
    )
    yield (
        (m.flow is None) != (m.yield_condition is None),
        "a flow law and a yield condition go together: give both (von Mises with any flow law here) or neither",
    )
    yield (
        m.kinematic_hardening is not None and not isinstance(m.yield_condition, VonMises),
        f"{type(m.kinematic_hardening).__name__} moves the surface of von Mises, not of "
        f"{type(m.yield_condition).__name__}: take VonMises or leave kinematic_hardening out",
    )
    yield (
        getattr(m.yield_condition, "needs_rate_free_flow", False) and m.flow is not None and feels_rate(m),
        f"{type(m.yield_condition).__name__} takes a strength that feels no strain rate, not {type(m.flow).__name__}: "
        "take PerfectPlasticity, LinearHardening, PowerLaw, Voce, ThermalVoce or TabulatedHardening",
    )
    if isinstance(m.eos, MieGruneisen):
        stiffness = m.eos.reference_density * m.eos.C_0**2
        yield (
            m.eos.reference_density != m.density,
            f"the equation of state has reference density {m.eos.reference_density!r}, the material {m.density!r}",
        )
        yield (
            abs(stiffness - bulk) > LARGEST_MODULUS_GAP * bulk,
            f"rho_0 C_0^2 = {stiffness:.4g} Pa and the bulk modulus {bulk:.4g} Pa differ by more than "
            f"{LARGEST_MODULUS_GAP:.0%}: they describe the same stiffness, correct one of them",
        )
    yield (
        m.heating is not None and (m.specific_heat is None or m.flow is None),
        "plastic heating needs a flow law and a specific heat: add specific_heat or leave heating out",
    )
    yield (
        m.damage is not None and m.flow is None,
        "damage grows with plastic strain: add a flow law or leave damage out",
    )
    yield (
        m.erosion is not None and m.damage is None,
        "erosion acts on failed points: add a damage law or leave erosion out",
    )
    yield (
        m.melting is not None and not melting > m.room_temperature,
        f"melt_temp {melting!r} K must lie above room_temp {m.room_temperature!r} K",
    )
    for law in (m.flow, m.damage):
        if hasattr(law, "T_m") and hasattr(law, "T_r"):
            yield (
                not law.T_m > law.T_r,
                f"{type(law).__name__}: melting temperature T_m = {law.T_m!r} K must lie above T_r = {law.T_r!r} K",
            )
    if isinstance(m.flow, JohnsonCook) and m.melting is not None:
        yield (
            m.flow.T_m > melting,
            f"Johnson-Cook T_m = {m.flow.T_m!r} K lies above melt_temp = {melting!r} K: the point would melt first",
        )
    if m.flow is not None:
        variable = getattr(m.flow, "hardening_variable", 0.0)
        flow = under_pressure(m.flow, 1.0, 0.0, melting)
        start = flow_stress(flow, variable, 0.0, 0.0, m.room_temperature)[0]
        yield (
            not 0.0 <= start < resting,
            f"the initial flow stress {start:.4g} Pa must lie between 0 and the shear modulus {resting:.4g} Pa",
        )
