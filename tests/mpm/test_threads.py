"""Threads change how long a run takes, and nothing else."""

import numpy as np

from tests.mpm.conftest import stir


def test_threads_do_not_change_a_bit_in_three_dimensions(body):
    """One and two threads give the same positions, velocities, stresses and energies, with particles at planes too."""
    found = []
    for threads in (1, 2):
        solver = body("spatial", counts=(18, 10, 10), symmetries=["front"], threads=threads)
        stir(solver)
        for _ in range(5):
            solver.advance()
        found.append((solver.positions, solver.velocities, solver.affine, solver.points.old.stress))
        found[-1] += (np.array([solver.ledger.kinetic, solver.ledger.strain]),)
    assert all(np.array_equal(one, two) for one, two in zip(*found, strict=True))
