"""What a particle gives the nodes round it, generic in the interpolation.

What stands here and in `mpm.taking` is for interpolations that are products of functions along the axes. Nodes are
those of a tile, `start` the first of a particle's, `stencil` the thread's tables, t the particle's local coordinates.
"""

from core_models.dispatch import generic
from mpm.geometries import depth_of
from mpm.grid import FORCE, RECORD, VELOCITY
from mpm.interpolation import reach, row
from mpm.lanes import fused, load, store
from mpm.taking import interpolate
from mpm.tile import LEVERS, OFFSETS, SLOPES, WEIGHTS, edge_of, put_offsets, put_stencil


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
