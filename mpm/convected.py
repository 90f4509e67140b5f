"""What a particle with a convected domain and the nodes round its corners exchange; see `mpm.interpolation.cpdi`."""

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from mpm.corners import (
    CORNER,
    GRADIENT,
    NUMBERS,
    add_round,
    combined,
    field_at,
    moment_at,
    momentum_at,
    nodes_round,
    put_corners,
)  # fmt: skip
from mpm.geometries import dimension_of
from mpm.giving import give, give_momentum, give_slopes, smooth
from mpm.grid import FORCE, RECORD, VELOCITY
from mpm.interpolation.cpdi import ConvectedDomain, cross, dot, half_edge, sign
from mpm.lanes import fused, lane, lanes, load
from mpm.taking import interpolate, take, times_moment


@give.register(ConvectedDomain)
def _(
    shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z, force, pull_x, pull_y,
    pull_z,
):  # fmt: skip
    corners, zero = put_corners(stencil, geometry, shape, grid, p, t), lanes(0.0, 0.0, 0.0, 0.0)
    part, h = 1.0 / corners, grid.h
    momentum, spin_x, spin_y, spin_z = part * momentum, part * spin_x, part * spin_y, part * spin_z
    force = part * force
    for corner in range(corners):
        place, g = load(stencil, NUMBERS * corner + CORNER), load(stencil, NUMBERS * corner + GRADIENT)
        at, nodes, x, y, z = nodes_round(geometry, shape, place, start, RECORD)
        low = momentum_at(h * (nodes - t), momentum, spin_x, spin_y, spin_z)
        add_round(geometry, shape, tile, at, RECORD, x, y, z, low, h * spin_x, h * spin_y, h * spin_z)
        pulled = fused(lane(g, 0), pull_x, fused(lane(g, 1), pull_y, fused(lane(g, 2), pull_z, force)))
        add_round(geometry, shape, tile, at + FORCE, RECORD, x, y, z, pulled, zero, zero, zero)


@give_momentum.register(ConvectedDomain)
def _(shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z):
    corners = put_corners(stencil, geometry, shape, grid, p, t)
    part, h = 1.0 / corners, grid.h
    momentum, spin_x, spin_y, spin_z = part * momentum, part * spin_x, part * spin_y, part * spin_z
    for corner in range(corners):
        place = load(stencil, NUMBERS * corner + CORNER)
        at, nodes, x, y, z = nodes_round(geometry, shape, place, start, VELOCITY)
        low = momentum_at(h * (nodes - t), momentum, spin_x, spin_y, spin_z)
        add_round(geometry, shape, tile, at, VELOCITY, x, y, z, low, h * spin_x, h * spin_y, h * spin_z)


@give_slopes.register(ConvectedDomain)
def _(shape, geometry, grid, stencil, tile, start, p, t, x, y, z):
    corners, zero = put_corners(stencil, geometry, shape, grid, p, t), lanes(0.0, 0.0, 0.0, 0.0)
    for corner in range(corners):
        place, g = load(stencil, NUMBERS * corner + CORNER), load(stencil, NUMBERS * corner + GRADIENT)
        at, _nodes, u, v, w = nodes_round(geometry, shape, place, start, VELOCITY)
        carried = combined(x, y, z, g)
        add_round(geometry, shape, tile, at, VELOCITY, u, v, w, carried, zero, zero, zero)


@smooth.register(ConvectedDomain)
def _(shape, geometry, grid, stencil, tile, source, start, p, t, mass):
    put_corners(stencil, geometry, shape, grid, p, t)
    zero = lanes(0.0, 0.0, 0.0, 0.0)
    momentum = mass * interpolate(shape, geometry, stencil, source, start)
    give_momentum(shape, geometry, grid, stencil, tile, start, p, t, momentum, zero, zero, zero)


