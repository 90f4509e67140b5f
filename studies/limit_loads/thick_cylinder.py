"""A thick cylinder in plane strain whose inner surface grows."""

import math

from core_models.yield_condition.von_mises import VonMises
from studies.limit_loads.cavity import outcome
from studies.limit_loads.closed_forms import CYLINDER
from studies.limit_loads.materials import COHESION, drucker_prager, mohr_coulomb, perfectly_plastic, tresca
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem

FRICTION = 30.0  # degree


def run(quick: bool) -> Outcome:
    """Four conditions by three methods."""
    cases = {
        "von Mises": (perfectly_plastic(math.sqrt(3.0) * COHESION, VonMises()), COHESION, 0.0),
        "Tresca": (tresca(COHESION), COHESION, 0.0),
        "Mohr-Coulomb": (mohr_coulomb(FRICTION), COHESION, FRICTION),
        "Drucker-Prager": (drucker_prager(FRICTION, "plane-strain"), COHESION, FRICTION),
    }
    return outcome(CYLINDER, cases, quick)


PROBLEM = Problem(
    "thick-cylinder",
    "Thick cylinder",
    "A cylinder of twice the outer radius as the inner, its ends held, is widened from inside until the whole wall "
    "flows. The pressure that this takes, from the work done, against the closed forms of Tresca, von Mises and "
    "Mohr-Coulomb; the Drucker-Prager cone that fits plane strain has the limit of Mohr-Coulomb.",
    "Hill, The Mathematical Theory of Plasticity (1950), chapter 5",
    run,
)
