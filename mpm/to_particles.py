"""From grid to particles: motion, deformation and velocity.

With v the grid's velocity after the forces, L = sum v_i grad N_i, and S w = sum N_i w_i for a field w on the grid:

    x_p moves with S v,   F_p = (1 + dt L) F_p,   v_p = S v + own v_p + share S w

    pic, apic   own = share = 0; APIC also C_p = sum N_i v_i (x_i - x_p)^T D^-1, D = sum N_i (x_i - x_p)(x_i - x_p)^T
    flip        own = alpha, share = -alpha, w = velocity before the forces
    xpic        own = 0, share = 1, w = the filtered velocity before the forces less that velocity (mpm.xpic)

D is diagonal, since the interpolations reproduce linear fields axis by axis.
Sources: Brackbill & Ruppel, J. Comput. Phys. 65 (1986) 314; Jiang et al., ACM Trans. Graph. 34 (2015) 51.
"""

import numpy as np

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from mpm.geometries import deform, depth_of, put_columns, put_vector, stand, vector
from mpm.grid import VELOCITY, block_corner
from mpm.interpolation import half_size, reach, spread
from mpm.lanes import fused, lane, lanes, load
from mpm.tile import (
    MOMENTS,
    SLOPES,
    WEIGHTS,
    edge_of,
    fetch_second,
    fetch_tile,
    place_in_tile,
    put_moments,
    put_stencil,
)

ENERGY, SPEED = 0, 1


@kernel
def to_particles(
    first, last, scratch, geometry, shape, grid, order, dt, positions, velocities, affine, second, second_size, own,
    share, density, volumes, old_gradient, new_gradient, moves, new_velocities, volume_ratio, sums,
):  # fmt: skip
    """Deform the particles with the grid's velocity and give them new velocities.

    Parameters
    ----------
    first, last : homes, in the order of grid.homes. second : flat field w on the grid with records of second_size
    numbers, or None. own, share : see above. density : [kg/m^3]. volumes (n,) : reference [m^3].
    Written: new_gradient; moves (n, d), the velocity S v that particles move with [m/s]; new_velocities (n, d), which
    may be the same array where second is None; volume_ratio (n,), det F; affine (n, d, d) or None; sums (homes, 2),
    kinetic energy [J] (affine part included) and largest squared speed [m^2/s^2].
    """
    tile, stencil = scratch.tile, scratch.stencil
    edge, nodes, depth = edge_of(shape), reach(shape), depth_of(geometry, shape)
    zero = lanes(0.0, 0.0, 0.0, 0.0)
    for number in range(first, last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        fetch_tile(geometry, shape, grid, home, grid.after, VELOCITY, tile)
        fetch_second(second, geometry, shape, grid, home, second_size, scratch.second)
        energy, fastest = 0.0, 0.0
        for place in range(order.start[home], order.start[home + 1]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            start = place_in_tile(shape, corner, i, j, k)
            put_stencil(stencil, geometry, shape, p, t, grid.over_h)
            put_moments(affine, stencil, geometry, shape, p, t, grid.over_h)
            v, l_x, l_y, l_z, c_x, c_y, c_z = zero, zero, zero, zero, zero, zero, zero
            for c in range(depth):
                n, n_x, n_y, n_u, n_w = zero, zero, zero, zero, zero
                for b in range(nodes):
                    row = VELOCITY * (start + edge * (b + edge * c))
                    m, m_x, m_u = zero, zero, zero
                    for a in range(nodes):
                        u = load(tile, row + VELOCITY * a)
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
            put_affine(affine, geometry, p, c_x, c_y, c_z)
            put_vector(geometry, moves, p, v)
            volume_ratio[p] = deform(geometry, old_gradient, new_gradient, p, dt, l_x, l_y, l_z, v, positions)
            w = interpolate_second(second, geometry, shape, scratch.second, stencil, start)
            v = new_velocity(second, geometry, velocities, p, own, share, v, w)
            put_vector(geometry, new_velocities, p, v)
            square = squared(v)
            affine_part = affine_square(affine, geometry, shape, p, t, grid.h, grid.over_h, c_x, c_y, c_z)
            energy += 0.5 * density * volumes[p] * (square + affine_part)
            fastest = max(fastest, square)
        sums[number, ENERGY] = energy
        sums[number, SPEED] = fastest


@inside_kernel
def squared(v):
    """Squared length of a vector in lanes 0 ... 2."""
    return lane(v, 0) * lane(v, 0) + lane(v, 1) * lane(v, 1) + lane(v, 2) * lane(v, 2)


@inside_kernel
def interpolate(geometry, shape, tile, stencil, start):
    """A field in a tile of velocities at the particle whose weights are in the stencil."""
    edge, nodes = edge_of(shape), reach(shape)
    zero = lanes(0.0, 0.0, 0.0, 0.0)
    v = zero
    for c in range(depth_of(geometry, shape)):
        n = zero
        for b in range(nodes):
            row = VELOCITY * (start + edge * (b + edge * c))
            m = zero
            for a in range(nodes):
                m = fused(stencil[WEIGHTS + 4 * a], load(tile, row + VELOCITY * a), m)
            n = fused(stencil[WEIGHTS + 4 * b + 1], m, n)
        v = fused(stencil[WEIGHTS + 4 * c + 2], n, v)
    return v


@generic
def interpolate_second(second, geometry, shape, tile, stencil, start):
    """`interpolate` of a second field, or 0 where there is none."""


@interpolate_second.register(np.ndarray)
def _(second, geometry, shape, tile, stencil, start):
    return interpolate(geometry, shape, tile, stencil, start)


@interpolate_second.register(type(None))
def _(second, geometry, shape, tile, stencil, start):
    return lanes(0.0, 0.0, 0.0, 0.0)


@generic
def new_velocity(second, geometry, velocities, p, own, share, v, w):
    """Velocity that particle p takes from the grid, as lanes."""


@new_velocity.register(np.ndarray)
def _(second, geometry, velocities, p, own, share, v, w):
    return fused(own, vector(geometry, velocities, p, 0.0), fused(share, w, v))


@new_velocity.register(type(None))
def _(second, geometry, velocities, p, own, share, v, w):
    return v


@generic
def put_affine(affine, geometry, p, x, y, z):
    """Write the affine velocity of particle p from its columns, if it has one."""


@put_affine.register(np.ndarray)
def _(affine, geometry, p, x, y, z):
    put_columns(geometry, affine, p, x, y, z)


@put_affine.register(type(None))
def _(affine, geometry, p, x, y, z):
    return


@generic
def affine_square(affine, geometry, shape, p, t, h, over_h, x, y, z):
    """Mean square of the affine velocity with columns x, y, z over its particle, sum D_a C_a . C_a [m^2/s^2]."""


@affine_square.register(np.ndarray)
def _(affine, geometry, shape, p, t, h, over_h, x, y, z):
    d = h * h * spread(shape, t, half_size(shape, p, over_h))
    square = lane(d, 0) * squared(x) + lane(d, 1) * squared(y)
    return square + lane(d, 2) * squared(z)


@affine_square.register(type(None))
def _(affine, geometry, shape, p, t, h, over_h, x, y, z):
    return 0.0