@take.register(ConvectedDomain)
def _(shape, affine, geometry, grid, stencil, tile, start, p, t):
    corners = put_corners(stencil, geometry, shape, grid, p, t)
    part, zero = 1.0 / corners, lanes(0.0, 0.0, 0.0, 0.0)
    v, l_x, l_y, l_z, b_x, b_y, b_z, spread = zero, zero, zero, zero, zero, zero, zero, zero
    for corner in range(corners):
        place, g = load(stencil, NUMBERS * corner + CORNER), load(stencil, NUMBERS * corner + GRADIENT)
        at, nodes, x, y, z = nodes_round(geometry, shape, place, start, VELOCITY)
        u, u_x, u_y, u_z = field_at(geometry, shape, tile, at, x, y, z)
        v = v + u
        l_x, l_y, l_z = fused(lane(g, 0), u, l_x), fused(lane(g, 1), u, l_y), fused(lane(g, 2), u, l_z)
        spread = spread + moment_at(x, y, z)
        away = nodes - t
        b_x = b_x + fused(lane(away, 0), u, u_x)
        b_y = b_y + fused(lane(away, 1), u, u_y)
        b_z = b_z + fused(lane(away, 2), u, u_z)
    scale = part * grid.h
    b_x, b_y, b_z = scale * b_x, scale * b_y, scale * b_z
    c_x, c_y, c_z = over_moment(affine, shape, geometry, p, scale * grid.h * spread, b_x, b_y, b_z)
    return part * v, l_x, l_y, l_z, c_x, c_y, c_z, fused(b_x, c_x, fused(b_y, c_y, b_z * c_z))


@interpolate.register(ConvectedDomain)
def _(shape, geometry, stencil, tile, start):
    corners = 1 << dimension_of(geometry)
    v = lanes(0.0, 0.0, 0.0, 0.0)
    for corner in range(corners):
        place = load(stencil, NUMBERS * corner + CORNER)
        at, _nodes, x, y, z = nodes_round(geometry, shape, place, start, VELOCITY)
        u, _x, _y, _z = field_at(geometry, shape, tile, at, x, y, z)
        v = v + u
    return (1.0 / corners) * v


@inside_kernel
def second_moment(shape, geometry, p, grid_part):
    """Columns of D = 2^-d sum_c sum_i N_i(x_c) (x_i - x_p)(x_i - x_p)^T [m^2]: A A^T and what the grid adds."""
    a, b, c = (
        half_edge(geometry, shape, p, 0),
        half_edge(geometry, shape, p, 1),
        half_edge(geometry, shape, p, 2),
    )
    d_x = lane(a, 0) * a + lane(b, 0) * b + lane(c, 0) * c + lanes(lane(grid_part, 0), 0.0, 0.0, 0.0)
    d_y = lane(a, 1) * a + lane(b, 1) * b + lane(c, 1) * c + lanes(0.0, lane(grid_part, 1), 0.0, 0.0)
    d_z = lane(a, 2) * a + lane(b, 2) * b + lane(c, 2) * c + lanes(0.0, 0.0, lane(grid_part, 2), 0.0)
    return d_x, d_y, d_z


@times_moment.register(ConvectedDomain)
def _(shape, geometry, grid, p, t, x, y, z):
    a, b, c = (
        half_edge(geometry, shape, p, 0),
        half_edge(geometry, shape, p, 1),
        half_edge(geometry, shape, p, 2),
    )
    corners = 1 << dimension_of(geometry)
    depth = 1.0 if dimension_of(geometry) == 3 else 0.0
    spread = lanes(0.0, 0.0, 0.0, 0.0)
    for corner in range(corners):
        edges = sign(corner, 0) * a + sign(corner, 1) * b + (sign(corner, 2) * depth) * c
        _at, _nodes, f, g, h = nodes_round(geometry, shape, fused(grid.over_h, edges, t), 0, 0)
        spread = spread + moment_at(f, g, h)
    d_x, d_y, d_z = second_moment(shape, geometry, p, (grid.h * grid.h / corners) * spread)
    return combined(x, y, z, d_x), combined(x, y, z, d_y), combined(x, y, z, d_z)


@generic
def over_moment(affine, shape, geometry, p, grid_part, x, y, z):
    """Columns of B D^-1 for the columns x, y, z of B; 0 where particles have no affine velocity."""


@over_moment.register(np.ndarray)
def _(affine, shape, geometry, p, grid_part, x, y, z):
    d_x, d_y, d_z = second_moment(shape, geometry, p, grid_part)
    i_x, i_y, i_z = cross(d_y, d_z), cross(d_z, d_x), cross(d_x, d_y)
    over = 1.0 / dot(d_x, i_x)
    return combined(x, y, z, over * i_x), combined(x, y, z, over * i_y), combined(x, y, z, over * i_z)


@over_moment.register(type(None))
def _(affine, shape, geometry, p, grid_part, x, y, z):
    return lanes(0.0, 0.0, 0.0, 0.0), lanes(0.0, 0.0, 0.0, 0.0), lanes(0.0, 0.0, 0.0, 0.0)
