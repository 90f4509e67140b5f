"""Implicit material points: the penalty of cut cells, and stiffness or options that are refused."""

from dataclasses import replace

import pytest

from core_models.errors import SceneError, SingularStiffness, UnsupportedError
from core_models.loads import Damping, Fixed, Pressure, Symmetry, gravity
from meshes.block import block
from mpm import ImplicitSolver
from tests.mpm.implicit_bodies import MEAN, H, solve, steel


@pytest.mark.parametrize(("interpolation", "most"), [("quadratic", 2e5), ("cubic", 2e5)])
def test_ghost_penalty_bounds_the_condition_number(interpolation, most):
    """While the edge of a body moves through a cell it stays bounded; without the penalty it grows without bound."""
    condition = {}
    for filled in (1e-3, 1e-2, 0.1, 1.0):
        mesh = block([0.0, 0.0], [5.0 * H, 4.0 * H], [5, 4])
        points = mesh.points.copy()
        points[points[:, 0] > 4.5 * H, 0] = (4.0 + filled) * H
        for ghost in (0.0, 1e-4):
            solver = ImplicitSolver(
                replace(mesh, points=points), steel(), geometry="plane-strain", cell_size=H, increment=1.0,
                loads=(Symmetry("left"), Symmetry("bottom")), interpolation=interpolation, ghost=ghost,
            )  # fmt: skip
            condition[filled, ghost] = solver.log.records[0].condition
    assert condition[1e-3, 1e-4] < min(most, 1.5 * condition[1e-2, 1e-4])
    assert condition[1e-3, 0.0] > 100.0 * condition[1e-2, 0.0] > 1e4 * condition[0.1, 0.0] > 1e4 * 1e4
    assert condition[1.0, 1e-4] == pytest.approx(condition[1.0, 0.0], rel=0.1)
    assert solver.condition_number() == pytest.approx(solver.log.records[0].condition, rel=1e-6)
    assert "condition number" in solver.log.text()


def test_too_few_particles_are_told():
    """Where particles are farther apart than cells, motions between them cost nothing: refused with the numbers."""
    mesh = block([0.0, 0.0], [4.0 * H, 4.0 * H], [4, 4])
    with pytest.raises(SingularStiffness, match="64 particles in 64 cells.*give a finer mesh"):
        solve(
            mesh,
            (Fixed("bottom"),),
            geometry="plane-strain",
            interpolation="cubic",
            cell_size=0.4 * H,
            ghost=0.0,
        )


@pytest.mark.parametrize(
    ("geometry", "loads", "told"),
    [
        ("plane-strain", (), "translation along x, translation along y, rotation"),
        ("plane-strain", (Symmetry("bottom"),), "translation along x:"),
        ("axisymmetric", (Pressure("right", 1.0),), "translation along z"),
    ],
)
def test_missing_support_is_told_by_its_motion(geometry, loads, told):
    """A singular stiffness is an error with status 3 that names the free motion."""
    with pytest.raises(SingularStiffness, match=told) as caught:
        solve(block([0, 0], [2.0 * H, 2.0 * H], [2, 2]), loads, geometry=geometry)
    assert caught.value.exit_status == 3


@pytest.mark.parametrize(
    ("options", "error", "told"),
    [
        ({"interpolation": "cpdi"}, UnsupportedError, "'cpdi'.*linear, quadratic, cubic"),
        ({"interpolation": "quadrtic"}, SceneError, "quadratic"),
        ({"cure": "mean"}, SceneError, MEAN),
        ({"ghost": -1.0}, SceneError, "ghost = -1.0 is out of range"),
        ({"cell_size": 0.0}, SceneError, "cell_size"),
        ({"cell_size": (H,)}, SceneError, "cell_size has 1 entries"),
        ({"cell_size": (H, [0.0, H])}, SceneError, "the grid ends at y = 0.001 m, the body at 0.002"),
        ({"cell_size": (H, [-H, H, 2 * H])}, SceneError, "held at y = 0 m, but the grid ends at -0.001"),
        ({"cell_size": (H, [H, 0.0])}, SceneError, "ascending"),
        ({"loads": (Damping(1.0),)}, SceneError, "Damping does nothing without motion.*mpm.Solver"),
        ({"loads": (Symmetry("bottom"), gravity([0.0, 1.0, 2.0]))}, SceneError, "shape"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(options, error, told):
    """In one line, before anything is solved."""
    mesh = block([0.0, 0.0], [2.0 * H, 2.0 * H], [2, 2])
    given = {"cell_size": H, "loads": (Symmetry("bottom"),), "geometry": "plane-strain"} | options
    with pytest.raises(error, match=told) as caught:
        ImplicitSolver(mesh, steel(), increment=1.0, **given)
    assert "\n" not in str(caught.value)
