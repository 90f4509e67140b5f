"""A thick sphere whose cavity grows."""

from core_models.yield_condition.von_mises import VonMises
from studies.limit_loads.cavity import outcome
from studies.limit_loads.closed_forms import SPHERE
from studies.limit_loads.loading import EXPLICIT, IMPLICIT, IMPLICIT_POINTS
from studies.limit_loads.materials import COHESION, drucker_prager, mohr_coulomb, perfectly_plastic, tresca
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem

FRICTION = 30.0  # degree


def run(quick: bool) -> Outcome:
    """Four conditions by elements, and by implicit material points."""
    cases = {
        "von Mises": (perfectly_plastic(2.0 * COHESION, VonMises()), COHESION, 0.0),
        "Tresca": (tresca(COHESION), COHESION, 0.0),
        "Mohr-Coulomb": (mohr_coulomb(FRICTION), COHESION, FRICTION),
        "Drucker-Prager": (drucker_prager(FRICTION, "compression"), COHESION, FRICTION),
    }
    return outcome(SPHERE, cases, quick, (IMPLICIT, EXPLICIT, IMPLICIT_POINTS))


PROBLEM = Problem(
    "thick-sphere",
    "Thick sphere",
    "A sphere of twice the outer radius as the inner is widened from inside until the whole wall flows. The pressure "
    "that this takes, from the work done, against the closed forms; the wall is in triaxial compression, where the "
    "Drucker-Prager cone of that fit meets Mohr-Coulomb's pyramid and Tresca's prism meets von Mises' cylinder.",
    "Hill, The Mathematical Theory of Plasticity (1950), chapter 5; Chadwick, Q. J. Mech. Appl. Math. 12 (1959) 52",
    run,
)
