"""Bad meshes and bad places of particles."""

from studies.stability.bodies import ACROSS, RADIUS, bar, bar_mesh, copper, square
from studies.stability.case import Case

END = 10e-6  # s
SPEED = 300.0  # m/s


def _impact(variant: str, mesh, cell: float = RADIUS / ACROSS, **options):
    return bar(variant, copper(), mesh=mesh, cell=cell, velocity=-SPEED, wall="unilateral", **options)


def _distorted(variant: str):
    return _impact(variant, square(variant, distortion=0.35))


def _graded(variant: str):
    return _impact(variant, bar_mesh(variant, grading=8.0))


def _lonely(variant: str):
    """Cells a quarter as large as the elements: most hold one particle or none."""
    return _impact(variant, bar_mesh(variant), RADIUS / (4 * ACROSS))


def _on_nodes(variant: str):
    """Cells moved against the bar by a foot at such a height that rows of particles meet rows of nodes."""
    height = RADIUS / ACROSS * (0.5 - 0.5 * (1.0 - 3.0**-0.5))
    return _impact(variant, bar_mesh(variant, foot_height=height))


CASES = (
    Case("distorted", "A block of randomly distorted elements at 300 m/s", _distorted, END),
    Case("graded", "Elements eight times as fine at the foot, 300 m/s", _graded, END),
    Case("lonely-particles", "Cells of the grid that hold one particle or none", _lonely, END),
    Case("particles-on-nodes", "Particles that stand on nodes of the grid", _on_nodes, END),
)
