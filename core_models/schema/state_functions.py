"""The card schema of what the state of a point decides: shear modulus, melting temperature, specific heat."""

from core_models.melting.burakovsky_preston_silbar import BurakovskyMelting
from core_models.melting.steinberg_cochran_guinan import SteinbergMelting
from core_models.schema.entries import NOT_NEGATIVE, POSITIVE, Interval, ModelSchema, Parameter, SlotSchema
from core_models.schema.flow.preston_tonks_wallace import ALPHA, ALPHAP, SLOPE
from core_models.schema.flow.steinberg_cochran_guinan import LINDEMANN, SOFTENING, STIFFENING
from core_models.shear_modulus.nadal_le_poac import NadalLePoac
from core_models.shear_modulus.preston_tonks_wallace import PrestonShearModulus
from core_models.shear_modulus.steinberg_cochran_guinan import SteinbergShearModulus
from core_models.shear_modulus.varshni import VarshniShearModulus
from core_models.specific_heat.copper import CopperSpecificHeat
from core_models.specific_heat.steel import SteelSpecificHeat

COLD_MODULUS = Parameter("mu_0", "Pa", POSITIVE, "shear modulus at 0 K and no pressure")

SHEAR_MODULUS = SlotSchema(
    slot="shear_modulus",
    tags=("shear_modulus_model",),
    places=("constitutive_model",),
    absent="constant_shear",
    models=(
        ModelSchema(
            types=("mts_shear",),
            law=VarshniShearModulus,
            help="Varshni's fall with temperature",
            parameters=(
                COLD_MODULUS,
                Parameter("D", "Pa", NOT_NEGATIVE, "fall of the modulus"),
                Parameter("T_0", "K", POSITIVE, "temperature of the fall"),
            ),
        ),
        ModelSchema(
            types=("scg_shear",),
            law=SteinbergShearModulus,
            help="linear in pressure and temperature",
            parameters=(
                Parameter("mu_0", "Pa", POSITIVE, "shear modulus at 300 K and no pressure"),
                STIFFENING,
                SOFTENING,
            ),
        ),
        ModelSchema(
            types=("ptw_shear",),
            law=PrestonShearModulus,
            help="linear in pressure, and in temperature over that of melting",
            parameters=(COLD_MODULUS, ALPHAP, SLOPE),
            inert=(ALPHA,),
        ),
        ModelSchema(
            types=("np_shear",),
            law=NadalLePoac,
            help="linear in pressure and temperature, falling to nothing about melting",
            parameters=(
                COLD_MODULUS,
                Parameter("zeta", "-", POSITIVE, "width of the fall at melting"),
                SLOPE,
                Parameter("C", "-", POSITIVE, "Lindemann's constant"),
                Parameter("m", "u", POSITIVE, "atomic mass"),
                Parameter("density", "kg/m^3", POSITIVE, "density at rest", fallback="density"),
            ),
        ),
    ),
    plain=("constant_shear",),
)

MELTING = SlotSchema(
    slot="melting",
    tags=("melting_temp_model",),
    places=("constitutive_model",),
    absent="constant_Tm",
    models=(
        ModelSchema(("scg_Tm",), SteinbergMelting, "grows with the density", LINDEMANN),
        ModelSchema(
            types=("bps_Tm",),
            law=BurakovskyMelting,
            help="melting by dislocations; grows with the pressure",
            parameters=(
                Parameter("B0", "Pa", POSITIVE, "bulk modulus at no pressure"),
                Parameter("dB_dp0", "-", POSITIVE, "its slope in pressure"),
                Parameter("G0", "Pa", POSITIVE, "shear modulus at no pressure"),
                Parameter("dG_dp0", "-", NOT_NEGATIVE, "its slope in pressure"),
                Parameter(
                    "kappa", "-", POSITIVE, "1 for screw, 1/(1 - nu) for edge dislocations", default=1.0
                ),
                Parameter("z", "-", Interval(low=2.0, low_open=True), "coordination number"),
                Parameter(
                    "b2rhoTm", "-", POSITIVE, "Burgers vector squared x dislocation density at melting"
                ),
                Parameter("alpha", "-", POSITIVE, "core of the dislocations"),
                Parameter(
                    "lambda", "-", POSITIVE, "Burgers vector cubed over atomic volume", feeds="lambda_"
                ),
                Parameter("a", "m", POSITIVE, "lattice constant"),
                Parameter(
                    "v_ws_a3_factor", "-", POSITIVE, "atomic volume over a^3: 1/4 for fcc, 1/2 for bcc"
                ),
                Parameter("Boltzmann_constant", "J/K", POSITIVE, "Boltzmann constant", default=1.380649e-23),
            ),
        ),
    ),
    plain=("constant_Tm",),
    unavailable=("linear_Tm",),
)

SPECIFIC_HEAT = SlotSchema(
    slot="specific_heat",
    tags=("specific_heat_model",),
    places=("constitutive_model",),
    absent="constant_Cp",
    models=(
        ModelSchema(("copper_Cp",), CopperSpecificHeat, "copper, from 15 K to melting"),
        ModelSchema(("steel_Cp",), SteelSpecificHeat, "iron and low-alloy steel about the Curie point"),
    ),
    plain=("constant_Cp",),
    unavailable=("cubic_Cp",),
)
