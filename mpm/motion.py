"""Motion of the grid: velocities from momenta, then forces, then damping."""

from core_models.compilation import kernel
from mpm.grid import FORCE, MASS, RECORD, VELOCITY, block_nodes

BEFORE, AFTER, DAMPED = 0, 1, 2


@kernel
def settle(first, last, geometry, grid, energies):
    """Turn the momenta of the nodes of blocks first ... last-1 into velocities; 0 where there is no mass.

    energies : (blocks, 3), of which the kinetic energy before the forces [J] is written.
    """
    nodes, count = grid.nodes, block_nodes(geometry)
    for block in range(first, last):
        energy = 0.0
        for node in range(block * count, (block + 1) * count):
            at = RECORD * node
            mass = nodes[at + MASS]
            over = 1.0 / mass if mass > 0.0 else 0.0
            u, v, w = over * nodes[at], over * nodes[at + 1], over * nodes[at + 2]
            nodes[at], nodes[at + 1], nodes[at + 2] = u, v, w
            energy += 0.5 * mass * (u * u + v * v + w * w)
        energies[block, BEFORE] = energy


@kernel
def accelerate(first, last, geometry, grid, dt, damping, energies):
    """Velocities of the nodes of blocks first ... last-1 after the forces have acted for dt [s].

    damping : rate of mass-proportional damping [1/s]. energies : (blocks, 3), of which the kinetic energy after the
    forces and what damping has taken [J] are written.
    """
    nodes, after, count = grid.nodes, grid.after, block_nodes(geometry)
    keep = 1.0 - damping * dt
    for block in range(first, last):
        energy, damped = 0.0, 0.0
        for node in range(block * count, (block + 1) * count):
            at, to = RECORD * node, VELOCITY * node
            mass = nodes[at + MASS]
            over = dt / mass if mass > 0.0 else 0.0
            for axis in range(3):
                before = nodes[at + axis]
                v = keep * before + over * nodes[at + FORCE + axis]
                after[to + axis] = v
                energy += 0.5 * mass * v * v
                damped += 0.5 * damping * dt * mass * before * (before + v)
        energies[block, AFTER] = energy
        energies[block, DAMPED] = damped
