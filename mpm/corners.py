"""What a particle and the nodes round the corners of its convected domain exchange; see mpm.interpolation.cpdi.

Each corner acts on the 2^d nodes round it like a particle of linear interpolation.
"""

import math

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from mpm.exchange import give, give_momentum, give_slopes, interpolate, smooth, take, times_moment
from mpm.geometries import dimension_of
from mpm.grid import FORCE, RECORD, VELOCITY
from mpm.interpolation.cpdi import ConvectedDomain, cross, dot, half_edge, sign
from mpm.lanes import add_to, fused, lane, lanes, load, store
from mpm.tile import edge_of

# Of a corner's row in the stencil: place from the first node [cells], gradient [1/m], and how many numbers there are.
CORNER, GRADIENT, NUMBERS = 0, 4, 8


@inside_kernel
def put_corners(stencil, geometry, shape, grid, p, t):
    """Write the place and the gradient of each corner of particle p; returns how many there are."""
    a, b, c = (
        half_edge(geometry, shape, p, 0),
        half_edge(geometry, shape, p, 1),
        half_edge(geometry, shape, p, 2),
    )
    d_a, d_b, d_c = cross(b, c), cross(c, a), cross(a, b)
    corners = 1 << dimension_of(geometry)
    volume = dot(a, d_a)
    part = 1.0 / (volume * corners)
    depth = 1.0 if dimension_of(geometry) == 3 else 0.0
    for corner in range(corners):
        u, v, w = sign(corner, 0), sign(corner, 1), sign(corner, 2) * depth
        place = fused(grid.over_h, u * a + v * b + w * c, t)
        store(stencil, NUMBERS * corner + CORNER, place)
        store(stencil, NUMBERS * corner + GRADIENT, part * (u * d_a + v * d_b + w * d_c))
    return corners


@inside_kernel
def lower_node(place, axis):
    """Node below a corner along an axis, counted from the first, and the corner's distance from it [cells]."""
    # Round-off may put the corner that decides on the first node just below it.
    node = min(max(math.floor(lane(place, axis)), 0), 3)
    return int(node), lane(place, axis) - node


@inside_kernel
def mix(distance, below, above):
    """Linear interpolation between what stands at the nodes below and above."""
    return fused(distance, above - below, below)


@generic
def nodes_round(geometry, shape, place, start, size):
    """First of the nodes round a corner, in a tile of records of `size` numbers: its place there, its numbers along the
    axes as lanes, counted from the particle's first, and the corner's distances from it [cells].
    """


@nodes_round.register(Axisymmetric)
@nodes_round.register(PlaneStrain)
def _(geometry, shape, place, start, size):
    (i, x), (j, y) = lower_node(place, 0), lower_node(place, 1)
    return size * (start + i + edge_of(shape) * j), lanes(i + 0.0, j + 0.0, 0.0, 0.0), x, y, 0.0


@nodes_round.register(Spatial)
def _(geometry, shape, place, start, size):
    (i, x), (j, y), (k, z) = lower_node(place, 0), lower_node(place, 1), lower_node(place, 2)
    edge = edge_of(shape)
    return size * (start + i + edge * (j + edge * k)), lanes(i + 0.0, j + 0.0, k + 0.0, 0.0), x, y, z


@inside_kernel
def along_row(tile, at, size, x, part, low, step):
    """Add part times low to the record at a place of a tile, and of low + step to the next one."""
    add_to(tile, at, ((1.0 - x) * part) * low)
    add_to(tile, at + size, (x * part) * (low + step))


@generic
def add_round(geometry, shape, tile, at, size, x, y, z, low, step_x, step_y, step_z):
    """Add to the nodes i, j, k = 0, 1 round a corner its weights times low + i step_x + j step_y + k step_z."""


@add_round.register(Axisymmetric)
@add_round.register(PlaneStrain)
def _(geometry, shape, tile, at, size, x, y, z, low, step_x, step_y, step_z):
    along_row(tile, at, size, x, 1.0 - y, low, step_x)
    along_row(tile, at + size * edge_of(shape), size, x, y, low + step_y, step_x)


@add_round.register(Spatial)
def _(geometry, shape, tile, at, size, x, y, z, low, step_x, step_y, step_z):
    row = size * edge_of(shape)
    layer, high = row * edge_of(shape), low + step_z
    along_row(tile, at, size, x, (1.0 - y) * (1.0 - z), low, step_x)
    along_row(tile, at + row, size, x, y * (1.0 - z), low + step_y, step_x)
    along_row(tile, at + layer, size, x, (1.0 - y) * z, high, step_x)
    along_row(tile, at + layer + row, size, x, y * z, high + step_y, step_x)


@inside_kernel
def in_layer(tile, at, row, x, y):
    """A field at a corner within a layer of nodes, and its parts from the nodes above along the first two axes."""
    a, b = load(tile, at), load(tile, at + VELOCITY)
    c, d = load(tile, at + row), load(tile, at + row + VELOCITY)
    beyond = mix(x, c, d)
    return mix(y, mix(x, a, b), beyond), x * mix(y, b, d), y * beyond


@generic
def field_at(geometry, shape, tile, at, x, y, z):
    """A field in a tile of velocities at a corner, and its parts from the nodes above along each axis."""


@field_at.register(Axisymmetric)
@field_at.register(PlaneStrain)
def _(geometry, shape, tile, at, x, y, z):
    v, v_x, v_y = in_layer(tile, at, VELOCITY * edge_of(shape), x, y)
    return v, v_x, v_y, lanes(0.0, 0.0, 0.0, 0.0)


@field_at.register(Spatial)
def _(geometry, shape, tile, at, x, y, z):
    row = VELOCITY * edge_of(shape)
    a, a_x, a_y = in_layer(tile, at, row, x, y)
    b, b_x, b_y = in_layer(tile, at + row * edge_of(shape), row, x, y)
    return mix(z, a, b), mix(z, a_x, b_x), mix(z, a_y, b_y), z * b


@inside_kernel
def momentum_at(away, momentum, spin_x, spin_y, spin_z):
    """Momentum at a node `away` from the particle [m]."""
    moved = fused(lane(away, 0), spin_x, fused(lane(away, 1), spin_y, momentum))
    return fused(lane(away, 2), spin_z, moved)


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


@inside_kernel
def moment_at(x, y, z):
    """Second moments of the linear functions about a corner [cells^2]."""
    return lanes(x * (1.0 - x), y * (1.0 - y), z * (1.0 - z), 0.0)


@inside_kernel
def combined(x, y, z, weights):
    """Columns x, y, z of a matrix times a vector."""
    return fused(lane(weights, 0), x, fused(lane(weights, 1), y, lane(weights, 2) * z))


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
