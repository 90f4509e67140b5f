"""What a particle takes from the nodes round it, generic in the interpolation; see `mpm.giving`."""

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from mpm.geometries import depth_of
from mpm.grid import VELOCITY
from mpm.interpolation import half_size, reach, spread
from mpm.lanes import fused, lane, lanes, load
from mpm.tile import MOMENTS, SLOPES, WEIGHTS, edge_of, put_moments, put_stencil


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
