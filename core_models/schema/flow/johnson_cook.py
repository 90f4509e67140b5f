"""The card schema of Johnson-Cook flow."""

from core_models.flow.johnson_cook import JohnsonCook
from core_models.schema.entries import NOT_NEGATIVE, POSITIVE, ModelSchema, Parameter

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
