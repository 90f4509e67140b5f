"""Sums in a fixed order: no result depends on the number of threads."""

import os

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.loads import Symmetry, gravity
from core_models.walls import Wall
from fem import ExplicitSolver
from meshes.block import block

BODIES = [("hex8", "full"), ("hex8", "reduced"), ("tet4", "full"), ("tet10", "full")]


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one processor")
@pytest.mark.parametrize(("kind", "integration"), BODIES)
def test_two_threads_give_bitwise_the_same_body(j2, kind, integration):
    """Positions, velocities, stress, energies and step of a block that falls on a rough wall."""
    mesh = block([0.0] * 3, [1e-3] * 3, [6, 6, 7], kind)
    found = []
    for threads in (1, 2):
        solver = ExplicitSolver(
            mesh,
            j2,
            integration=integration,
            velocity=[20.0, 0.0, -200.0],
            wall=Wall("unilateral", 0.3),
            loads=(Symmetry("front"), gravity([0.0, 0.0, -1e6])),
            viscosity=BulkViscosity(0.06, 1.2),
            threads=threads,
        )
        for _ in range(25):
            solver.advance()
        state = (solver.positions, solver.velocities, solver.points.fields()["stress"].array)
        found.append(
            (*(array.copy() for array in state), np.array([*vars(solver.ledger).values(), solver.time_step]))
        )
    for one, two in zip(*found, strict=True):
        assert np.array_equal(one, two)
    assert found[0][-1][3] > 0.0
