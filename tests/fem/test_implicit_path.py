"""Loads as what is controlled: paths of equilibrium past the largest load, and what is said where loads end."""

import math

import numpy as np
import pytest

from core_models.equilibrium.measures import PathLength
from core_models.errors import LoadBeyondEquilibrium, MeshError, SceneError
from core_models.loads import Fixed, Prescribed, Pressure, Symmetry, Traction
from fem import ImplicitSolver
from fem.implicit.path import BoundaryMotion
from meshes.block import block
from meshes.necking_bar import necking_bar
from studies.necking.reader import read_necking_scene

STEEL = read_necking_scene("necking-simo").material
RADIUS, LENGTH = 6.413e-3, 26.667e-3
AREA = math.pi * RADIUS**2
PER_TIME = 1e9  # Pa/s
PULL = Traction("end", lambda X, t: np.tile([0.0, PER_TIME * t], (len(X), 1)))


def bar(mesh, path, increment, **options):
    """The necking bar, pulled by a dead traction."""
    return ImplicitSolver(
        mesh, STEEL, loads=(Symmetry("neck"), PULL), increment=increment, path=path, **options
    )


def followed(solver, end):
    """Force [N] and elongation [m] after every increment up to a time [s]."""
    rows = []
    while solver.time < end:
        solver.advance(end)
        elongation = solver.boundary_positions("end")[:, 1].mean() - LENGTH
        rows.append((AREA * PER_TIME * solver.load_time, elongation))
    return np.array(rows).T


def uniform_force(elongation):
    """Force [N] of the bar that stays a cylinder: A_0 sigma_y / stretch, Hencky strain = p + sigma_y / E."""
    flow, elasticity = STEEL.flow, STEEL.elasticity
    shear, bulk = elasticity.shear_modulus, elasticity.bulk_modulus
    p = np.linspace(0.0, 0.5, 5001)
    stress = flow.saturation_stress + flow.linear_modulus * p
    stress -= (flow.saturation_stress - flow.yield_stress) * np.exp(-flow.saturation_rate * p)
    total = p + stress * (3.0 * bulk + shear) / (9.0 * bulk * shear)
    return np.interp(np.log1p(elongation / LENGTH), total, AREA * stress * np.exp(-total))


@pytest.mark.parametrize("path", [PathLength(3e-3), BoundaryMotion("end", 1, 4.5e-3)])
def test_dead_traction_is_followed_past_the_largest_uniform_force(path):
    """A bar under force control keeps to the closed form before the maximum and after it, where the load falls."""
    solver = bar(necking_bar(RADIUS, LENGTH, 1, 1, 1.0), path, 0.025)
    force, elongation = followed(solver, 1.5)
    peak = int(force.argmax())
    assert 10 < peak < len(force) - 10 and elongation[-1] > 6e-3
    flowing = elongation > 0.1e-3
    assert np.abs(force / uniform_force(elongation) - 1.0)[flowing].max() < 1e-3
    assert solver.log.cuts == []


def test_necking_bar_under_force_control_follows_displacement_control():
    """Past the peak, where the neck alone goes on, force and neck are those of prescribed displacement."""
    mesh = necking_bar(RADIUS, LENGTH, 3, 8, 0.982, 0.3)
    solver = bar(mesh, BoundaryMotion("end", 1, 7e-3), 0.04)
    force, elongation = followed(solver, 0.9)
    loads = (Symmetry("neck"), Prescribed("end", 1, 7e-3))
    held = ImplicitSolver(mesh, STEEL, loads=loads, increment=0.04)
    while held.time < 0.9:
        held.advance(0.9)
    assert elongation[-1] == pytest.approx(7e-3 * 0.9, rel=1e-7)
    assert force[-1] < 0.75 * force.max()
    assert force[-1] == pytest.approx(held.boundary_force("end")[1], rel=0.01)
    neck, expected = (each.boundary_positions("neck")[:, 0].max() for each in (solver, held))
    assert neck == pytest.approx(expected, rel=0.01)
    assert solver.ledger.relative_error < 0.01


def test_path_restarts_bitwise():
    """A solver built alike goes on from the checkpoint of another, load time included."""
    mesh = necking_bar(RADIUS, LENGTH, 1, 1, 1.0)
    first, second = (bar(mesh, PathLength(3e-3), 0.05) for _ in range(2))
    followed(first, 0.2)
    second.restore(first.checkpoint())
    expected = followed(first, 0.4)
    assert (followed(second, 0.4) == expected).all() and first.load_time == second.load_time


def test_load_beyond_equilibrium_is_told_with_the_largest_that_was_carried():
    """A traction beyond the plastic limit ends with status 3; the message says how much, and what to do."""
    solver = bar(necking_bar(RADIUS, LENGTH, 1, 1, 1.0), None, 0.1, smallest=0.0005)
    with pytest.raises(LoadBeyondEquilibrium, match=r"cut below 5.000e-04 s.*path=BoundaryMotion") as caught:
        while solver.time < 1.0:
            solver.advance(1.0)
    told = str(caught.value)
    carried = AREA * PER_TIME * solver.time
    assert f"more than a force of {carried:.5g} N on 'end'" in told and "\n" not in told
    assert carried == pytest.approx(79.46e3, rel=5e-3)
    assert caught.value.exit_status == 3
    kept = solver.checkpoint()
    held = bar(necking_bar(RADIUS, LENGTH, 1, 1, 1.0), None, 0.1)
    held.restore(kept)
    assert held.time == solver.time and (held.positions == solver.positions).all()


@pytest.mark.parametrize(
    ("path", "loads", "error", "told"),
    [
        (PathLength(1.0), (Prescribed("top", 1, 1.0),), SceneError, "supports that do not move"),
        (3.0, (), SceneError, "path = 3.0 is none"),
        (BoundaryMotion("topp", 1, 1.0), (), MeshError, "top"),
        (BoundaryMotion("top", 2, 1.0), (), SceneError, "give 0 to 1"),
        (BoundaryMotion("top", 1, 0.0), (), SceneError, "speed = 0.0 m/s"),
        (BoundaryMotion("bottom", 1, 1.0), (), SceneError, "needs a boundary that moves"),
    ],
)
def test_senseless_paths_are_refused(path, loads, error, told):
    """What leads nowhere is refused before anything is solved."""
    mesh, loads = block([0.0, 0.0], [1.0, 1.0], [1, 1]), (Fixed("bottom"), *loads)
    with pytest.raises(error, match=told):
        ImplicitSolver(mesh, STEEL, geometry="plane-strain", loads=loads, increment=1.0, path=path)


@pytest.mark.parametrize(("speed", "weight"), [(0.0, 0.0), (math.nan, 0.0), (1.0, -1.0)])
def test_path_lengths_out_of_range_are_refused(speed, weight):
    """Speeds that are not above 0, weights below 0."""
    with pytest.raises(SceneError, match="is out of range"):
        PathLength(speed, weight)


def test_path_of_a_constant_load_is_refused():
    """A pressure that does not change leaves no path."""
    mesh, loads = block([0.0, 0.0], [1.0, 1.0], [1, 1]), (Fixed("bottom"), Pressure("top", 1e6))
    solver = ImplicitSolver(mesh, STEEL, loads=loads, increment=1.0, path=PathLength(1.0))
    with pytest.raises(SceneError, match="no load changes with time"):
        solver.advance()
