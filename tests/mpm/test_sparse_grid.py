"""The grid: only blocks near particles have storage, it follows the body, and particles cannot get lost."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import RunFailure, SceneError

CELL = 0.4e-3


@pytest.fixture
def taylor(build, bar, j2):
    """A coarse Taylor bar."""
    return lambda: build("mpm", bar(3, 9), j2, velocity=-227.0, viscosity=BulkViscosity(), wall="unilateral")


def blocks_of(solver):
    """Blocks with storage, as (x, y, z) counted from the point where cells begin."""
    grid = solver._background.grid
    z, y, x = np.nonzero(grid.table.reshape(grid.shape[::-1]) >= 0)
    return np.column_stack([x, y, z]) + grid.low


def test_only_blocks_near_particles_have_storage(body):
    """Blocks have storage where a particle is at home, or in the next one along an axis, and nowhere else."""
    solver = body("spatial", counts=(9, 6, 13))
    solver.advance()
    first = np.floor(solver.positions / CELL).astype(int) - 1
    near = {tuple(block + step) for block in first >> 2 for step in np.ndindex(2, 2, 2)}
    assert {tuple(block) for block in blocks_of(solver)} == near
    assert solver._background.blocks == len(near)
    assert solver.node_updates == 64 * len(near)


def test_what_lies_elsewhere_does_not_matter(taylor):
    """Storage that no block uses is neither read nor written."""
    clean, strewn = taylor(), taylor()
    for _ in range(30):
        clean.advance()
        strewn.advance()
        background = strewn._background
        used = 16 * background.blocks
        background.grid.nodes[8 * used :] = np.nan
        background.grid.after[4 * used :] = np.nan
    assert np.isnan(background.grid.nodes[8 * used :]).sum() > 10
    assert np.array_equal(clean.positions, strewn.positions)
    assert clean.ledger == strewn.ledger


def test_the_grid_follows_a_body_that_flies_away(build, bar, elastic):
    """A bar that flies far beyond the first grid goes on as if there were no grid."""
    solver = build("mpm", bar(2, 3, gap=1.0), elastic, velocity=800.0)
    start, low = solver.positions.copy(), solver._background.grid.low.copy()
    while solver.positions[:, 1].max() < 6.0 * start[:, 1].max():
        solver.advance()
    assert solver._background.grid.low[1] > low[1]
    assert np.allclose(solver.positions, start + [0.0, 800.0 * solver.time], rtol=1e-9)
    assert solver.momentum[1] == pytest.approx(solver.initial_momentum[1], rel=1e-12)


def test_where_the_grid_begins_makes_no_difference(body):
    """A grid that has been laid anew gives bitwise the same run."""
    moved, still = (body(velocity=lambda x: 30.0 * np.sin(1e4 * x)) for _ in range(2))
    for _ in range(10):
        moved.advance()
        still.advance()
        moved._background.surround(moved.positions + [[5.0 * CELL, -3.0 * CELL]])
        moved._background.surround(np.concatenate([moved.positions, moved.positions + 20.0 * CELL]))
        moved._background.surround(moved.positions)
    assert np.array_equal(moved.positions, still.positions)


@pytest.mark.parametrize("place", [(-1e-3, 1e-3), (1e-3, -3.0 * CELL), (np.nan, 1e-3), (1e-3, np.inf)])
def test_a_particle_that_leaves_the_domain_ends_the_run(taylor, place):
    """The run stops with a RunFailure of one line that names step, time, particle, law and place."""
    solver = taylor()
    solver.advance()
    solver.positions[5] = place
    with pytest.raises(RunFailure, match=r"step 2, t = .* s, point 5 .* has left the domain") as failure:
        solver.advance()
    assert "\n" not in str(failure.value)


def test_a_fragment_that_has_flown_too_far_ends_the_run(body):
    """The run stops with a RunFailure of one line that names the particle and the grid that it would take."""
    solver = body()
    solver.advance()
    solver.positions[5] = (1e5, 1e5)
    with pytest.raises(
        RunFailure, match=r"step 2, .* point 5 .* too far from the others: a grid of .* too large"
    ):
        solver.advance()


def test_the_work_of_a_step_follows_blocks_with_storage_not_the_box(body):
    """With a fragment a hundred bodies away lists of homes and blocks stay short, and nothing stale is left in them."""
    solver = body()
    solver.advance()
    solver.positions[5] += 100.0 * np.ptp(solver.positions, axis=0)
    solver.advance()
    grid, order = solver._background.grid, solver._background.order
    assert len(grid.table) > 1000 > 10 * len(grid.stored)
    assert np.array_equal(np.flatnonzero(grid.table >= 0), grid.stored)
    assert np.array_equal(grid.table[grid.stored], np.arange(len(grid.stored)))
    homes = np.unique(order.keys)
    assert np.array_equal(np.flatnonzero(order.stop), homes)
    assert np.array_equal(
        order.stop[homes] - order.start[homes], np.unique(order.keys, return_counts=True)[1]
    )


def test_a_grid_that_no_memory_would_hold_is_refused(bar, build, elastic):
    """Cells far too small are refused with the number of nodes they would need."""
    with pytest.raises(SceneError, match="too large: give larger cells"):
        build("mpm", bar(2, 3), elastic, cell_size=1e-9)
