"""The card schema of the flow laws that harden with strain and feel no rate."""

from core_models.flow.linear import LinearHardening
from core_models.flow.perfect import PerfectPlasticity
from core_models.flow.power_law import PowerLaw
from core_models.flow.tabulated import TabulatedHardening
from core_models.flow.thermal_voce import ThermalVoce
from core_models.flow.voce import Voce
from core_models.schema.entries import (
    ANY_NUMBER_OF,
    NOT_NEGATIVE,
    POSITIVE,
    Interval,
    ModelSchema,
    Parameter,
)

PERFECT = ModelSchema(
    types=("perfect", "perfect_plasticity"),
    law=PerfectPlasticity,
    help="constant yield stress",
    parameters=(Parameter("sigma_Y", "Pa", POSITIVE, "yield stress", feeds="yield_stress"),),
)

LINEAR = ModelSchema(
    types=("isotropic_hardening",),
    law=LinearHardening,
    help="linear isotropic hardening",
    parameters=(
        Parameter("sigma_Y", "Pa", POSITIVE, "initial yield stress", feeds="yield_stress"),
        Parameter("K", "Pa", NOT_NEGATIVE, "hardening modulus", feeds="hardening_modulus"),
    ),
)

POWER_LAW = ModelSchema(
    types=("power_law",),
    law=PowerLaw,
    help="sigma_0 (1 + ep/eps_0)^n",
    parameters=(
        Parameter("sigma_0", "Pa", POSITIVE, "initial yield stress", feeds="yield_stress"),
        Parameter("eps_0", "-", POSITIVE, "reference strain", feeds="reference_strain"),
        Parameter("n", "-", Interval(0.0, 1.0), "exponent", feeds="exponent"),
    ),
)

VOCE = ModelSchema(
    types=("voce",),
    law=Voce,
    help="saturating hardening with a linear term",
    parameters=(
        Parameter("sigma_0", "Pa", POSITIVE, "initial yield stress", feeds="yield_stress"),
        Parameter("sigma_inf", "Pa", POSITIVE, "saturation stress", feeds="saturation_stress"),
        Parameter("delta", "-", NOT_NEGATIVE, "rate of saturation", feeds="saturation_rate"),
        Parameter("H", "Pa", NOT_NEGATIVE, "modulus of the linear term", feeds="linear_modulus"),
    ),
)

THERMAL_VOCE = ModelSchema(
    types=("thermal_voce",),
    law=ThermalVoce,
    help="saturating hardening with a linear term, softened linearly by heat",
    parameters=(
        *VOCE.parameters,
        Parameter(
            "omega_0", "1/K", NOT_NEGATIVE, "softening of the initial yield stress", feeds="yield_softening"
        ),
        Parameter("omega_h", "1/K", NOT_NEGATIVE, "softening of the hardening", feeds="hardening_softening"),
        Parameter("T_0", "K", POSITIVE, "temperature of the constants", fallback="room_temp"),
    ),
)

TABULATED = ModelSchema(
    types=("tabulated",),
    law=TabulatedHardening,
    help="straight lines between the points of a table, constant beyond",
    parameters=(
        Parameter("strains", "-", NOT_NEGATIVE, "plastic strains, from 0 upwards", size=ANY_NUMBER_OF),
        Parameter("stresses", "Pa", POSITIVE, "flow stress at each of them", size=ANY_NUMBER_OF),
    ),
)
