"""Locking and its cure seen in the pressure of one-point elements."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.loads import Symmetry
from fem import ExplicitSolver
from fem.checkerboard import checkerboard
from meshes.block import block
from meshes.taylor_bar import taylor_bar
from meshes.taylor_quarter import taylor_quarter


@pytest.fixture
def stressed(elastic):
    """Make a body of even quads with given mean stresses (x, y) -> [Pa] in its elements."""

    def make(count, pressure):
        solver = ExplicitSolver(
            block((0.0, 0.0), (1.0, 1.0), (count, count)), elastic, geometry="plane-strain"
        )
        x = solver.mesh.points[solver.mesh.cells].mean(axis=1)
        values = np.repeat(pressure(x, count), 4)
        solver.points.old.stress[:, :3] = values[:, None]
        return solver

    return make


def test_an_alternating_pressure_counts_fully(stressed):
    """+1 and -1 like the fields of a chessboard: 1, but for what the rim's averages do not take out."""
    board = stressed(16, lambda x, n: (-1.0) ** (np.floor(n * x).sum(axis=1)))
    assert checkerboard(board) == pytest.approx(1.0, rel=0.05)


def test_a_smooth_pressure_counts_less_and_less(stressed):
    """A sine of the position: the measure falls like the size of the elements squared."""
    found = [
        checkerboard(stressed(n, lambda x, n: np.sin(3.0 * x[:, 0]) * np.cos(2.0 * x[:, 1])))
        for n in (8, 16, 32)
    ]
    assert found[0] < 0.05
    assert found[1] < found[0] / 2.0
    assert found[2] < found[1] / 2.0


def test_a_body_without_stress_has_none(stressed):
    """No stress, no checkerboard."""
    assert checkerboard(stressed(2, lambda x, n: 0.0 * x[:, 0])) == 0.0


BARS = {
    "tri3": lambda: taylor_bar(3.2e-3, 12.8e-3, 4, kind="tri3"),
    "tet4": lambda: taylor_quarter(3.2e-3, 12.8e-3, 3, kind="tet4"),
}


@pytest.mark.parametrize("kind", BARS)
def test_averages_over_patches_free_one_point_simplices(j2, kind):
    """A short bar spreads further with its cure, and its pressure alternates less than half as much."""
    mesh = BARS[kind]()
    loads = tuple(Symmetry(name) for name in mesh.boundaries if name.startswith("symmetry"))
    radius, alternating = {}, {}
    for cure in ("none", "nodal-average"):
        solver = ExplicitSolver(
            mesh, j2, velocity=-150.0, wall="plane", cure=cure, loads=loads, viscosity=BulkViscosity(0.0, 1.2)
        )
        while solver.time < 15e-6:
            solver.advance()
        radius[cure] = np.linalg.norm(
            solver.boundary_positions("foot")[:, : mesh.dimension - 1], axis=1
        ).max()
        alternating[cure] = checkerboard(solver)
    assert radius["nodal-average"] > 1.05 * radius["none"]
    assert alternating["nodal-average"] < 0.5 * alternating["none"]
