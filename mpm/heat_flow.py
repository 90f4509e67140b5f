"""Heat between particles and grid: the kernels of `mpm.conduction`.

A record of four numbers per node holds its temperature (heat, while that is being summed), its capacity, the heat that
flows into it, and the rise of its temperature.
"""

from core_models.compilation import kernel
from mpm.geometries import put_vector, stand, vector
from mpm.giving import give_momentum, give_slopes
from mpm.grid import VELOCITY, block_corner, block_nodes
from mpm.lanes import lane, lanes
from mpm.mirrors import layer
from mpm.taking import take
from mpm.tile import add_velocities, clear_tile, fetch_tile, place_in_tile

TEMPERATURE, CAPACITY, FLOW, RISE = 0, 1, 2, 3


@kernel
def gather_heat(
    first, last, scratch, geometry, shape, grid, order, offset, positions, capacities, temperature, gradients, field
):  # fmt: skip
    """Add to the nodes the capacities of the particles of some homes, and their heat.

        C_i = sum_p m_p c_p N_i,   (C T)_i = sum_p m_p c_p N_i [T_p + grad T_p . (x_i - x_p)]

    first, last, offset : as in `to_grid`. capacities (n,) [J/K], temperature (n,) [K], gradients (n, d) [K/m] of the
    particles. field : flat, four numbers per node. Without the gradients a linear temperature would be bent next to
    the body's boundary, where nodes see particles on one side only.
    """
    tile, stencil = scratch.tile, scratch.stencil
    for number in range(offset + first, offset + last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        clear_tile(geometry, shape, tile, VELOCITY)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            capacity = capacities[p]
            slope = capacity * vector(geometry, gradients, p, 0.0)
            give_momentum(
                shape, geometry, grid, stencil, tile, place_in_tile(shape, corner, i, j, k), p, t,
                lanes(capacity * temperature[p], capacity, 0.0, 0.0), lanes(lane(slope, 0), 0.0, 0.0, 0.0),
                lanes(lane(slope, 1), 0.0, 0.0, 0.0), lanes(lane(slope, 2), 0.0, 0.0, 0.0),
            )  # fmt: skip
        add_velocities(geometry, shape, grid, home, tile, field)


@kernel
def settle_heat(first, last, geometry, field):
    """Turn the heat of the nodes of blocks first ... last-1 into temperatures; 0 where there is no capacity."""
    count = block_nodes(geometry)
    for node in range(first * count, last * count):
        capacity = field[VELOCITY * node + CAPACITY]
        field[VELOCITY * node + TEMPERATURE] *= 1.0 / capacity if capacity > 0.0 else 0.0


@kernel
def conduct(
    first, last, scratch, geometry, shape, grid, order, offset, positions, conductivity, volumes, volume_ratio,
    gradients, field,
):  # fmt: skip
    """Add to the flow into the nodes what the particles of some homes conduct: - V_p k grad T . grad N_i [W].

    first, last, offset : as in `to_grid`. conductivity [W/(m K)]. volumes (n,) : reference [m^3]. volume_ratio (n,).
    gradients (n, d) : of the nodes' temperatures at the particles [K/m], written. field : flat.
    """
    tile, stencil, flow = scratch.second, scratch.stencil, scratch.tile
    for number in range(offset + first, offset + last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        fetch_tile(geometry, shape, grid, home, field, VELOCITY, tile)
        clear_tile(geometry, shape, flow, VELOCITY)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            start = place_in_tile(shape, corner, i, j, k)
            found = take(shape, None, geometry, grid, stencil, tile, start, p, t)
            x, y, z = lane(found[1], TEMPERATURE), lane(found[2], TEMPERATURE), lane(found[3], TEMPERATURE)
            put_vector(geometry, gradients, p, lanes(x, y, z, 0.0))
            factor = -conductivity * volumes[p] * volume_ratio[p]
            give_slopes(
                shape, geometry, grid, stencil, flow, start, p, t, lanes(0.0, 0.0, factor * x, 0.0),
                lanes(0.0, 0.0, factor * y, 0.0), lanes(0.0, 0.0, factor * z, 0.0),
            )  # fmt: skip
        add_velocities(geometry, shape, grid, home, flow, field)


@kernel
def warm_nodes(first, last, geometry, dt, field):
    """Rises of the temperatures of the nodes of blocks first ... last-1 within dt [s]."""
    count = block_nodes(geometry)
    for node in range(first * count, last * count):
        at = VELOCITY * node
        capacity = field[at + CAPACITY]
        field[at + RISE] = dt * field[at + FLOW] / capacity if capacity > 0.0 else 0.0


@kernel
def warm_particles(
    first, last, scratch, geometry, shape, grid, order, positions, before, decay, field, temperature
):  # fmt: skip
    """Let the particles of homes first ... last-1 take the rises of the nodes, and part with what those do not see.

    before : (n,) temperatures that the nodes have been filled from [K]. decay : part of before - sum_i N_i T_i that
    goes. temperature : (n,) [K], changed.
    """
    tile, stencil = scratch.tile, scratch.stencil
    for number in range(first, last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        fetch_tile(geometry, shape, grid, home, field, VELOCITY, tile)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            start = place_in_tile(shape, corner, i, j, k)
            found = take(shape, None, geometry, grid, stencil, tile, start, p, t)[0]
            temperature[p] += lane(found, RISE) - decay * (before[p] - lane(found, TEMPERATURE))


@kernel
def mirror(geometry, grid, axis, beyond, image, field, column, back):
    """Add a column of the records of the nodes `beyond` along an axis to that of their images, and clear it.

    back : copy the images' to the nodes beyond instead. Temperatures are even across a symmetry plane.
    """
    count = block_nodes(geometry)
    stride, place, steps, offset = layer(grid, axis, beyond, image)
    for block in range(grid.stored.shape[0] if 0 <= place < grid.shape[axis] else 0):
        if (grid.stored[block] // stride) % grid.shape[axis] != place:
            continue
        partner = grid.table[grid.stored[block] + steps * stride]
        if partner < 0:
            continue
        for local in range(count):
            if (local >> (2 * axis)) & 3 != beyond & 3:
                continue
            outer = VELOCITY * (block * count + local) + column
            inner = VELOCITY * (partner * count + local + offset) + column
            if back:
                field[outer] = field[inner]
            else:
                field[inner] += field[outer]
                field[outer] = 0.0
