"""The corners of a convected particle domain among the nodes of a tile; see `mpm.interpolation.cpdi`.

Each corner acts on the 2^d nodes round it like a particle of linear interpolation.
"""

import math

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from mpm.geometries import dimension_of
from mpm.grid import VELOCITY
from mpm.interpolation.cpdi import cross, dot, half_edge, sign
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


@inside_kernel
def moment_at(x, y, z):
    """Second moments of the linear functions about a corner [cells^2]."""
    return lanes(x * (1.0 - x), y * (1.0 - y), z * (1.0 - z), 0.0)


@inside_kernel
def combined(x, y, z, weights):
    """Columns x, y, z of a matrix times a vector."""
    return fused(lane(weights, 0), x, fused(lane(weights, 1), y, lane(weights, 2) * z))
