"""The card schema of the slots other than flow: which types fill them, and with which tags."""

from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.erosion.no_shear import AllowNoShear
from core_models.erosion.no_tension import AllowNoTension
from core_models.erosion.zero_stress import ZeroStress
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.schema.entries import (
    ANY,
    NOT_NEGATIVE,
    POSITIVE,
    ZERO,
    Inert,
    Interval,
    ModelSchema,
    Parameter,
    SlotSchema,
)
from core_models.schema.flow import FLOW
from core_models.schema.quantities import HEATED_FRACTION, TOLERANCE
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises

UPDATE = SlotSchema(
    slot="update",
    tags=("constitutive_model",),
    places=("material",),
    absent="",
    models=(
        ModelSchema(
            types=("hypoelastic_plastic", "elastic_plastic", "elastic_plastic_hp"),
            law=HypoelasticPlastic,
            help="additive split of the rate of deformation, Green-Naghdi rate",
            parameters=(TOLERANCE,),
        ),
        ModelSchema(
            types=("hyperelastic_plastic",),
            law=HyperelasticPlastic,
            help="multiplicative split, Simo-Hughes return mapping",
            parameters=(TOLERANCE,),
        ),
        ModelSchema(
            types=("compressible_neo_hookean", "cnh_mms"),
            law=CompressibleNeoHookean,
            help="elastic: [G (b - 1) + (K - 2 G / 3) ln J 1] / J, without equation of state",
        ),
    ),
    unavailable=("comp_neo_hook", "comp_neo_hook_plastic", "UCNH", "hypo_elastic", "visco_plastic", "rigid"),
)

PRESSURE_MODULUS = Parameter(
    "bulk_modulus", "Pa", POSITIVE, "bulk modulus of the pressure", fallback="bulk_modulus"
)

EOS = SlotSchema(
    slot="eos",
    tags=("equation_of_state",),
    places=("constitutive_model",),
    absent="default_hypo in the hypoelastic update, default_hyper in the hyperelastic one",
    models=(
        ModelSchema(("default_hypo",), DefaultHypoelastic, "p = K ln J", (PRESSURE_MODULUS,)),
        ModelSchema(("default_hyper", "neo_hookean"), NeoHookean, "p = K/2 (J - 1/J)", (PRESSURE_MODULUS,)),
        ModelSchema(
            types=("mie_gruneisen",),
            law=MieGruneisen,
            help="Mie-Grüneisen on a linear Hugoniot",
            parameters=(
                Parameter("reference_density", "kg/m^3", POSITIVE, "density at rest", fallback="density"),
                Parameter("C_0", "m/s", POSITIVE, "bulk sound speed"),
                Parameter("Gamma_0", "-", NOT_NEGATIVE, "the full Grüneisen gamma"),
                Parameter("S_alpha", "-", NOT_NEGATIVE, "slope of the Hugoniot dU_s/du_p"),
            ),
            inert=(
                Inert("S_2", ZERO, "a Hugoniot that is not a line"),
                Inert("S_3", ZERO, "a Hugoniot that is not a line"),
            ),
        ),
    ),
    unavailable=("mie_gruneisen_energy",),
)

YIELD_CONDITION = SlotSchema(
    slot="yield_condition",
    tags=("yield_condition",),
    places=("constitutive_model",),
    absent="vonMises where there is a flow law",
    models=(ModelSchema(("vonMises",), VonMises, "q = sqrt(3/2 s:s) <= flow stress"),),
    plain=("none",),
    unavailable=("gurson", "rousselier"),
)

HEATING = SlotSchema(
    slot="heating",
    tags=("heating_model",),
    places=("constitutive_model",),
    absent="taylor_quinney given a specific heat, a flow law and a law that feels the temperature",
    models=(ModelSchema(("taylor_quinney",), TaylorQuinney, "heat from plastic work", (HEATED_FRACTION,)),),
    plain=("none",),
)

DAMAGE = SlotSchema(
    slot="damage",
    tags=("damage_model",),
    places=("constitutive_model", "material"),
    absent="none",
    models=(
        ModelSchema(
            types=("johnson_cook",),
            law=JohnsonCookDamage,
            help="failure strain of triaxiality, rate and temperature; acts only with an erosion algorithm",
            parameters=(
                *(Parameter(f"D{i}", "-", ANY, f"failure strain constant {i}") for i in range(1, 6)),
                Parameter("T_r", "K", NOT_NEGATIVE, "temperature where T* is 0", fallback="room_temp"),
                Parameter("T_m", "K", POSITIVE, "temperature where T* is 1", fallback="melt_temp"),
            ),
            inert=(
                Inert("initial_mean_scalar_damage", ZERO, "initial damage"),
                Inert("initial_std_scalar_damage", ZERO, "scattered initial damage"),
            ),
            ascending=(("T_r", "T_m"),),
        ),
    ),
    plain=("none",),
    unavailable=("hancock_mackenzie", "Threshold", "ThresholdVar", "Brittle"),
)

EROSION = SlotSchema(
    slot="erosion",
    tags=("erosion",),
    places=("material", "constitutive_model"),
    absent="none",
    models=tuple(
        ModelSchema(
            types=(name,),
            law=law,
            help=help,
            inert=(Inert("char_time", Interval(0.0, 1e-90), "stress that decays in time"),),
        )
        for name, law, help in (
            ("ZeroStress", ZeroStress, "a point whose damage has reached 1 carries no stress"),
            ("AllowNoTension", AllowNoTension, "such a point carries pressure in compression only"),
            ("AllowNoShear", AllowNoShear, "such a point carries pressure only"),
        )
    ),
    plain=("none",),
    unavailable=("PreserveStress", "RemoveMass"),
    attribute="algorithm",
)


def _constant_only(slot: str, tag: str, plain: str, *unavailable: str) -> SlotSchema:
    return SlotSchema(slot, (tag,), ("constitutive_model",), plain, plain=(plain,), unavailable=unavailable)


SHEAR_MODULUS = _constant_only(
    "shear_modulus",
    "shear_modulus_model",
    "constant_shear",
    "mts_shear",
    "np_shear",
    "ptw_shear",
    "scg_shear",
)
MELTING = _constant_only("melting", "melting_temp_model", "constant_Tm", "linear_Tm", "scg_Tm", "bps_Tm")
SPECIFIC_HEAT = _constant_only(
    "specific_heat", "specific_heat_model", "constant_Cp", "copper_Cp", "steel_Cp", "cubic_Cp"
)
KINEMATIC_HARDENING = _constant_only(
    "kinematic_hardening",
    "kinematic_hardening_model",
    "none",
    "prager_hardening",
    "armstrong_frederick_hardening",
    "ziegler_hardening",
)
STABILITY = _constant_only(
    "stability", "stability_check", "none", "drucker", "becker", "drucker_becker", "acoustic"
)

SLOTS = (
    UPDATE,
    EOS,
    FLOW,
    YIELD_CONDITION,
    HEATING,
    DAMAGE,
    EROSION,
    SHEAR_MODULUS,
    MELTING,
    SPECIFIC_HEAT,
    KINEMATIC_HARDENING,
    STABILITY,
)
