"""The card schema of Steinberg-Cochran-Guinan flow, and of the constants that its state functions share."""

from core_models.flow.steinberg_cochran_guinan import SteinbergCochranGuinan
from core_models.schema.entries import NOT_NEGATIVE, POSITIVE, Inert, Interval, ModelSchema, Parameter

PER_PASCAL = Interval(0.0, 1e-9)  # 1/Pa: a value above it was printed in 1/Mbar, 1e11 times as large

STIFFENING = Parameter("A", "1/Pa", PER_PASCAL, "rise of the modulus with pressure (1/Mbar x 1e-11)")
SOFTENING = Parameter("B", "1/K", NOT_NEGATIVE, "fall of the modulus with temperature")
LINDEMANN = (
    Parameter("T_m0", "K", POSITIVE, "melting temperature at the reference density"),
    Parameter("Gamma_0", "-", NOT_NEGATIVE, "Grüneisen's gamma"),
    Parameter("a", "-", NOT_NEGATIVE, "fall of Grüneisen's gamma with the density"),
)

STEINBERG_COCHRAN_GUINAN = ModelSchema(
    types=("steinberg_cochran_guinan",),
    law=SteinbergCochranGuinan,
    help="hardening to a limit, scaled with the shear modulus; Lund's rate term with a Peierls stress",
    parameters=(
        Parameter("sigma_0", "Pa", POSITIVE, "initial yield stress at 300 K"),
        Parameter("beta", "-", NOT_NEGATIVE, "work hardening: factor of the strain"),
        Parameter("n", "-", NOT_NEGATIVE, "work hardening: exponent"),
        Parameter("epsilon_p0", "-", NOT_NEGATIVE, "initial plastic strain", default=0.0),
        Parameter("Y_max", "Pa", POSITIVE, "limit of the work hardening"),
        STIFFENING,
        SOFTENING,
        *LINDEMANN,
        Parameter("C1", "1/s", NOT_NEGATIVE, "rate term: frequency factor", default=0.0),
        Parameter("C2", "Pa s", NOT_NEGATIVE, "rate term: drag", default=0.0),
        Parameter(
            "energy_to_form_kink_pair",
            "eV",
            NOT_NEGATIVE,
            "rate term: half the activation energy",
            default=0.0,
        ),
        Parameter(
            "Boltzmann_constant", "eV/K", POSITIVE, "in the unit of that energy per K", default=8.617333262e-5
        ),
        Parameter("Peierls_stress", "Pa", NOT_NEGATIVE, "rate term: its limit; 0 for none", default=0.0),
    ),
    inert=(Inert("mu_0", POSITIVE, "a shear modulus that is not positive"),),
    ascending=(("sigma_0", "Y_max"),),
)
