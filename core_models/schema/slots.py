"""The card schema of all slots: which types fill them, and with which tags."""

from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.schema.damage import DAMAGE, EROSION
from core_models.schema.entries import NOT_NEGATIVE, POSITIVE, ZERO, Inert, ModelSchema, Parameter, SlotSchema
from core_models.schema.flow import FLOW
from core_models.schema.quantities import HEATED_FRACTION, TOLERANCE
from core_models.schema.state_functions import MELTING, SHEAR_MODULUS, SPECIFIC_HEAT
from core_models.schema.yielding import KINEMATIC_HARDENING, YIELD_CONDITION
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic

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

HEATING = SlotSchema(
    slot="heating",
    tags=("heating_model",),
    places=("constitutive_model",),
    absent="taylor_quinney given a specific heat, a flow law and a law that feels the temperature",
    models=(ModelSchema(("taylor_quinney",), TaylorQuinney, "heat from plastic work", (HEATED_FRACTION,)),),
    plain=("none",),
)

STABILITY = SlotSchema(
    slot="stability",
    tags=("stability_check",),
    places=("constitutive_model",),
    absent="none",
    plain=("none",),
    unavailable=("drucker", "becker", "drucker_becker", "acoustic"),
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
