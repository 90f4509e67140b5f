"""Steps that go wrong, in both methods: redone smaller, else a typed end that leaves the last good state."""

from dataclasses import astuple

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import RunFailure
from core_models.points import PointFailure
from core_models.redo import MAXIMUM_REDOS, REDUCTION
from core_models.status import NOT_CONVERGED

METHODS = ["fem-explicit", "mpm"]
BAD_POINT = 7


@pytest.fixture(params=METHODS)
def running(request, build, bar, johnson_cook):
    """Make a coarse Johnson-Cook bar that has met the wall, after some steps."""

    def make(steps=20):
        solver = build(request.param, bar(3, 6), johnson_cook, velocity=-227.0, viscosity=BulkViscosity())
        for _ in range(steps):
            solver.advance()
        return solver

    return make


def fail(solver, times):
    """Let the next attempts of a solver compute everything and then fail at BAD_POINT; returns the list of steps."""
    advance, tried = solver.points.advance, []

    def failing(dt):
        work = advance(dt)
        tried.append(dt)
        if len(tried) <= times:
            raise PointFailure(NOT_CONVERGED, BAD_POINT)
        return work

    solver.points.advance = failing
    return tried


def everything(solver):
    """Copy of all that a user can read from a solver."""
    state = {name: field.array.copy() for name, field in solver.points.fields().items()}
    for name in ("point_positions", "point_volumes", "domains"):
        state[name] = getattr(solver, name)()
    state |= {f"outline {name}": line.copy() for name, line in solver.outline().items()}
    books = (solver.time, solver.step_count, solver.point_updates, solver.wall_impulse, solver.wall_force)
    return state | {"books": books + astuple(solver.ledger), "velocities": solver.velocities.copy()}


def assert_equal(found, expected):
    """Bitwise equality of two states."""
    for name, value in expected.items():
        assert np.array_equal(found[name], value), name


def test_a_bad_step_is_redone_smaller_and_leaves_no_trace(running):
    """The redone step is bitwise what the smaller step alone would have been, and the run goes on."""
    redone, careful = running(), running()
    planned = redone.time_step
    tried = fail(redone, times=2)
    redone.advance()
    assert tried == [planned, planned * REDUCTION, planned * REDUCTION**2]
    careful.time_step *= REDUCTION**2
    careful.advance()
    assert_equal(everything(redone), everything(careful))
    for _ in range(20):
        redone.advance()
        careful.advance()
    assert_equal(everything(redone), everything(careful))
    assert abs(redone.ledger.relative_error) < 2e-2


def test_a_step_that_stays_bad_ends_the_run_with_the_last_good_state(running):
    """After the last attempt a RunFailure of one line names step, time, point, law and remedy; nothing has moved."""
    solver = running()
    before = everything(solver)
    tried = fail(solver, times=1000)
    with pytest.raises(RunFailure) as failure:
        solver.advance()
    assert len(tried) == MAXIMUM_REDOS + 1
    message = str(failure.value)
    assert "\n" not in message
    for part in (
        "step 21",
        f"t = {solver.time:.6e} s",
        f"point {BAD_POINT}",
        "JohnsonCook",
        "try another resolution",
    ):
        assert part in message
    assert_equal(everything(solver), before)


def test_a_vanishing_step_ends_the_run(running):
    """A step below a millionth of the first one raises RunFailure and names step, time and remedy."""
    solver = running()
    solver.time_step *= 1e-7
    with pytest.raises(RunFailure, match=r"(?=.*step 21)(?=.*t = .* s).*time step has shrunk.*try"):
        solver.advance()


STATE = ["stress", "rotation", "equivalent_plastic_strain", "temperature", "internal_energy"]


@pytest.mark.parametrize("name", STATE)
def test_a_state_that_is_not_a_number_ends_the_run(running, name):
    """NaN in any field of a point's state does not stay silent."""
    solver = running()
    getattr(solver.points.old, name)[BAD_POINT] = np.nan
    with pytest.raises(RunFailure, match="step 2[12]"):
        for _ in range(2):
            solver.advance()


def test_a_velocity_that_is_not_a_number_ends_the_run(running):
    """NaN in a velocity does not stay silent."""
    solver = running()
    solver.velocities[BAD_POINT, 1] = np.nan
    with pytest.raises(RunFailure, match="step 21"):
        solver.advance()
