"""The card schema of damage and erosion."""

from core_models.damage.gurson import VoidNucleation
from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.damage.sandia import SandiaDamage
from core_models.erosion.delete import DeletePoint
from core_models.erosion.no_shear import AllowNoShear
from core_models.erosion.no_tension import AllowNoTension
from core_models.erosion.preserve_stress import PreserveStress
from core_models.erosion.zero_stress import ZeroStress
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

SCATTER = Inert("initial_std_scalar_damage", ZERO, "scattered initial damage")
COUPLING = Parameter(
    "coupling", "-", Interval(0.0, 1.0), "share of the strength that full damage takes away", default=0.0
)
FRACTION = Interval(0.0, 1.0, low_open=True, high_open=True)

JOHNSON_COOK_DAMAGE = ModelSchema(
    types=("johnson_cook",),
    law=JohnsonCookDamage,
    help="failure strain of triaxiality, rate and temperature; acts by coupling or with an erosion algorithm",
    parameters=(
        *(Parameter(f"D{i}", "-", ANY, f"failure strain constant {i}") for i in range(1, 6)),
        Parameter("T_r", "K", NOT_NEGATIVE, "temperature where T* is 0", fallback="room_temp"),
        Parameter("T_m", "K", POSITIVE, "temperature where T* is 1", fallback="melt_temp"),
        COUPLING,
    ),
    inert=(Inert("initial_mean_scalar_damage", ZERO, "initial damage"), SCATTER),
    ascending=(("T_r", "T_m"),),
)

HANCOCK_MACKENZIE = ModelSchema(
    types=("hancock_mackenzie",),
    law=HancockMackenzieDamage,
    help="growth of voids with the exponential of the triaxiality; acts by coupling or with an erosion algorithm",
    parameters=(
        Parameter(
            "initial_mean_scalar_damage",
            "-",
            NOT_NEGATIVE,
            "damage before any strain",
            feeds="initial_damage",
            default=0.0,
        ),
        Parameter(
            "critical_scalar_damage",
            "-",
            POSITIVE,
            "damage at failure",
            feeds="critical_damage",
            default=1.0,
        ),
        COUPLING,
    ),
    inert=(SCATTER,),
    ascending=(("initial_mean_scalar_damage", "critical_scalar_damage"),),
)

SANDIA = ModelSchema(
    types=("sandia", "cocks_ashby"),
    law=SandiaDamage,
    help="growth of voids after Bammann, Chiesa and Johnson; acts by coupling or with an erosion algorithm",
    parameters=(
        Parameter("m", "-", Interval(low=0.5, low_open=True), "exponent of the viscous matrix"),
        Parameter(
            "initial_porosity", "-", FRACTION, "voids before any strain", aliases=("initial_mean_porosity",)
        ),
        Parameter("critical_porosity", "-", FRACTION, "voids at failure"),
        COUPLING,
    ),
    inert=(Inert("initial_std_porosity", ZERO, "scattered initial porosity"),),
    ascending=(("initial_porosity", "critical_porosity"),),
)

GURSON_VOIDS = ModelSchema(
    types=("gurson_voids",),
    law=VoidNucleation,
    help="voids of the yield condition gurson: at the start, and nucleated by plastic strain",
    parameters=(
        Parameter(
            "initial_porosity",
            "-",
            Interval(0.0, 1.0, high_open=True),
            "voids before any strain",
            aliases=("initial_mean_porosity",),
        ),
        Parameter("frac_nucleation", "-", NOT_NEGATIVE, "voids that nucleate", feeds="f_n", default=0.0),
        Parameter("meanstrain_nucleation", "-", ANY, "mean strain of nucleation", feeds="eps_n", default=0.3),
        Parameter(
            "stddevstrain_nucleation", "-", POSITIVE, "its standard deviation", feeds="s_n", default=0.1
        ),
    ),
    inert=(Inert("initial_std_porosity", ZERO, "scattered initial porosity"),),
)

DAMAGE = SlotSchema(
    slot="damage",
    tags=("damage_model",),
    places=("constitutive_model", "material"),
    absent="none",
    models=(JOHNSON_COOK_DAMAGE, HANCOCK_MACKENZIE, SANDIA, GURSON_VOIDS),
    plain=("none",),
    unavailable=("Threshold", "ThresholdVar", "Brittle"),
)

DECAY = (
    Parameter(
        "char_time",
        "s",
        NOT_NEGATIVE,
        "time in which what is lost decays; 0: at once",
        "decay_time",
        default=0.0,
    ),
)

EROSION = SlotSchema(
    slot="erosion",
    tags=("erosion",),
    places=("material", "constitutive_model"),
    absent="none",
    models=(
        ModelSchema(("ZeroStress",), ZeroStress, "a failed point carries no stress", DECAY),
        ModelSchema(("AllowNoTension",), AllowNoTension, "it carries pressure in compression only", DECAY),
        ModelSchema(("AllowNoShear",), AllowNoShear, "it carries pressure only", DECAY),
        ModelSchema(("PreserveStress",), PreserveStress, "it goes on as it was"),
        ModelSchema(("Delete",), DeletePoint, "it is out of the simulation, its mass is debris", DECAY),
    ),
    plain=("none",),
    unavailable=("RemoveMass",),
    attribute="algorithm",
)
