"""Manufactured solution: axis-aligned displacement of a square and of a cube."""

from core_models.loads import Symmetry
from meshes.block import block
from meshes.mesh import Mesh
from meshes.patch import SIDES
from studies.verification.closed_forms.mms_axis_aligned import AXIS_ALIGNED
from studies.verification.convergence import ManufacturedProblem, convergence
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem
from studies.verification.variants import CONTROL, elements, interpolations

COUNTS = {2: (6, 8, 12, 16, 24, 48), 3: (4, 6, 8, 12)}
QUICK_COUNTS = {2: (6, 8, 12, 16), 3: (4, 5, 6, 8)}
FINER = {2: 2, 3: 1}  # cells of the particles' mesh along a cell of the grid
GEOMETRIES = {2: "plane-strain", 3: "spatial"}


def body(size: float, kind: str) -> Mesh:
    """The unit square or cube."""
    dimension = 3 if kind.startswith(("hex", "tet")) else 2
    return block([0.0] * dimension, [1.0] * dimension, [round(1.0 / size)] * dimension, kind)


def axis_aligned(dimension: int) -> ManufacturedProblem:
    """The problem between smooth walls on all sides."""
    walls = tuple(Symmetry(name) for pair in SIDES[dimension] for name in pair)
    return ManufacturedProblem(AXIS_ALIGNED, body, GEOMETRIES[dimension], walls)


def run_square(quick: bool) -> Outcome:
    """All elements and interpolations in plane strain."""
    return _run(2, quick)


def run_cube(quick: bool) -> Outcome:
    """All elements and interpolations in three dimensions."""
    return _run(3, quick)


def _run(dimension: int, quick: bool) -> Outcome:
    counts = (QUICK_COUNTS if quick else COUNTS)[dimension]
    variants = [*elements(dimension), *interpolations(dimension, FINER[dimension])]
    return convergence(axis_aligned(dimension), variants, [1.0 / count for count in counts], CONTROL)


SOURCE = "Wallstedt & Guilkey, J. Comput. Phys. 227 (2008) 9628-9642"
SQUARE = Problem(
    "mms-square",
    "Axis-aligned displacement, square",
    "A square in plane strain between smooth walls, standing waves of 5 % of its side along each axis. Displacements "
    "are compared after one period.",
    SOURCE,
    run_square,
)
CUBE = Problem(
    "mms-cube",
    "Axis-aligned displacement, cube",
    "A cube between smooth walls, standing waves of 5 % of its side along each axis, a third of a period apart; it "
    "starts displaced, moving and stressed. Displacements are compared after one period.",
    SOURCE,
    run_cube,
)
