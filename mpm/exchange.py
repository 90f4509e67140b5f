"""What a particle and the nodes round it give each other, generic in the interpolation.

What stands here is for interpolations that are products of functions along the axes. Nodes are those of a tile, `start`
the first of a particle's, `stencil` the thread's tables, t the particle's local coordinates.
"""

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from mpm.geometries import depth_of
from mpm.grid import FORCE, RECORD, VELOCITY
from mpm.interpolation import half_size, reach, row, spread
from mpm.lanes import fused, lane, lanes, load, store
from mpm.tile import LEVERS, MOMENTS, OFFSETS, SLOPES, WEIGHTS, edge_of, put_moments, put_offsets, put_stencil


@generic
def give(
    shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z, force, pull_x, pull_y,
    pull_z,
):  # fmt: skip
    """Add momentum, mass and force of particle p to the records of its nodes.

    momentum : with the mass in lane 3. spin_x ... : its slopes along the axes. force : what the weights carry;
    pull_x ... : what their slopes carry, minus volume times the columns of the stress.
    """


@give.otherwise
def _(
    shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z, force, pull_x, pull_y,
    pull_z,
):  # fmt: skip
    put_stencil(stencil, geometry, shape, p, t, grid.over_h)
    put_offsets(stencil, shape, t, grid.h)
    edge, nodes = edge_of(shape), reach(shape)
    # In registers: what is read from memory after each store to the tile would be read again.
    n_x, s_x = row(shape, stencil, WEIGHTS), row(shape, stencil, SLOPES)
    m_x = row(shape, stencil, LEVERS)
    for c in range(depth_of(geometry, shape)):
        n_z, s_z = stencil[WEIGHTS + 4 * c + 2], stencil[SLOPES + 4 * c + 2]
        at_z = fused(stencil[OFFSETS + 4 * c + 2], spin_z, momentum)
        for b in range(nodes):
            n_y, s_y = stencil[WEIGHTS + 4 * b + 1], stencil[SLOPES + 4 * b + 1]
            n_yz = n_y * n_z
            moved = n_yz * fused(stencil[OFFSETS + 4 * b + 1], spin_y, at_z)
            turned = n_yz * spin_x
            carried = fused(s_y * n_z, pull_y, fused(n_y * s_z, pull_z, n_yz * force))
            pull = n_yz * pull_x
            to = RECORD * (start + edge * (b + edge * c))
            for a in range(nodes):
                store(tile, to, fused(m_x[a], turned, fused(n_x[a], moved, load(tile, to))))
                at = to + FORCE
                store(tile, at, fused(s_x[a], pull, fused(n_x[a], carried, load(tile, at))))
                to += RECORD


@generic
def give_momentum(
    shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z
):  # fmt: skip
    """The same for momentum alone, in a tile of records of four numbers."""


@give_momentum.otherwise
def _(shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z):
    put_stencil(stencil, geometry, shape, p, t, grid.over_h)
    put_offsets(stencil, shape, t, grid.h)
    edge, nodes = edge_of(shape), reach(shape)
    n_x, m_x = row(shape, stencil, WEIGHTS), row(shape, stencil, LEVERS)
    for c in range(depth_of(geometry, shape)):
        at_z = fused(stencil[OFFSETS + 4 * c + 2], spin_z, momentum)
        for b in range(nodes):
            weight = stencil[WEIGHTS + 4 * b + 1] * stencil[WEIGHTS + 4 * c + 2]
            moved = weight * fused(stencil[OFFSETS + 4 * b + 1], spin_y, at_z)
            turned = weight * spin_x
            to = VELOCITY * (start + edge * (b + edge * c))
            for a in range(nodes):
                store(tile, to, fused(m_x[a], turned, fused(n_x[a], moved, load(tile, to))))
                to += VELOCITY


@generic
def give_slopes(shape, geometry, grid, stencil, tile, start, p, t, x, y, z):
    """Add x dN/dx + y dN/dy + z dN/dz of particle p to the records of four numbers of its nodes; x, y, z : lanes."""


@give_slopes.otherwise
def _(shape, geometry, grid, stencil, tile, start, p, t, x, y, z):
    put_stencil(stencil, geometry, shape, p, t, grid.over_h)
    edge, nodes = edge_of(shape), reach(shape)
    for c in range(depth_of(geometry, shape)):
        n_z, s_z = stencil[WEIGHTS + 4 * c + 2], stencil[SLOPES + 4 * c + 2]
        for b in range(nodes):
            n_y, s_y = stencil[WEIGHTS + 4 * b + 1], stencil[SLOPES + 4 * b + 1]
            along, across = (n_y * n_z) * x, fused(s_y * n_z, y, (n_y * s_z) * z)
            to = VELOCITY * (start + edge * (b + edge * c))
            for a in range(nodes):
                carried = fused(stencil[WEIGHTS + 4 * a], across, load(tile, to))
                store(tile, to, fused(stencil[SLOPES + 4 * a], along, carried))
                to += VELOCITY


@generic
def smooth(shape, geometry, grid, stencil, tile, source, start, p, t, mass):
    """Add the momentum of particle p with the velocity that its nodes in `source` give it to those in a tile."""


