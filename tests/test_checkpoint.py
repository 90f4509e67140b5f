"""Checkpoints of both explicit solvers: what goes on from one is bitwise what would have come."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import SceneError

BEFORE, AFTER = 25, 15  # steps
OPTIONS = {
    "fem-explicit": ("fem-explicit", {}),
    "plane wall": ("fem-explicit", {"wall": "plane"}),
    "mpm": ("mpm", {}),
    "mpm, plane wall": ("mpm", {"wall": "plane"}),
    "mpm, total": ("mpm", {"configuration": "total", "wall": "plane", "cure": "mean-dilatation"}),
    "mpm, cpdi": ("mpm", {"interpolation": "cpdi"}),
}


@pytest.fixture(params=OPTIONS)
def make(request, build, bar, johnson_cook):
    """Make the same solver again and again."""
    method, options = OPTIONS[request.param]
    options = {"velocity": -227.0, "viscosity": BulkViscosity()} | options
    return lambda across=3: build(method, bar(across, 6), johnson_cook, **options)


def run(solver, steps):
    """Make some steps."""
    for _ in range(steps):
        solver.advance()
    return solver


def assert_same(found, expected):
    """Bitwise the same state."""
    found, expected = found.checkpoint(), expected.checkpoint()
    assert set(found) == set(expected)
    for name, value in expected.items():
        assert np.array_equal(found[name], value), name


def test_a_restored_solver_goes_on_bitwise(make):
    """After as many steps more, all that a checkpoint holds is the same as without it."""
    undisturbed = run(make(), BEFORE)
    checkpoint = undisturbed.checkpoint()
    run(undisturbed, AFTER)
    restored = make()
    restored.restore(checkpoint)
    assert_same(run(restored, AFTER), undisturbed)


def test_a_solver_can_be_taken_back(make):
    """A checkpoint restored into the solver that it came from repeats the same steps; it shares no memory with it."""
    solver = run(make(), BEFORE)
    checkpoint = solver.checkpoint()
    kept = {name: value.copy() for name, value in checkpoint.items()}
    after = run(solver, AFTER).checkpoint()
    solver.restore(checkpoint)
    run(solver, AFTER)
    assert all(np.array_equal(solver.checkpoint()[name], value) for name, value in after.items())
    assert all(np.array_equal(checkpoint[name], value) for name, value in kept.items())


def test_the_grid_of_a_body_that_has_travelled_comes_back(build, bar, elastic):
    """The order of sums follows the box of the grid, which has been moved after the body since the start."""

    def make():
        return build("mpm", bar(3, 6, gap=1.0), elastic, velocity=2000.0)

    undisturbed = run(make(), 120)
    first = make().checkpoint()["background.box"]
    checkpoint = undisturbed.checkpoint()
    assert not np.array_equal(checkpoint["background.box"], first)
    restored = make()
    restored.restore(checkpoint)
    assert_same(run(restored, AFTER), run(undisturbed, AFTER))


def test_a_checkpoint_of_another_body_is_refused(make):
    """By what differs, before anything has changed."""
    other, solver = make(across=4), make()
    before = solver.checkpoint()
    with pytest.raises(SceneError, match="has the shape"):
        solver.restore(other.checkpoint())
    assert all(np.array_equal(solver.checkpoint()[name], value) for name, value in before.items())
