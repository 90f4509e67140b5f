"""Manufactured solution: expanding ring."""

from meshes.mesh import Mesh
from studies.verification.bodies import ring
from studies.verification.closed_forms.mms_ring import INNER, OUTER, RING
from studies.verification.convergence import ManufacturedProblem, convergence
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem
from studies.verification.variants import CONTROL, elements, interpolations

SIZES = (0.1, 0.2 / 3.0, 0.05, 0.2 / 6.0, 0.025, 0.0125)  # m
QUICK_SIZES = (0.1, 0.2 / 3.0, 0.05, 0.2 / 6.0)
FINER = 2  # 4 x 4 particles a cell: with 2 x 2 the floor hides the order


def body(size: float, kind: str) -> Mesh:
    """The ring 0.4 <= R <= 0.6 m."""
    return ring(INNER, OUTER, size, kind)


def run(quick: bool) -> Outcome:
    """All elements and interpolations."""
    problem = ManufacturedProblem(RING, body, "plane-strain")
    variants = [*elements(2), *interpolations(2, FINER)]
    return convergence(problem, variants, QUICK_SIZES if quick else SIZES, CONTROL)


PROBLEM = Problem(
    "mms-ring",
    "Expanding ring",
    "A ring without Poisson's effect breathes by up to 4 % of its radius, its rims free of traction: a curved "
    "boundary that moves through the grid. Displacements are compared after one period, 0.02 s.",
    "Wallstedt & Guilkey, J. Comput. Phys. 227 (2008) 9628-9642",
    run,
)
