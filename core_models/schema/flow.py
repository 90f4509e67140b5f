"""The card schema of the flow laws."""

from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.perfect import PerfectPlasticity
from core_models.flow.power_law import PowerLaw
from core_models.flow.voce import Voce
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

JOHNSON_COOK = ModelSchema(
    types=("johnson_cook",),
    law=JohnsonCook,
    help="strain hardening x logarithm of the plastic rate x thermal softening",
    parameters=(
        Parameter("A", "Pa", POSITIVE, "initial yield stress at the reference rate and T_r"),
        Parameter("B", "Pa", NOT_NEGATIVE, "hardening coefficient"),
        Parameter("C", "-", NOT_NEGATIVE, "rate coefficient"),
        Parameter("n", "-", POSITIVE, "hardening exponent"),
        Parameter("m", "-", POSITIVE, "softening exponent"),
        Parameter("epdot_0", "1/s", POSITIVE, "reference plastic rate", default=1.0),
        Parameter("T_r", "K", NOT_NEGATIVE, "temperature where softening begins", fallback="room_temp"),
        Parameter("T_m", "K", POSITIVE, "temperature of no strength", fallback="melt_temp"),
    ),
    ascending=(("T_r", "T_m"),),
)

MTS = ModelSchema(
    types=("mts_model",),
    law=MechanicalThreshold,
    help="mechanical threshold stress as a history variable",
    parameters=(
        Parameter("sigma_a", "Pa", NOT_NEGATIVE, "athermal stress", aliases=("s_a",)),
        Parameter("koverbcubed", "Pa/K", POSITIVE, "Boltzmann constant over Burgers vector cubed"),
        Parameter("edot_0e", "1/s", POSITIVE, "reference rate of thermal activation", aliases=("edot0",)),
        Parameter("g_0e", "-", POSITIVE, "normalised activation energy", aliases=("g0",)),
        Parameter("q_e", "-", POSITIVE, "outer exponent of the barrier", aliases=("q",)),
        Parameter("p_e", "-", POSITIVE, "inner exponent of the barrier", aliases=("p",)),
        Parameter("alpha", "-", POSITIVE, "shape of the saturation function"),
        Parameter("edot_es0", "1/s", POSITIVE, "reference rate of saturation", aliases=("edot_s0",)),
        Parameter("g_0es", "-", POSITIVE, "normalised saturation energy", aliases=("A",)),
        Parameter("sigma_es0", "Pa", POSITIVE, "saturation threshold stress at 0 K", aliases=("s_s0",)),
        Parameter("a_0", "Pa", ANY, "hardening rate: constant term", aliases=("a0",)),
        Parameter("a_1", "Pa", ANY, "hardening rate: factor of ln(rate)", aliases=("a1",)),
        Parameter("a_2", "Pa s^0.5", ANY, "hardening rate: factor of sqrt(rate)", aliases=("a2",)),
        Parameter("a_3", "Pa/K", ANY, "hardening rate: fall with temperature", aliases=("a3",), default=0.0),
        Parameter("theta_IV", "Pa", NOT_NEGATIVE, "stage IV hardening rate", default=0.0),
        Parameter("b1", "Pa", POSITIVE, "0 K shear modulus of mu(T)", fallback="mu_0"),
        Parameter("b2", "Pa", NOT_NEGATIVE, "fall of mu(T)", aliases=("D",)),
        Parameter("b3", "K", POSITIVE, "temperature of mu(T)", aliases=("T_0",)),
        Parameter("mu_0", "Pa", POSITIVE, "shear modulus that mu(T) is divided by"),
    ),
    inert=tuple(
        Inert(tag, ZERO, "the intrinsic barrier of MTS")
        for tag in ("sigma_i", "g_0i", "edot_0i", "p_i", "q_i")
    ),
)

FLOW = SlotSchema(
    slot="flow",
    tags=("plasticity_model", "flow_model"),
    places=("constitutive_model",),
    absent="",
    models=(PERFECT, LINEAR, POWER_LAW, VOCE, JOHNSON_COOK, MTS),
    plain=("none",),
    unavailable=(
        "steinberg_cochran_guinan",
        "zerilli_armstrong",
        "zerilli_armstrong_polymer",
        "preston_tonks_wallace",
        "suvic_i",
        "anand",
    ),
)
