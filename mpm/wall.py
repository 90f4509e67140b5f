"""The rigid wall in the plane where the last coordinate is 0: it stops the body's surface, not its nodes.

The wall acts on columns of nodes. The grid's velocity in its plane is the mean of the nodes next to it on both sides;
where the body's surface would pass, an impulse shared by both changes that mean to what just closes the gap. With the
node below the wall the mirror image of the one above, this is the mirror condition, switched on by contact.
Interpolations that reach further do the same with each further pair of nodes.
"""

import math

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from mpm.gaps import FAR
from mpm.geometries import dimension_of
from mpm.grid import EDGE, MASS, RECORD, VELOCITY, node_at
from mpm.interpolation import layers


@kernel
def meet_wall(geometry, shape, grid, dt, friction, gaps, held):
    """Stop the columns of nodes whose material would pass the wall.

    The normal impulse can push only, unless the column is held. The tangential one brings the mean velocity of the
    pair to rest, or as near to that as `friction` (Coulomb's coefficient) times the push allows.

    gaps : (columns,) height of the surface above the wall [m], FAR where no surface is near. held : (columns,) bool,
    columns whose surface has touched a wall that does not let go.
    Returns the normal impulse [N s], the work of normal and tangential impulses, and the change of kinetic energy [J].
    """
    wide, last = EDGE * grid.shape[0], dimension_of(geometry) - 1
    impulse, work, rubbed, energy = 0.0, 0.0, 0.0, 0.0
    for column in range(gaps.shape[0]):
        if gaps[column] == FAR:
            continue
        i, j = column % wide + EDGE * grid.low[0], column // wide + EDGE * grid.low[1]
        target = 0.0 if held[column] else -max(gaps[column], 0.0) / dt
        for layer in range(layers(shape)):
            low, high = wall_node(geometry, grid, i, j, -1 - layer), wall_node(geometry, grid, i, j, layer)
            if low < 0 or high < 0:
                continue
            m_low, m_high = grid.nodes[RECORD * low + MASS], grid.nodes[RECORD * high + MASS]
            if not (m_low > 0.0 and m_high > 0.0):
                continue
            velocity = mean_velocity(grid, low, high, last)
            if velocity >= target and not held[column]:
                continue
            push = (target - velocity) / (0.25 / m_low + 0.25 / m_high)
            energy -= kinetic(grid, low) + kinetic(grid, high)
            work += push_pair(grid, low, high, last, push)
            impulse += push
            if friction > 0.0 and push > 0.0:
                rubbed += rub(grid, low, high, last, friction * push)
            energy += kinetic(grid, low) + kinetic(grid, high)
    return impulse, work, rubbed, energy


@generic
def wall_node(geometry, grid, i, j, row):
    """Number of the node of column (i, j) in a row of nodes along the last axis, or -1."""


@wall_node.register(Axisymmetric)
@wall_node.register(PlaneStrain)
def _(geometry, grid, i, j, row):
    return node_at(geometry, grid, i, row, 0)


@wall_node.register(Spatial)
def _(geometry, grid, i, j, row):
    return node_at(geometry, grid, i, j, row)


@inside_kernel
def mean_velocity(grid, low, high, axis):
    """Mean of two nodes' velocities along an axis after the forces [m/s]."""
    return 0.5 * (grid.after[VELOCITY * low + axis] + grid.after[VELOCITY * high + axis])


@inside_kernel
def kinetic(grid, node):
    """Kinetic energy of a node after the forces [J]."""
    at = VELOCITY * node
    u, v, w = grid.after[at], grid.after[at + 1], grid.after[at + 2]
    return 0.5 * grid.nodes[RECORD * node + MASS] * (u * u + v * v + w * w)


@inside_kernel
def push_pair(grid, low, high, axis, push):
    """Share an impulse between two nodes; returns its work [J]."""
    mean = 0.0
    for node in (low, high):
        before, mass = grid.nodes[RECORD * node + axis], grid.nodes[RECORD * node + MASS]
        v = grid.after[VELOCITY * node + axis] + 0.5 * push / mass
        grid.after[VELOCITY * node + axis] = v
        mean += before + v
    return 0.25 * push * mean


@inside_kernel
def rub(grid, low, high, last, most):
    """Tangential impulse on a pair of nodes, at most `most` [N s]; returns its work [J]."""
    m_low, m_high = grid.nodes[RECORD * low + MASS], grid.nodes[RECORD * high + MASS]
    inverse = 1.0 / (0.25 / m_low + 0.25 / m_high)
    u = mean_velocity(grid, low, high, 0)
    v = mean_velocity(grid, low, high, 1) if last == 2 else 0.0
    needed = inverse * math.sqrt(u * u + v * v)
    share = -inverse * (1.0 if needed <= most else most / needed)
    work = push_pair(grid, low, high, 0, share * u)
    if last == 2:
        work += push_pair(grid, low, high, 1, share * v)
    return work
