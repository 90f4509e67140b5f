"""The card schema of Anand flow."""

from core_models.flow.anand import Anand
from core_models.schema.entries import NOT_NEGATIVE, POSITIVE, Interval, ModelSchema, Parameter

ANAND = ModelSchema(
    types=("anand",),
    law=Anand,
    help="rate-dependent flow of hot metals and solders, without a yield surface",
    parameters=(
        Parameter("s_0", "Pa", POSITIVE, "initial deformation resistance"),
        Parameter("Q_over_R", "K", NOT_NEGATIVE, "activation energy over the gas constant"),
        Parameter("A", "1/s", POSITIVE, "pre-exponential factor"),
        Parameter("xi", "-", POSITIVE, "multiplier of the stress"),
        Parameter("m", "-", POSITIVE, "rate sensitivity of the stress"),
        Parameter("h_0", "Pa", NOT_NEGATIVE, "hardening constant"),
        Parameter("s_hat", "Pa", POSITIVE, "coefficient of the saturation of the resistance"),
        Parameter("n", "-", NOT_NEGATIVE, "rate sensitivity of the saturation"),
        Parameter("a", "-", Interval(low=1.0), "exponent of the hardening"),
    ),
)
