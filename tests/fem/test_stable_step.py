"""The estimated stable step against the largest frequency of the body."""

import numpy as np
import pytest
from scipy.linalg import eigvalsh

from fem import ExplicitSolver
from meshes.kinds import KINDS
from meshes.taylor_bar import taylor_bar

LARGEST_LOSS = 1.7  # true stable step over estimated one, linear elements
LARGEST_LOSS_OF_OTHERS = (
    2.6  # quadratic elements, and cures over patches: their own stiffness is less than counted
)
SMALL = {
    "tri6": [2, 1],
    "quad8": [2, 1],
    "quad9": [2, 1],
    "tet10": [1, 1, 1],
    "hex20": [1, 1, 1],
    "hex27": [1, 1, 1],
}


def steps(make, positions):
    """Estimated stable step of an elastic body with its nodes at given places, and the true one 2 / omega_max [s].

    make : from positions to solver.
    """
    solver = make(positions)
    mesh = solver.mesh
    free = np.ones(positions.shape, dtype=bool)
    if type(solver.geometry).__name__ == "Axisymmetric":
        free[:, 0] = mesh.points[:, 0] > 0.0
    shift = 1e-6 * np.ptp(positions, axis=0).max()
    columns = []
    for node, axis in np.argwhere(free):
        moved = np.zeros_like(positions)
        moved[node, axis] = shift
        change = make(positions - moved).nodal_forces() - make(positions + moved).nodal_forces()
        columns.append(change[free] / (2.0 * shift))
    stiffness = np.array(columns)
    masses = np.broadcast_to(solver.nodal_mass[:, None], positions.shape)[free]
    largest = eigvalsh(0.5 * (stiffness + stiffness.T), np.diag(masses))[-1]
    return solver.time_step, 2.0 / np.sqrt(largest)


def test_step_is_a_close_lower_bound_for_every_element(which, element, straight):
    """A small distorted body of each element: below the true step, and not by far."""
    kind = which[1]
    counts = SMALL.get(kind, [2] * KINDS[kind].dimension)
    mesh = straight(kind, counts, 0.2)

    def make(positions):
        return element(which, lambda x: positions - x, mesh, safety=1.0)

    estimated, true = steps(make, mesh.points)
    loss = LARGEST_LOSS if kind in ("quad4", "hex8") else LARGEST_LOSS_OF_OTHERS
    assert estimated <= true <= loss * estimated


@pytest.mark.parametrize("aspect", [3.0, 1.0 / 3.0, 0.1])
def test_step_is_a_close_lower_bound_for_slender_elements(elastic, aspect):
    """Elements whose height is another than their width, at the axis."""
    mesh = taylor_bar(0.8e-3, 1.2e-3 * aspect, 2, 3)

    def make(positions):
        return ExplicitSolver(mesh, elastic, displacement=lambda x: positions - x, safety=1.0)

    estimated, true = steps(make, mesh.points)
    assert estimated <= true <= LARGEST_LOSS * estimated


@pytest.mark.parametrize("seed", range(3))
def test_step_is_a_close_lower_bound_of_a_deformed_body(elastic, bar, distorted, seed):
    """A stressed body with unevenly deformed elements."""
    mesh = bar(3, 3)
    positions = distorted(mesh, 0.1, seed).points * [1.1, 0.8]

    def make(positions):
        return ExplicitSolver(mesh, elastic, displacement=lambda x: positions - x, safety=1.0)

    estimated, true = steps(make, positions)
    assert estimated <= true <= LARGEST_LOSS * estimated


def test_a_swinging_body_stays_bounded_at_the_full_step(which, element):
    """Whatever the element, the step with safety 1 keeps the energy of a shaken block within 20 %."""
    random = np.random.default_rng(4)
    solver = element(which, velocity=lambda x: random.uniform(-1.0, 1.0, x.shape), safety=1.0)
    for _ in range(300):
        solver.advance()
    assert solver.kinetic_energy() < 1.2 * solver.ledger.initial
    assert abs(solver.ledger.relative_error) < 0.2
