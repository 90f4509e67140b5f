"""A material: one law per slot, and which slots fit together."""

import logging
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from core_models.compatibility import ANISOTROPIC, WHOLE_UPDATES
from core_models.effects import Effect, material_effects
from core_models.errors import MaterialError
from core_models.laws import (
    back_stress_constants,
    damage_increment,
    elastic_moduli,
    eroded_stress,
    flow_stress,
    heat_capacity,
    heated_fraction,
    melting_temperature,
    pressure,
    shear_modulus,
    shear_stiffness,
    stability_measure,
    thermal_volume,
)
from core_models.material_checks import cautions, complaints
from core_models.model import Model
from core_models.updates.anisotropic_plastic import AnisotropicPlastic
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.corotation import corotated
from core_models.updates.fibre_reinforced import FibreReinforced
from core_models.updates.general import General
from core_models.updates.general_problem import return_stress
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.interface import advance_rows
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff
from core_models.yield_condition.interface import return_to_surface
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
    "expansion": thermal_volume,
    "stability": stability_measure,
    "erosion": eroded_stress,
    "objective_rate": corotated,
}
REQUIRED_SLOTS = ("update", "elasticity")

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Material:
    """A material: density and one law per slot; `None` is an absent effect.

    Parameters
    ----------
    name : for messages and reports. density : reference density rho_0 [kg/m^3].
    update : HypoelasticPlastic or HyperelasticPlastic; CompressibleNeoHookean, FibreReinforced
    and StVenantKirchhoff take nothing but an elasticity.
    elasticity : isotropic; anisotropic with HypoelasticPlastic and StVenantKirchhoff.
    The other slots : laws of core_models.<slot>; all may be left out, but for the eos of a HypoelasticPlastic or
    HyperelasticPlastic body whose elasticity is isotropic.
    room_temperature : initial temperature unless a body gives its own [K].
    thermal_conductivity : k [W/(m K)], > 0, or None.
    damage_radius : of the neighbourhood over which the growth of damage is averaged [m], > 0; None: local damage.
    origins : file and line of each slot in the card that the material comes from, for messages.

    Raises
    ------
    MaterialError : a law in the wrong slot, numbers out of their ranges, or laws that make no sense together
    (core_models.compatibility).
    """

    name: str
    density: float
    update: (
        HypoelasticPlastic
        | HyperelasticPlastic
        | CompressibleNeoHookean
        | FibreReinforced
        | StVenantKirchhoff
    )
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
    expansion: Any = None
    stability: Any = None
    erosion: Any = None
    objective_rate: Any = None
    room_temperature: float = 294.0
    thermal_conductivity: float | None = None
    damage_radius: float | None = None
    origins: Mapping[str, str] = field(default_factory=dict, compare=False, repr=False)

    def __post_init__(self) -> None:
        self.check_slots()
        self.check_combination()

    def check_slots(self) -> None:
        """Refuse a law in a slot whose generic function it does not implement."""
        for slot in SLOTS:
            law, classes = getattr(self, slot), laws_for(slot)
            if law is not None and type(law) not in classes:
                known = ", ".join(sorted(known.__name__ for known in classes))
                raise self.error(
                    slot, f"{type(law).__name__} is no law for the slot {slot}: use one of {known}"
                )
        for slot in REQUIRED_SLOTS:
            if getattr(self, slot) is None:
                raise self.error(slot, f"a material needs a law in the slot {slot}")

    def check_combination(self) -> None:
        """Refuse numbers and combinations that make no sense, log what should be known."""
        for slot, text in complaints(self):
            raise self.error(slot, text)
        for slot, text in cautions(self):
            log.warning("%s: %s", self.place(slot), text)

    def place(self, slot: str) -> str:
        """Where the law of a slot stands: file and line of the card, and the material's name."""
        origin = self.origins.get(slot, self.origins.get("update"))
        return self.name if origin is None else f"{origin}: {self.name}"

    def error(self, slot: str, text: str) -> MaterialError:
        """The error that names the place of a slot."""
        return MaterialError(f"{self.place(slot)}: {text}")

    @property
    def model(self) -> Model:
        """The laws as compiled code sees them."""
        model = Model(*(getattr(self, name) for name in Model._fields))
        if has_anisotropic_return(self):
            return model._replace(update=AnisotropicPlastic(self.update, self.update.tolerance))
        if has_general_return(self):
            return model._replace(update=General(self.update, self.update.tolerance))
        return model

    @property
    def laws(self) -> tuple:
        """All laws that are present."""
        given = (getattr(self, name) for name in Model._fields)
        return tuple(law for law in given if isinstance(law, tuple))

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
    if isinstance(material.update, WHOLE_UPDATES):
        return False
    other = type(material.yield_condition) in return_stress.implementations.keys() - {VonMises}
    return other or material.kinematic_hardening is not None


def has_anisotropic_return(material: Material) -> bool:
    """Whether the elastic trial needs a whole stiffness and its axes."""
    return isinstance(material.update, HypoelasticPlastic) and isinstance(material.elasticity, ANISOTROPIC)


def laws_for(slot: str) -> set[type]:
    """The classes of laws that a slot takes, apart from those that only the points make."""
    known = set(SLOTS[slot].implementations)
    if slot == "yield_condition":
        known |= set(return_stress.implementations)
    return {law for law in known - {type(None)} if not getattr(law, "is_internal", False)}
