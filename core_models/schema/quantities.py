"""The card schema of plain tags: constants, elastic moduli, bodies, dead tags."""

from core_models.schema.entries import ANY, NOT_NEGATIVE, POSITIVE, Interval, Parameter, Switch

CONSTANTS = (
    Parameter("density", "kg/m^3", POSITIVE, "mass density of the undeformed body"),
    Parameter("thermal_conductivity", "W/(m K)", POSITIVE, "heat conductivity", optional=True),
    Parameter(
        "specific_heat", "J/(kg K)", POSITIVE, "constant specific heat", "specific_heat.value", optional=True
    ),
    Parameter("room_temp", "K", POSITIVE, "room temperature", "room_temperature", optional=True),
    Parameter(
        "damage_radius",
        "m",
        POSITIVE,
        "radius over which the growth of damage is averaged; local without",
        optional=True,
    ),
    Parameter(
        "melt_temp", "K", POSITIVE, "melting temperature", "melting.melting_temperature", optional=True
    ),
)

ELASTICITY = (
    Parameter("bulk_modulus", "Pa", POSITIVE, "bulk modulus K", "elasticity.bulk_modulus"),
    Parameter("shear_modulus", "Pa", POSITIVE, "shear modulus G", "elasticity.shear_modulus"),
)

TOLERANCE = Parameter(
    "tolerance",
    "-",
    Interval(0.0, 1e-3, low_open=True),
    "relative tolerance of the return to the yield surface",
    default=1e-10,
)

HEATED_FRACTION = Parameter(
    "taylor_quinney_coeff",
    "-",
    Interval(0.0, 1.0, low_open=True),
    "fraction of the plastic work that becomes heat",
    feeds="fraction",
    default=0.9,
)

EXPANSION_COEFFICIENT = Parameter(
    "coeff_thermal_expansion",
    "1/K",
    NOT_NEGATIVE,
    "coefficient of thermal expansion of the length",
    default=0.0,
)

CYLINDER = (
    Parameter("bottom", "m", ANY, "centre of the lower end", size=3),
    Parameter("top", "m", ANY, "centre of the upper end", size=3),
    Parameter("radius", "m", POSITIVE, "radius"),
)

BODY = (
    Parameter("velocity", "m/s", ANY, "initial velocity", size=3),
    Parameter("temperature", "K", POSITIVE, "initial temperature"),
    Parameter("res", "-", POSITIVE, "points per cell and direction", size=3, whole=True, optional=True),
)

UNAVAILABLE_SHAPES = (
    "box",
    "sphere",
    "cone",
    "ellipsoid",
    "torus",
    "union",
    "intersection",
    "difference",
    "file",
)

DEAD_TAGS = ("toughness", "burn", "velocity_field", "C_p")

DEAD_MODEL_TAGS = ("initial_material_temperature", "critical_stress")
"""In the block of an update: said elsewhere too, or of a check that a switch turns off."""

SWITCHES = (
    Switch("isothermal", ("false",), "plasticity without heating by this tag (leave specific_heat out)"),
    Switch("do_melting", ("true",), "strength above melting"),
    Switch("compute_specific_heat", ("true",), "ignoring the <specific_heat_model>"),
    Switch("evolve_porosity", ("false",), "porosity by this tag"),
    Switch("evolve_damage", ("false",), "damage by this tag"),
    Switch("check_TEPLA_failure_criterion", ("false",), "failure by the TEPLA criterion"),
    Switch("check_max_stress_failure", ("false",), "failure by a largest stress"),
    Switch("useModifiedEOS", ("false",), "a modified equation of state in tension"),
    Switch("plastic_convergence_algo", ("radialReturn",), "any return but the radial one"),
)

UNAVAILABLE_TAGS = (
    "deviatoric_stress_model",
    "visco_plasticity_model",
)
