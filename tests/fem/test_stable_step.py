"""The estimated stable step against the largest frequency of the body."""

import numpy as np
import pytest
from scipy.linalg import eigvalsh

from meshes.taylor_bar import taylor_bar

LARGEST_LOSS = 1.6  # true stable step over estimated one, for bodies of like elements
LARGEST_LOSS_DISTORTED = 2.0  # where the worst element is worse than its neighbours


@pytest.fixture
def steps(build, elastic):
    """Estimated stable step of a body with its nodes moved to given places, and the true one 2 / omega_max."""

    def compute(mesh, positions):
        def at(places):
            solver = build("fem-explicit", mesh, elastic, safety=1.0)
            solver.positions[:] = places
            solver.advance()
            return solver

        solver = at(positions)
        free = np.column_stack([mesh.points[:, 0] > 0.0, np.ones(len(mesh.points), dtype=bool)])
        step = 1e-6 * positions[:, 0].max()
        columns = []
        for node, axis in np.argwhere(free):
            shift = np.zeros_like(positions)
            shift[node, axis] = step
            change = at(positions - shift).nodal_forces() - at(positions + shift).nodal_forces()
            columns.append(change[free] / (2.0 * step))
        stiffness = np.array(columns)
        masses = np.repeat(solver.nodal_mass[:, None], 2, axis=1)[free]
        largest = eigvalsh(0.5 * (stiffness + stiffness.T), np.diag(masses))[-1]
        return solver.time_step, 2.0 / np.sqrt(largest)

    return compute


def assert_good_bound(estimated, true, largest_loss=LARGEST_LOSS):
    """Below the true step, and not by far."""
    assert estimated <= true
    assert true <= largest_loss * estimated


def test_step_is_a_close_lower_bound_for_squares(steps, bar):
    """A body of square elements, some of them on the axis."""
    mesh = bar(3, 3, gap=2.0)
    assert_good_bound(*steps(mesh, mesh.points))


@pytest.mark.parametrize("seed", range(4))
def test_step_is_a_close_lower_bound_on_a_distorted_mesh(steps, bar, distorted, seed):
    """A body of irregular quads, some of them on the axis."""
    mesh = distorted(bar(2, 3, gap=2.0), 0.25, seed)
    assert_good_bound(*steps(mesh, mesh.points), LARGEST_LOSS_DISTORTED)


@pytest.mark.parametrize("aspect", [3.0, 1.0 / 3.0, 0.1])
def test_step_is_a_close_lower_bound_for_slender_elements(steps, aspect):
    """Elements whose height is another than their width."""
    mesh = taylor_bar(0.8e-3, 1.2e-3 * aspect, 2, 3, foot_height=1e-3)
    assert_good_bound(*steps(mesh, mesh.points))


def test_step_is_a_close_lower_bound_of_a_deformed_body(steps, bar, distorted):
    """A stressed body with unevenly deformed elements."""
    mesh = bar(3, 3, gap=2.0)
    assert_good_bound(*steps(mesh, distorted(mesh, 0.05).points * [1.05, 0.9]))
