"""Which laws fit together, as a table: what is not in it fits."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from core_models.damage.gurson import VoidNucleation
from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.damage.sandia import SandiaDamage
from core_models.elasticity.cubic import CubicElastic
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.elasticity.orthotropic import OrthotropicElastic
from core_models.elasticity.transversely_isotropic import TransverselyIsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.eos.spalling_mie_gruneisen import SpallingMieGruneisen
from core_models.heating.isentropic import IsentropicHeating
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.shear_modulus.nadal_le_poac import NadalLePoac
from core_models.shear_modulus.preston_tonks_wallace import PrestonShearModulus
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.fibre_reinforced import FibreReinforced
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises

PRESENT = (tuple,)  # any law
ABSENT = (type(None),)
SPLIT_UPDATES = (HypoelasticPlastic, HyperelasticPlastic)
WHOLE_UPDATES = (CompressibleNeoHookean, FibreReinforced, StVenantKirchhoff)
ANISOTROPIC = (CubicElastic, OrthotropicElastic, TransverselyIsotropicElastic)
SLOTS_OF_A_SPLIT = (
    "eos", "flow", "yield_condition", "shear_modulus", "kinematic_hardening", "damage", "melting", "heating",
    "stability", "erosion", "objective_rate", "expansion",
)  # fmt: skip
POROUS = (Gurson,)
PRESSURE_DEPENDENT = (DruckerPrager, MohrCoulomb)


class Clash(NamedTuple):
    """Two slots that do not go together when each holds a law of the given classes: why, and what would fit.

    updates : those with which it is so.
    """

    slot: str
    laws: tuple[type, ...]
    other: str
    others: tuple[type, ...]
    why: str
    remedy: str
    updates: tuple[type, ...] = PRESENT

    def holds(self, material: Any) -> bool:
        """Whether a material has both."""
        first, second = getattr(material, self.slot), getattr(material, self.other)
        has_both = isinstance(first, self.laws) and isinstance(second, self.others)
        return has_both and isinstance(material.update, self.updates)


CLASHES = (
    Clash(
        "update",
        (CompressibleNeoHookean, FibreReinforced),
        "elasticity",
        ANISOTROPIC,
        "an anisotropic stiffness is more than the bulk and the shear modulus that this update knows",
        "take the update st_venant_kirchhoff or hypoelastic_plastic, or give <bulk_modulus> and <shear_modulus>",
    ),
    Clash(
        "update",
        (HyperelasticPlastic,),
        "elasticity",
        ANISOTROPIC,
        "the elastic strain b_e of the hyperelastic update does not tell how the axes of the material have turned",
        "take the update hypoelastic_plastic, or st_venant_kirchhoff for a body that does not flow",
    ),
    *(
        Clash("elasticity", ANISOTROPIC, slot, laws, why, remedy, (HypoelasticPlastic,))
        for slot, laws, why, remedy in (
            (
                "eos", PRESENT, "an anisotropic stiffness gives the mean stress as well, which depends on shear too",
                "leave the equation of state out",
            ),
            (
                "shear_modulus", PRESENT, "an anisotropic stiffness has no single shear modulus",
                "leave shear_modulus out",
            ),
            (
                "yield_condition", (*PRESSURE_DEPENDENT, *POROUS),
                "the return to this surface takes shape and volume apart, which an anisotropic stiffness does not",
                "take vonMises, or give <bulk_modulus> and <shear_modulus>",
            ),
            (
                "damage", (VoidNucleation,),
                "the return of a porous body takes shape and volume apart, which an anisotropic stiffness does not",
                "take another damage law",
            ),
            (
                "objective_rate", PRESENT,
                "the axes of an anisotropic material turn with R of F = V R, and so must its stress",
                "leave objective_rate out: the rate is that of Green and Naghdi",
            ),
            (
                "expansion", PRESENT,
                "thermal expansion acts through the equation of state, which an anisotropic body has not",
                "leave the thermal expansion out",
            ),
        )
    ),
    *(
        Clash(
            "update",
            (whole,),
            slot,
            PRESENT,
            f"{whole.__name__} is elastic, and its stress needs no other law",
            f"leave {slot} out",
        )
        for whole in WHOLE_UPDATES
        for slot in SLOTS_OF_A_SPLIT
    ),
    Clash(
        "elasticity",
        (IsotropicElastic,),
        "eos",
        ABSENT,
        "the mean stress comes from an equation of state, so the material needs a law in the slot eos",
        "give one, such as mie_gruneisen",
        SPLIT_UPDATES,
    ),
    Clash(
        "update",
        (HyperelasticPlastic,),
        "eos",
        (DefaultHypoelastic,),
        "the hyperelastic update needs a stored energy, which default_hypo has not",
        "take neo_hookean or mie_gruneisen",
    ),
    Clash(
        "update",
        (HyperelasticPlastic,),
        "objective_rate",
        PRESENT,
        "the hyperelastic update integrates no rate",
        "leave objective_rate out, or take the hypoelastic update",
    ),
    Clash(
        "flow",
        PRESENT,
        "yield_condition",
        ABSENT,
        "a flow law and a yield condition go together",
        "give both (von Mises with any flow law) or neither",
    ),
    Clash(
        "yield_condition",
        PRESENT,
        "flow",
        ABSENT,
        "a flow law and a yield condition go together",
        "give both (von Mises with any flow law) or neither",
    ),
    Clash(
        "shear_modulus",
        (NadalLePoac, PrestonShearModulus),
        "melting",
        ABSENT,
        "the shear modulus falls with T / T_m",
        "add melt_temp or a melting law, or take mts_shear or scg_shear",
    ),
    Clash("heating", (TaylorQuinney,), "flow", ABSENT, "plastic heating needs a flow law", "leave heating out"),
    Clash(
        "heating", PRESENT, "specific_heat", ABSENT, "heating needs a specific heat",
        "add specific_heat or leave heating out",
    ),
    Clash(
        "heating", (IsentropicHeating,), "eos", (DefaultHypoelastic, NeoHookean, *ABSENT),
        "heating by volume change needs the Grüneisen gamma of an equation of state",
        "take mie_gruneisen, or the heating taylor_quinney",
    ),
    Clash(
        "heating", (IsentropicHeating,), "expansion", PRESENT,
        "heating by volume change goes with mie_gruneisen, which has the thermal pressure in its energy",
        "leave the thermal expansion out, or take the heating taylor_quinney",
    ),
    Clash(
        "expansion", PRESENT, "eos", (MieGruneisen, SpallingMieGruneisen),
        "mie_gruneisen has the thermal pressure in its energy",
        "leave the thermal expansion out",
    ),
    Clash(
        "kinematic_hardening", PRESENT, "damage", (VoidNucleation,),
        "a porous body has the back stress of its matrix, for which gurson has no law",
        "take vonMises or drucker_prager, or leave kinematic_hardening out",
    ),
    Clash(
        "kinematic_hardening", PRESENT, "yield_condition", POROUS,
        "a porous body has the back stress of its matrix, for which gurson has no law",
        "take vonMises or drucker_prager, or leave kinematic_hardening out",
    ),
    Clash(
        "kinematic_hardening", PRESENT, "yield_condition", (MohrCoulomb,),
        "back stresses grow along the flow of a round surface, and that on the planes of Mohr-Coulomb leads elsewhere",
        "take vonMises or drucker_prager, or leave kinematic_hardening out",
    ),
    Clash(
        "kinematic_hardening", PRESENT, "yield_condition", ABSENT,
        "back stresses move a yield surface, and there is none", "add a flow law or leave kinematic_hardening out",
    ),
    Clash(
        "yield_condition", POROUS, "damage", (JohnsonCookDamage, HancockMackenzieDamage, SandiaDamage, *ABSENT),
        "the porosity of the yield condition comes from its own damage law", "take the damage law gurson_voids",
    ),
    Clash(
        "damage", (VoidNucleation,), "yield_condition", (VonMises, *PRESSURE_DEPENDENT, *ABSENT),
        "these voids act through the yield condition", "take the yield condition gurson",
    ),
    Clash(
        "damage", PRESENT, "flow", ABSENT, "damage grows with plastic strain", "add a flow law or leave damage out"
    ),
    Clash(
        "erosion", PRESENT, "damage", ABSENT, "erosion acts on failed points", "add a damage law or leave erosion out"
    ),
)  # fmt: skip


def clashes(material: Any) -> Iterator[Clash]:
    """The rows of the table that a material runs into."""
    return (clash for clash in CLASHES if clash.holds(material))


def clash_of(
    slot: str, law: type, other: str, other_law: type, update: type = HypoelasticPlastic
) -> Clash | None:
    """The row for two laws in an update, by class (type(None) for an empty slot); None if they fit."""
    for clash in CLASHES:
        if not issubclass(update, clash.updates):
            continue
        for first, second in (((slot, law), (other, other_law)), ((other, other_law), (slot, law))):
            if (
                (clash.slot, clash.other) == (first[0], second[0])
                and issubclass(first[1], clash.laws)
                and issubclass(second[1], clash.others)
            ):
                return clash
    return None
