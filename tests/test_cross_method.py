"""What both methods share: one constitutive library, bitwise, and the same answers."""

import os

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.driver import drive
from core_models.points import MaterialPoints
from meshes.taylor_bar import taylor_bar

CELL, SPEED = 0.4e-3, 227.0
METHODS = ["fem-explicit", "mpm"]
VISCOSITIES = [None, BulkViscosity(0.06, 1.2)]
WATCHED = (0, 3, 13)  # points at foot and axis, and one inside


@pytest.fixture(params=["j2", "johnson_cook"])
def material(request):
    """A hyperelastic and a hypoelastic material."""
    return request.getfixturevalue(request.param)


def values(points):
    """All fields of points by name, without bulk viscosity's pressure, which is no state."""
    return {name: field.array.copy() for name, field in points.fields().items() if name != "viscous_pressure"}


def recorded(solver, count):
    """Time step, deformation gradients and characteristic lengths of all points, step by step."""
    history = []
    for _ in range(count):
        dt = solver.time_step
        solver.advance()
        lengths = None if solver.points.lengths is None else solver.points.lengths.copy()
        history.append((dt, solver.points.old_deformation_gradient.copy(), lengths))
    return history


def replayed(points, place, history, source):
    """Fields at `place` of points that go through what point `source` of a history went through."""
    for dt, gradients, lengths in history:
        points.deformation_gradient[:] = gradients[source]
        if lengths is not None:
            points.lengths[:] = lengths[source]
        points.advance(dt)
        points.accept()
    return {name: array[place] for name, array in values(points).items()}


def assert_same(found, expected, case):
    """Equal names and bitwise equal values."""
    assert found.keys() == expected.keys()
    for name in expected:
        assert np.array_equal(found[name], expected[name]), (case, name)


@pytest.mark.parametrize("viscosity", VISCOSITIES, ids=["inviscid", "viscous"])
@pytest.mark.parametrize("method", METHODS)
def test_one_history_gives_bitwise_the_same_state_everywhere(build, bar, material, method, viscosity):
    """The history of a point of one method through a lone point, an MPM particle and an FEM point: one state."""
    mesh = bar(3, 6)
    solver = build(method, mesh, material, velocity=-SPEED, viscosity=viscosity)
    history = recorded(solver, 60)
    final = values(solver.points)
    assert final["equivalent_plastic_strain"][WATCHED[0]] > 0.05
    for source in WATCHED:
        expected = {name: array[source] for name, array in final.items()}
        lone = MaterialPoints(material, np.ones(1), viscosity=viscosity)
        assert_same(replayed(lone, 0, history, source), expected, "lone point")
        for other in METHODS:
            points = build(other, mesh, material, viscosity=viscosity).points
            assert_same(replayed(points, 17, history, source), expected, other)


@pytest.mark.parametrize("method", METHODS)
def test_the_bare_driver_repeats_a_point_of_a_run(build, bar, material, method):
    """The driver takes the recorded history of a point to bitwise the same state."""
    history = recorded(solver := build(method, bar(3, 6), material, velocity=-SPEED), 60)
    path = np.concatenate([[np.eye(3)], [gradients[WATCHED[0]] for _, gradients, _ in history]])
    driven = drive(material, path, [dt for dt, _, _ in history])
    expected = {name: array[WATCHED[0]] for name, array in values(solver.points).items()}
    assert_same({name: array[-1] for name, array in driven.fields.items()}, expected, "driver")


def test_bulk_viscosity_is_the_same_in_both_methods(build, bar, elastic):
    """A bar compressed at one rate has the pressure of the formula at every point of either method."""
    linear, quadratic, rate = 0.06, 1.2, 1e5
    bulk, shear = elastic.elasticity
    speed = np.sqrt((bulk + 4.0 / 3.0 * shear) / elastic.density)
    expected = elastic.density * CELL * rate * (linear * speed + quadratic**2 * CELL * rate)
    for method in METHODS:
        solver = build(method, bar(3, 4, gap=2.0), elastic, viscosity=BulkViscosity(linear, quadratic))
        solver.time_step = 1e-10
        solver.velocities[:, 1] = -rate * solver.positions[:, 1]
        if method == "mpm":
            solver.affine[:, 1, 1] = -rate
        solver.advance()
        pressure = solver.points.fields()["viscous_pressure"].array
        assert np.allclose(pressure, expected, rtol=1e-4), method


def final_state(solver, count):
    """Everything that a run of some steps leaves."""
    for _ in range(count):
        solver.advance()
    books = vars(solver.ledger) | {
        "time": solver.time,
        "impulse": solver.wall_impulse,
        "dt": solver.time_step,
    }
    return values(solver.points) | {"positions": solver.positions, "velocities": solver.velocities} | books


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one processor")
@pytest.mark.parametrize("method", METHODS)
def test_the_number_of_threads_does_not_change_a_bit(build, bar, johnson_cook, method):
    """One thread, two threads and one thread again: bitwise the same state, energies and step."""
    options = {"velocity": -SPEED, "viscosity": BulkViscosity(0.06, 1.2), "wall": "plane"}
    first, second, third = (
        final_state(build(method, bar(12, 70), johnson_cook, threads=threads, **options), 40)
        for threads in (1, 2, 1)
    )
    assert first["plastic"] > 0.0
    assert_same(second, first, "two threads")
    assert_same(third, first, "second run")


def test_both_methods_agree_on_a_coarse_classic_bar(build, j2):
    """Five elements or cells across: length within 1 %, foot radius and largest plastic strain within 5 and 20 %."""
    across, radius = 5, 3.2e-3
    mesh, found = taylor_bar(radius, 32.4e-3, across), {}
    for method in METHODS:
        options = {"cell_size": radius / across} if method == "mpm" else {}
        viscosity = BulkViscosity(0.0, 1.2)
        solver = build(method, mesh, j2, velocity=-SPEED, wall="plane", viscosity=viscosity, **options)
        while solver.time < 80e-6:
            solver.advance()
        outline = solver.outline()
        strain = solver.points.fields()["equivalent_plastic_strain"].array.max()
        found[method] = outline["rear"][:, 1].mean(), outline["foot"][-1, 0], strain
        assert abs(solver.ledger.relative_error) < 1e-2
    for fem, mpm, tolerance in zip(*(found[method] for method in METHODS), (0.01, 0.05, 0.2), strict=True):
        assert mpm == pytest.approx(fem, rel=tolerance)
