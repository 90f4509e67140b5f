"""The card schema of all slots: which types fill them, and with which tags."""

from dataclasses import replace

from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.eos.spalling_mie_gruneisen import SpallingMieGruneisen
from core_models.expansion.isotropic import IsotropicExpansion
from core_models.heating.isentropic import IsentropicHeating
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.objective_rate.jaumann import Jaumann
from core_models.objective_rate.logarithmic import Logarithmic
from core_models.schema.damage import DAMAGE, EROSION
from core_models.schema.elasticity import ANISOTROPY
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
from core_models.schema.state_functions import MELTING, SHEAR_MODULUS, SPECIFIC_HEAT
from core_models.schema.yielding import KINEMATIC_HARDENING, YIELD_CONDITION
from core_models.stability.drucker import DruckerStability
from core_models.stability.hyperbolicity import HyperbolicityLoss
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.fibre_reinforced import FibreReinforced
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff

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
        ModelSchema(
            types=("fibre_reinforced",),
            law=FibreReinforced,
            help="elastic: compressible neo-Hookean matrix with a family of fibres that carry tension",
            parameters=(
                Parameter("k1", "Pa", POSITIVE, "stiffness of the fibres"),
                Parameter("k2", "-", NOT_NEGATIVE, "how fast they stiffen"),
                Parameter("fibre", "-", ANY, "direction of the fibres in the reference body", size=3),
            ),
        ),
        ModelSchema(
            types=("st_venant_kirchhoff",),
            law=StVenantKirchhoff,
            help="elastic: S = C : E, isotropic or with an <elasticity_model>, without equation of state",
        ),
    ),
    unavailable=(
        "comp_neo_hook",
        "comp_neo_hook_plastic",
        "UCNH",
        "comp_mooney_rivlin",
        "hypo_elastic",
        "rf_elastic_plastic",
        "visco_plastic",
        "trans_iso_hyper",
        "MohrCoulomb",
        "Arenisca3",
        "camclay",
        "soil_foam",
        "ideal_gas",
        "rigid",
    ),  # fmt: skip
)

OBJECTIVE_RATE = SlotSchema(
    slot="objective_rate",
    tags=("objective_rate",),
    places=("constitutive_model",),
    absent="green_naghdi",
    models=(
        ModelSchema(("logarithmic",), Logarithmic, "integrates to the Hencky strain; hypoelastic update"),
        ModelSchema(("jaumann",), Jaumann, "oscillates in shear: a negative control; hypoelastic update"),
    ),
    plain=("green_naghdi",),
)

PRESSURE_MODULUS = Parameter(
    "bulk_modulus", "Pa", POSITIVE, "bulk modulus of the pressure", fallback="bulk_modulus"
)

HUGONIOT = (
    Parameter("reference_density", "kg/m^3", POSITIVE, "density at rest", fallback="density"),
    Parameter("C_0", "m/s", POSITIVE, "bulk sound speed"),
    Parameter("Gamma_0", "-", NOT_NEGATIVE, "the full Grüneisen gamma"),
    Parameter("S_alpha", "-", NOT_NEGATIVE, "slope of the Hugoniot dU_s/du_p"),
)
CURVED_HUGONIOT = (
    Inert("S_2", ZERO, "a Hugoniot that is not a line"),
    Inert("S_3", ZERO, "a Hugoniot that is not a line"),
)

EOS = SlotSchema(
    slot="eos",
    tags=("equation_of_state",),
    places=("constitutive_model",),
    absent="default_hypo in the hypoelastic update, default_hyper in the hyperelastic one; none if anisotropic",
    models=(
        ModelSchema(("default_hypo",), DefaultHypoelastic, "p = K ln J", (PRESSURE_MODULUS,)),
        ModelSchema(("default_hyper", "neo_hookean"), NeoHookean, "p = K/2 (J - 1/J)", (PRESSURE_MODULUS,)),
        ModelSchema(
            types=("mie_gruneisen",),
            law=MieGruneisen,
            help="Mie-Grüneisen on a linear Hugoniot",
            parameters=HUGONIOT,
            inert=CURVED_HUGONIOT,
        ),
        ModelSchema(
            types=("mie_gruneisen_spall",),
            law=SpallingMieGruneisen,
            help="the same with its tension cut off",
            parameters=(
                *HUGONIOT,
                Parameter("spall_strength", "Pa", POSITIVE, "largest mean stress in tension"),
            ),
            inert=CURVED_HUGONIOT,
        ),
    ),
    unavailable=("mie_gruneisen_energy",),
)

HEATING = SlotSchema(
    slot="heating",
    tags=("heating_model",),
    places=("constitutive_model",),
    absent="taylor_quinney given a specific heat, a flow law and a law that feels the temperature",
    models=(
        ModelSchema(("taylor_quinney",), TaylorQuinney, "heat from plastic work", (HEATED_FRACTION,)),
        ModelSchema(
            types=("isentropic",),
            law=IsentropicHeating,
            help="heat from plastic work and from the change of volume; with mie_gruneisen",
            parameters=(replace(HEATED_FRACTION, range=Interval(0.0, 1.0)),),
        ),
    ),
    plain=("none",),
)

EXPANSION = SlotSchema(
    slot="expansion",
    tags=("thermal_expansion",),
    places=("constitutive_model",),
    absent="none",
    models=(
        ModelSchema(
            types=("isotropic",),
            law=IsotropicExpansion,
            help="as by a plain <coeff_thermal_expansion>; not with mie_gruneisen, whose energy has it",
            parameters=(
                Parameter("coefficient", "1/K", NOT_NEGATIVE, "coefficient of the length"),
                Parameter("T_0", "K", POSITIVE, "temperature without stress", fallback="room_temp"),
            ),
        ),
    ),
    plain=("none",),
)

STABILITY = SlotSchema(
    slot="stability",
    tags=("stability_check",),
    places=("constitutive_model",),
    absent="none",
    models=(
        ModelSchema(("drucker",), DruckerStability, "second-order work; reported, it does not act"),
        ModelSchema(
            ("acoustic", "becker"),
            HyperbolicityLoss,
            "determinant of the acoustic tensor; reported, it does not act",
        ),
    ),
    plain=("none",),
    unavailable=("drucker_becker",),
)

SLOTS = (
    UPDATE,
    ANISOTROPY,
    OBJECTIVE_RATE,
    EOS,
    FLOW,
    YIELD_CONDITION,
    HEATING,
    EXPANSION,
    DAMAGE,
    EROSION,
    SHEAR_MODULUS,
    MELTING,
    SPECIFIC_HEAT,
    KINEMATIC_HARDENING,
    STABILITY,
)
