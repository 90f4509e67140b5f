"""Implicit material points: supports and loads on faces that cut cells, held exactly or by springs."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core_models.loads import BodyForce, Fixed, Prescribed, Pressure, Symmetry, Traction
from meshes.annulus import annulus
from meshes.block import block
from tests.mpm.implicit_bodies import MEAN, H, solve, steel


@pytest.mark.parametrize(
    ("interpolation", "cure"), [("linear", MEAN), ("quadratic", MEAN), ("quadratic", None)]
)
def test_linear_fields_are_exact(interpolation, cure):
    """With every side moved linearly the inside follows, stress is the same everywhere, and forces balance."""
    gradient = np.array([[0.03, 0.02], [-0.01, 0.05]])
    mesh = block([0.0, 0.0], [3.0 * H, 3.0 * H], [3, 3])
    loads = tuple(
        Prescribed(name, i, lambda X, t, row=gradient[i]: X @ row)
        for name in mesh.boundaries
        for i in range(2)
    )
    solver = solve(mesh, loads, geometry="plane-strain", interpolation=interpolation, cure=cure)
    expected = solver.reference_positions @ (np.eye(2) + gradient).T
    assert np.abs(solver.positions - expected).max() < 1e-12 * H
    stress = solver.points.old.stress
    assert np.ptp(stress, axis=0).max() < 1e-8 * np.abs(stress).max()
    total = sum(solver._supports.reactions)
    assert np.abs(total).max() < 1e-8 * np.abs(solver.nodal_forces()).max()


def test_pressure_follows_the_surface():
    """A pressurised ring: the hoop force of its section balances the pressure on its current inner radius."""
    mesh = block([10e-3, 0.0], [11e-3, 1e-3], [4, 1])
    pressure = 20e6
    loads = (Symmetry("bottom"), Symmetry("top"), Pressure("left", lambda t: pressure * t))
    solver = solve(mesh, loads, cell_size=(0.25e-3, 1e-3))
    areas = solver.point_volumes() / (2.0 * math.pi * solver.point_positions()[:, 0])
    inner = solver.boundary_positions("left")[:, 0].mean()
    hoop = (solver.points.old.stress[:, 2] * areas).sum()
    assert hoop == pytest.approx(pressure * inner * 1e-3, rel=1e-5)
    assert sum(each.iterations for each in solver.log.increments) <= 8


def test_loads_go_through_the_supports():
    """Weight and a traction on the top, which cuts cells, are what the support at the foot carries; energy closes."""
    mesh = block([0.0, 0.0], [2.0 * H, 2.3 * H], [4, 6])
    pull = Traction("top", lambda X, t: np.tile([0.0, 1e8 * t], (len(X), 1)))
    weight = BodyForce(lambda X, t: np.tile([0.0, -1e6 * t], (len(X), 1)), "reference")
    loads = (Symmetry("left"), Fixed("bottom"), pull, weight)
    solver = solve(mesh, loads, geometry="plane-strain", cell_size=0.6 * H)
    expected = 1e6 * solver.mass - 1e8 * 2.0 * H
    assert solver.boundary_force("bottom")[1] == pytest.approx(expected, rel=1e-7)
    assert abs(solver.ledger.relative_error) < 1e-3
    assert set(solver.outline()) >= {"top", "right"}
    volume = solver.point_volumes().sum()
    corners = solver.domains()
    across, along = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    areas = 0.5 * (across[:, 0] * along[:, 1] - across[:, 1] * along[:, 0])
    assert areas.sum() == pytest.approx(volume, rel=1e-5)


def test_parts_of_a_face_are_held_by_springs():
    """The two halves of a top, held one by one, carry what the whole top does; reactions and energy balance."""
    mesh = block([0.0, 0.0], [4.0 * H, 3.0 * H], [8, 6])
    ends = mesh.boundaries["top"]
    first = mesh.points[ends][:, :, 0].mean(axis=1) < 2.0 * H
    mesh = replace(mesh, boundaries=mesh.boundaries | {"left half": ends[first], "right half": ends[~first]})
    forces = {}
    for names in (("top",), ("left half", "right half")):
        tops = [load for name in names for load in (Prescribed(name, 1, 0.02 * H), Prescribed(name, 0))]
        solver = solve(mesh, (Fixed("bottom"), *tops), 0.1, geometry="plane-strain", cell_size=0.75 * H)
        forces[names] = sum(solver.boundary_force(name)[1] for name in names)
        assert solver.boundary_force("bottom")[1] == pytest.approx(-forces[names], rel=1e-6)
        assert abs(solver.ledger.relative_error) < 0.03
    whole, parts = forces.values()
    assert parts == pytest.approx(whole, rel=5e-3)


def test_curved_surfaces_are_held_by_springs():
    """A hollow elastic sphere whose inner surface is moved outwards: Lame's displacement of the outer one, force."""
    inner, outer, grown = 5.0 * H, 10.0 * H, 1e-4 * H
    mesh = annulus(inner, outer, [8, 24], "quad4", quarter=True)
    loads = [Prescribed("inner", i, lambda X, t, i=i: grown * X[:, i] / inner) for i in range(2)]
    solver = solve(mesh, (*loads, Symmetry("symmetry_y")), 1.0, cell_size=0.6 * H)
    bulk, shear = steel().elasticity
    # u = a r + b / r^2 with 3 K a = 4 G b / outer^3 where no stress is
    b = grown / (1.0 / inner**2 + 4.0 * shear * inner / (3.0 * bulk * outer**3))
    a = 4.0 * shear * b / (3.0 * bulk * outer**3)
    reference, current = solver.boundary_points("outer")
    moved = ((current - reference) * reference).sum(axis=1) / outer
    assert moved == pytest.approx(a * outer + b / outer**2, rel=0.01)
    pressure = 4.0 * shear * b / inner**3 - 3.0 * bulk * a
    assert solver.boundary_force("inner")[1] == pytest.approx(math.pi * inner**2 * pressure, rel=0.01)


def test_half_a_body_is_half_of_the_whole():
    """A plane of symmetry stands for the other half, but for the slopes that the grid's end leaves free there."""
    loads = (Fixed("left"), Prescribed("right", 0, 0.4 * H))
    whole, half = (
        solve(
            block([0.0, low * H], [3.0 * H, 2.0 * H], [6, 2 * (2 - low)]),
            (*loads, *more),
            geometry="plane-strain",
            cell_size=0.5 * H,
        )
        for low, more in ((-2, ()), (0, (Symmetry("bottom"),)))
    )
    upper = whole.reference_positions[:, 1] > 0.0
    moved = half.positions - half.reference_positions
    assert np.abs(whole.positions[upper] - half.positions).max() < 0.01 * np.abs(moved).max()
