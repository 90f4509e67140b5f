"""The card schema of Mechanical Threshold Stress."""

from core_models.flow.mts import MechanicalThreshold
from core_models.schema.entries import ANY, NOT_NEGATIVE, POSITIVE, ModelSchema, Parameter

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
        Parameter(
            "sigma_i", "Pa", NOT_NEGATIVE, "strength of the intrinsic barrier, 0 for none", default=0.0
        ),
        Parameter("g_0i", "-", NOT_NEGATIVE, "intrinsic barrier: normalised activation energy", default=0.0),
        Parameter("edot_0i", "1/s", NOT_NEGATIVE, "intrinsic barrier: reference rate", default=0.0),
        Parameter("p_i", "-", NOT_NEGATIVE, "intrinsic barrier: inner exponent", default=0.0),
        Parameter("q_i", "-", NOT_NEGATIVE, "intrinsic barrier: outer exponent", default=0.0),
    ),
)
