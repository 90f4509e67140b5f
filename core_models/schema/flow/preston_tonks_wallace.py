"""The card schema of Preston-Tonks-Wallace flow."""

from core_models.flow.preston_tonks_wallace import PrestonTonksWallace
from core_models.schema.entries import ANY, NOT_NEGATIVE, POSITIVE, Inert, ModelSchema, Parameter
from core_models.schema.flow.steinberg_cochran_guinan import PER_PASCAL

SLOPE = Parameter("slope_mu_p_over_mu0", "1/Pa", PER_PASCAL, "rise of the modulus with pressure", default=0.0)
ALPHAP = Parameter("alphap", "-", NOT_NEGATIVE, "fall of the modulus with T / T_m")
ALPHA = Inert("alpha", ANY, "a constant that no formula of the model uses")

PRESTON_TONKS_WALLACE = ModelSchema(
    types=("preston_tonks_wallace",),
    law=PrestonTonksWallace,
    help="thermal activation and drag, from quasi-static rates to strong shocks",
    parameters=(
        Parameter("theta", "-", NOT_NEGATIVE, "initial hardening over twice the modulus"),
        Parameter("p", "-", NOT_NEGATIVE, "hardening: 0 for that of Voce"),
        Parameter("s0", "-", POSITIVE, "saturation stress over twice the modulus at 0 K"),
        Parameter("sinf", "-", NOT_NEGATIVE, "the same near melting"),
        Parameter("kappa", "-", NOT_NEGATIVE, "factor of the thermal activation"),
        Parameter("gamma", "-", POSITIVE, "reference rate over the frequency of the atoms"),
        Parameter("y0", "-", POSITIVE, "yield stress over twice the modulus at 0 K"),
        Parameter("yinf", "-", NOT_NEGATIVE, "the same near melting"),
        Parameter("y1", "-", NOT_NEGATIVE, "yield stress between activation and drag: factor"),
        Parameter("y2", "-", NOT_NEGATIVE, "yield stress between activation and drag: exponent"),
        Parameter("beta", "-", NOT_NEGATIVE, "exponent of the drag"),
        Parameter("M", "u", POSITIVE, "atomic mass"),
        Parameter("G0", "Pa", POSITIVE, "shear modulus at 0 K and no pressure"),
        ALPHAP,
        SLOPE,
        Parameter("density", "kg/m^3", POSITIVE, "density at rest", fallback="density"),
        Parameter(
            "T_m", "K", POSITIVE, "melting temperature", feeds="melting_temperature", fallback="melt_temp"
        ),
    ),
    inert=(ALPHA,),
)
