"""How exact the stiffness of an implicit system is, for finite elements and material points alike."""

import numpy as np

STEP = 1e-9  # m, by which an unknown is moved to either side


def stiffness_error(system, x, time, dt):
    """Largest difference of the stiffness from central differences of the residual at x, over its largest entry."""
    system.balance(x, time, dt)
    exact, worst = assembled(system, x.size), 0.0
    for dof in range(x.size):
        shift = np.zeros(x.size)
        shift[dof] = STEP
        high, low = (
            system.balance(x + sign * shift.reshape(x.shape), time, dt).residual.ravel() for sign in (1, -1)
        )
        worst = max(worst, np.abs((high - low) / (2.0 * STEP) - exact[:, dof]).max())
    return worst / np.abs(exact).max()


def assembled(system, size):
    """The dense matrix (size, size) of the blocks of the system's last balance."""
    matrix = np.zeros((size, size))
    for table, blocks in zip(system.tables, system.stiffness(), strict=True):
        for dofs, values in zip(table, blocks, strict=True):
            matrix[np.ix_(dofs, dofs)] += values
    return matrix
