"""Manufactured solution: generalized vortex."""

from meshes.mesh import Mesh
from studies.verification.bodies import ring
from studies.verification.closed_forms.mms_vortex import INNER, OUTER, VORTEX
from studies.verification.convergence import ManufacturedProblem, convergence
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem
from studies.verification.variants import CONTROL, elements, interpolations, transfers

SIZES = (0.1, 0.05, 0.025, 0.0125)  # m
QUICK_SIZES = (0.125, 0.1, 0.0625, 0.05)


def body(size: float, kind: str) -> Mesh:
    """The annulus 0.75 <= R <= 1.25 m."""
    return ring(INNER, OUTER, size, kind)


def run(quick: bool) -> Outcome:
    """All elements, interpolations and transfers."""
    problem = ManufacturedProblem(VORTEX, body, "plane-strain")
    variants = [*elements(2), *interpolations(2), *transfers(2)]
    return convergence(problem, variants, QUICK_SIZES if quick else SIZES, CONTROL)


PROBLEM = Problem(
    "mms-vortex",
    "Generalized vortex",
    "An annulus in plane strain whose circles turn to and fro by up to one radian, each by its own angle: large shear "
    "and rotation without change of volume, particles crossing the grid at every angle. Rims are free. Displacements "
    "are compared at 1 s, when everything is back.",
    "Kamojjala, Brannon et al., Eng. Comput. 31 (2015) 27-44",
    run,
)