@smooth.otherwise
def _(shape, geometry, grid, stencil, tile, source, start, p, t, mass):
    put_stencil(stencil, geometry, shape, p, t, grid.over_h)
    momentum = mass * interpolate(shape, geometry, stencil, source, start)
    edge, nodes = edge_of(shape), reach(shape)
    n_x = row(shape, stencil, WEIGHTS)
    for c in range(depth_of(geometry, shape)):
        for b in range(nodes):
            to = VELOCITY * (start + edge * (b + edge * c))
            part = stencil[WEIGHTS + 4 * b + 1] * stencil[WEIGHTS + 4 * c + 2] * momentum
            for a in range(nodes):
                store(tile, to, fused(n_x[a], part, load(tile, to)))
                to += VELOCITY


@generic
def take(shape, affine, geometry, grid, stencil, tile, start, p, t):
    """Velocity of particle p, columns of its gradient [1/s] and, if it has that, of its affine velocity [1/s] and what
    sums to the mean square of that [m^2/s^2].
    """


@take.otherwise
def _(shape, affine, geometry, grid, stencil, tile, start, p, t):
    put_stencil(stencil, geometry, shape, p, t, grid.over_h)
    put_moments(affine, stencil, geometry, shape, p, t, grid.over_h)
    edge, nodes = edge_of(shape), reach(shape)
    zero = lanes(0.0, 0.0, 0.0, 0.0)
    v, l_x, l_y, l_z, c_x, c_y, c_z = zero, zero, zero, zero, zero, zero, zero
    for c in range(depth_of(geometry, shape)):
        n, n_x, n_y, n_u, n_w = zero, zero, zero, zero, zero
        for b in range(nodes):
            at = VELOCITY * (start + edge * (b + edge * c))
            m, m_x, m_u = zero, zero, zero
            for a in range(nodes):
                u = load(tile, at + VELOCITY * a)
                m = fused(stencil[WEIGHTS + 4 * a], u, m)
                m_x = fused(stencil[SLOPES + 4 * a], u, m_x)
                m_u = fused(stencil[MOMENTS + 4 * a], u, m_u)
            weight = stencil[WEIGHTS + 4 * b + 1]
            n = fused(weight, m, n)
            n_x = fused(weight, m_x, n_x)
            n_u = fused(weight, m_u, n_u)
            n_y = fused(stencil[SLOPES + 4 * b + 1], m, n_y)
            n_w = fused(stencil[MOMENTS + 4 * b + 1], m, n_w)
        weight = stencil[WEIGHTS + 4 * c + 2]
        v = fused(weight, n, v)
        l_x = fused(weight, n_x, l_x)
        l_y = fused(weight, n_y, l_y)
        l_z = fused(stencil[SLOPES + 4 * c + 2], n, l_z)
        c_x = fused(weight, n_u, c_x)
        c_y = fused(weight, n_w, c_y)
        c_z = fused(stencil[MOMENTS + 4 * c + 2], n, c_z)
    squares = affine_squares(affine, shape, geometry, grid, p, t, c_x, c_y, c_z)
    return v, l_x, l_y, l_z, c_x, c_y, c_z, squares


@generic
def interpolate(shape, geometry, stencil, tile, start):
    """A field in a tile of velocities at the particle whose tables are in the stencil."""


@interpolate.otherwise
def _(shape, geometry, stencil, tile, start):
    edge, nodes = edge_of(shape), reach(shape)
    zero = lanes(0.0, 0.0, 0.0, 0.0)
    v = zero
    for c in range(depth_of(geometry, shape)):
        n = zero
        for b in range(nodes):
            at = VELOCITY * (start + edge * (b + edge * c))
            m = zero
            for a in range(nodes):
                m = fused(stencil[WEIGHTS + 4 * a], load(tile, at + VELOCITY * a), m)
            n = fused(stencil[WEIGHTS + 4 * b + 1], m, n)
        v = fused(stencil[WEIGHTS + 4 * c + 2], n, v)
    return v


@generic
def interpolate_second(second, shape, geometry, stencil, tile, start):
    """`interpolate` of a second field, or 0 where there is none."""


@interpolate_second.register(np.ndarray)
def _(second, shape, geometry, stencil, tile, start):
    return interpolate(shape, geometry, stencil, tile, start)


@interpolate_second.register(type(None))
def _(second, shape, geometry, stencil, tile, start):
    return lanes(0.0, 0.0, 0.0, 0.0)


@generic
def times_moment(shape, geometry, grid, p, t, x, y, z):
    """Columns of C D [m^2/s] for the columns x, y, z of C: D is the second moment of particle p's weights."""


@times_moment.otherwise
def _(shape, geometry, grid, p, t, x, y, z):
    d = grid.h * grid.h * spread(shape, t, half_size(shape, p, grid.over_h))
    return lane(d, 0) * x, lane(d, 1) * y, lane(d, 2) * z


@generic
def affine_squares(affine, shape, geometry, grid, p, t, x, y, z):
    """Lanes that sum to the mean square of the affine velocity C with columns x, y, z over its particle, (C D) . C."""


@affine_squares.register(np.ndarray)
def _(affine, shape, geometry, grid, p, t, x, y, z):
    c_x, c_y, c_z = times_moment(shape, geometry, grid, p, t, x, y, z)
    return fused(c_x, x, fused(c_y, y, c_z * z))


@affine_squares.register(type(None))
def _(affine, shape, geometry, grid, p, t, x, y, z):
    return lanes(0.0, 0.0, 0.0, 0.0)


@inside_kernel
def total(v):
    """Sum of lanes 0 ... 2."""
    return lane(v, 0) + lane(v, 1) + lane(v, 2)
