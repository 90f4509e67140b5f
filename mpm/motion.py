"""Motion of the grid: velocities from momenta, then forces, then damping."""

from core_models.compilation import CHUNK, kernel
from mpm.geometries import column, put_columns, stand
from mpm.grid import FORCE, MASS, RECORD, VELOCITY, block_nodes
from mpm.taking import times_moment

BEFORE, AFTER = 0, 1


@kernel
def settle(first, last, geometry, grid, energies):
    """Turn the momenta of the nodes of blocks first ... last-1 into velocities; 0 where there is no mass.

    energies : (blocks, 2), of which the kinetic energy before the forces [J] is written.
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
def accelerate(first, last, geometry, grid, dt, keep, energies):
    """Velocities of the nodes of blocks first ... last-1 after the forces have acted for dt [s].

    keep : part of the velocities before that damping leaves. energies : (blocks, 2), of which the kinetic energy
    after the forces [J] is written.
    """
    nodes, after, count = grid.nodes, grid.after, block_nodes(geometry)
    for block in range(first, last):
        energy = 0.0
        for node in range(block * count, (block + 1) * count):
            at, to = RECORD * node, VELOCITY * node
            mass = nodes[at + MASS]
            over = dt / mass if mass > 0.0 else 0.0
            for axis in range(3):
                v = keep * nodes[at + axis] + over * nodes[at + FORCE + axis]
                after[to + axis] = v
                energy += 0.5 * mass * v * v
        energies[block, AFTER] = energy


@kernel
def advect(first, last, dt, moves, positions):
    """Move the particles of chunks first ... last-1 with velocities `moves` (n, d) [m/s] for dt [s]."""
    for p in range(first * CHUNK, min(last * CHUNK, positions.shape[0])):
        for axis in range(positions.shape[1]):
            positions[p, axis] += dt * moves[p, axis]


@kernel
def carry_affine(first, last, geometry, shape, grid, positions, affine, carried):
    """C D (n, d, d) [m^2/s] of the particles of chunks first ... last-1: affine velocity times second moment."""
    for p in range(first * CHUNK, min(last * CHUNK, positions.shape[0])):
        _, _, _, t = stand(geometry, shape, grid, positions, p)
        x, y = column(geometry, affine, p, 0), column(geometry, affine, p, 1)
        x, y, z = times_moment(shape, geometry, grid, p, t, x, y, column(geometry, affine, p, 2))
        put_columns(geometry, carried, p, x, y, z)
