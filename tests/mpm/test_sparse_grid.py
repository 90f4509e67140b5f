"""The grid: only nodes near particles are touched, it grows with the body, and particles cannot get lost."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import RunFailure

CELL = 0.4e-3


@pytest.fixture
def taylor(build, bar, j2):
    """A coarse Taylor bar."""
    return lambda: build("mpm", bar(3, 9), j2, velocity=-227.0, viscosity=BulkViscosity())


def near_particles(solver):
    """Nodes of the smallest row-by-row intervals that hold all nodes within reach of a particle."""
    near = np.zeros(solver._grid.sums.shape[:2], dtype=bool)
    columns = np.floor(solver.positions[:, 0] / CELL).astype(int)
    rows = np.floor(solver.positions[:, 1] / CELL).astype(int) + 1
    for row in range(len(near)):
        reached = columns[(rows <= row) & (row <= rows + 2)]
        if reached.size:
            near[row, reached.min() : reached.max() + 3] = True
    return near


def test_only_nodes_near_particles_are_touched(taylor):
    """What lies elsewhere is neither read (the run stays the same) nor written (it stays what it was)."""
    clean, strewn = taylor(), taylor()
    for _ in range(30):
        far = ~near_particles(strewn)
        for array in (strewn._grid.sums, strewn._grid.before, strewn._grid.after):
            array[far] = np.nan
        clean.advance()
        strewn.advance()
        assert far.sum() > 10
        for array in (strewn._grid.sums, strewn._grid.before, strewn._grid.after):
            assert np.isnan(array[far]).all()
    assert np.array_equal(clean.positions, strewn.positions)
    assert np.array_equal(clean.points.old.stress, strewn.points.old.stress)
    assert clean.ledger == strewn.ledger


def test_the_grid_grows_when_particles_reach_its_end(build, bar, elastic):
    """A bar that flies far beyond the first grid goes on as if there were no grid."""
    solver = build("mpm", bar(2, 3, gap=1.0), elastic, velocity=800.0)
    start, rows = solver.positions.copy(), len(solver._grid.first)
    while solver.positions[:, 1].max() < 4.0 * start[:, 1].max():
        solver.advance()
    assert len(solver._grid.first) > rows
    assert np.allclose(solver.positions, start + [0.0, 800.0 * solver.time], rtol=1e-9)
    assert solver.momentum[-1] == pytest.approx(solver.initial_momentum[-1], rel=1e-12)


def test_a_new_grid_may_be_narrower_than_the_old_one(build, bar, elastic):
    """A body that has become thinner when it outgrows its grid in height goes on."""
    solver = build("mpm", bar(6, 3, gap=1.0), elastic)
    columns = len(solver._held)
    solver.positions *= [0.8, 4.0]
    solver.advance()
    assert len(solver._held) < columns


@pytest.mark.parametrize("place", [(-1e-3, 1e-3), (1e-3, -3.0 * CELL), (np.nan, 1e-3), (1e-3, np.inf)])
def test_a_particle_that_leaves_the_domain_ends_the_run(taylor, place):
    """The run stops with a RunFailure of one line that names step, time, particle, law and place."""
    solver = taylor()
    solver.advance()
    solver.positions[5] = place
    with pytest.raises(RunFailure, match=r"step 2, t = .* s, point 5 .* has left the domain") as failure:
        solver.advance()
    assert "\n" not in str(failure.value)
