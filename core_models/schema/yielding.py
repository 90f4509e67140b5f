"""The card schema of yield conditions and kinematic hardening."""

import math

from core_models.kinematic_hardening.armstrong_frederick import ArmstrongFrederick
from core_models.kinematic_hardening.chaboche import Chaboche
from core_models.kinematic_hardening.prager import Prager
from core_models.kinematic_hardening.ziegler import Ziegler
from core_models.schema.entries import (
    ANY_NUMBER_OF,
    NOT_NEGATIVE,
    POSITIVE,
    Inert,
    Interval,
    ModelSchema,
    Parameter,
    SlotSchema,
)
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises

ANGLE = Interval(0.0, 90.0, high_open=True)
FRACTION = Interval(0.0, 1.0, low_open=True, high_open=True)
WHOLE = Inert("beta", Interval(1.0, 1.0), "hardening that is partly isotropic")

DRUCKER_PRAGER = ModelSchema(
    types=("drucker_prager",),
    law=DruckerPrager,
    help="sqrt(J_2) + alpha I_1 <= cohesion_factor times the flow stress",
    parameters=(
        Parameter("alpha", "-", NOT_NEGATIVE, "friction"),
        Parameter("beta", "-", NOT_NEGATIVE, "dilation, at most the friction"),
        Parameter("cohesion_factor", "-", POSITIVE, "k over the flow stress", default=1.0),
        Parameter("tension_cutoff", "Pa", POSITIVE, "largest mean stress", default=math.inf),
    ),
)

MOHR_COULOMB = ModelSchema(
    types=("mohr_coulomb",),
    law=MohrCoulomb,
    help="s_1 - s_3 + (s_1 + s_3) sin(friction) <= 2 cos(friction) times the flow stress, which is the cohesion",
    parameters=(
        Parameter("friction_angle", "degree", ANGLE, "angle of friction"),
        Parameter("dilation_angle", "degree", ANGLE, "angle of dilation, at most that of friction"),
        Parameter("tension_cutoff", "Pa", POSITIVE, "largest principal stress", default=math.inf),
    ),
)

GURSON = ModelSchema(
    types=("gurson", "gtn"),
    law=Gurson,
    help="porous metal: (q / flow stress)^2 + 2 q1 f* cosh(3 q2 m / (2 flow stress)) <= 1 + q3 f*^2",
    parameters=(
        Parameter("q1", "-", POSITIVE, "constant of the hyperbolic cosine"),
        Parameter("q2", "-", POSITIVE, "constant of the mean stress"),
        Parameter("q3", "-", POSITIVE, "constant of the square of the porosity"),
        Parameter("k", "-", Interval(low=1.0), "acceleration of the coalescence"),
        Parameter("f_c", "-", FRACTION, "porosity where coalescence begins"),
    ),
)

YIELD_CONDITION = SlotSchema(
    slot="yield_condition",
    tags=("yield_condition",),
    places=("constitutive_model",),
    absent="vonMises where there is a flow law",
    models=(
        ModelSchema(("vonMises",), VonMises, "q = sqrt(3/2 s:s) <= flow stress"),
        DRUCKER_PRAGER,
        MOHR_COULOMB,
        GURSON,
    ),
    plain=("none",),
    unavailable=("rousselier",),
)

MODULUS = Parameter(
    "hardening_modulus", "Pa", POSITIVE, "slope of the uniaxial stress by the plastic strain", feeds="modulus"
)

KINEMATIC_HARDENING = SlotSchema(
    slot="kinematic_hardening",
    tags=("kinematic_hardening_model",),
    places=("constitutive_model",),
    absent="none",
    models=(
        ModelSchema(
            ("prager_hardening", "prager"),
            Prager,
            "back stress along the plastic strain",
            (MODULUS,),
            (WHOLE,),
        ),
        ModelSchema(
            ("ziegler_hardening", "ziegler"),
            Ziegler,
            "back stress along s - alpha",
            (MODULUS,),
            (WHOLE,),
        ),
        ModelSchema(
            types=("armstrong_frederick_hardening", "armstrong_frederick"),
            law=ArmstrongFrederick,
            help="back stress that saturates at the modulus over the recovery",
            parameters=(
                Parameter(
                    "hardening_modulus_1",
                    "Pa",
                    POSITIVE,
                    "initial slope of the uniaxial stress",
                    feeds="modulus",
                ),
                Parameter("hardening_modulus_2", "-", NOT_NEGATIVE, "dynamic recovery", feeds="recovery"),
            ),
            inert=(WHOLE,),
        ),
        ModelSchema(
            types=("chaboche_hardening", "chaboche"),
            law=Chaboche,
            help="sum of back stresses that saturate",
            parameters=(
                Parameter("moduli", "Pa", POSITIVE, "initial slopes", size=ANY_NUMBER_OF),
                Parameter("recoveries", "-", NOT_NEGATIVE, "dynamic recoveries", size=ANY_NUMBER_OF),
            ),
        ),
    ),
    plain=("none",),
)
