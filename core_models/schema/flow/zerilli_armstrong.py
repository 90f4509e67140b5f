"""The card schema of Zerilli-Armstrong flow."""

from core_models.flow.zerilli_armstrong import ZerilliArmstrong
from core_models.schema.entries import ANY, NOT_NEGATIVE, ModelSchema, Parameter

ZERILLI_ARMSTRONG = ModelSchema(
    types=("zerilli_armstrong",),
    law=ZerilliArmstrong,
    help="thermally activated flow of bcc and fcc metals",
    parameters=(
        Parameter(
            "sigma_g", "Pa", NOT_NEGATIVE, "athermal stress, that of the grain size apart", aliases=("c_0",)
        ),
        Parameter("k_H", "Pa m^0.5", NOT_NEGATIVE, "Hall-Petch coefficient", default=0.0),
        Parameter("sqrt_l_inv", "m^-0.5", NOT_NEGATIVE, "grain size to the power -1/2", default=0.0),
        Parameter("B", "Pa", NOT_NEGATIVE, "bcc term: stress at 0 K"),
        Parameter("beta_0", "1/K", ANY, "bcc term: fall with temperature at 1 /s"),
        Parameter("beta_1", "1/K", ANY, "bcc term: how it changes with ln(rate)"),
        Parameter("B_0", "Pa", NOT_NEGATIVE, "fcc term: factor of the root of the strain at 0 K"),
        Parameter("alpha_0", "1/K", ANY, "fcc term: fall with temperature at 1 /s"),
        Parameter("alpha_1", "1/K", ANY, "fcc term: how it changes with ln(rate)"),
        Parameter("K", "Pa", NOT_NEGATIVE, "coefficient of the athermal hardening"),
        Parameter("n", "-", NOT_NEGATIVE, "exponent of the athermal hardening"),
    ),
)
