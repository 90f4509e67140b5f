"""From grid to particles: motion, deformation and velocity.

With v the grid's velocity after the forces, L = sum v_i grad N_i, and S w = sum N_i w_i for a field w on the grid:

    x_p moves with S v,   F_p = (1 + dt L) F_p,   v_p = S v + own v_p + share S w

    pic, apic   own = share = 0; APIC also C_p = sum N_i v_i (x_i - x_p)^T D^-1, D = sum N_i (x_i - x_p)(x_i - x_p)^T
    flip        own = alpha, share = -alpha, w = velocity before the forces
    xpic        own = 0, share = 1, w = the filtered velocity before the forces less that velocity (mpm.xpic)

For products of functions along the axes D is diagonal, since they reproduce linear fields axis by axis.
Sources: Brackbill & Ruppel, J. Comput. Phys. 65 (1986) 314; Jiang et al., ACM Trans. Graph. 34 (2015) 51.
"""

import numpy as np

from core_models.compilation import kernel
from core_models.dispatch import generic
from mpm.configurations import deform_particle
from mpm.geometries import put_columns, put_vector, stand, vector
from mpm.grid import VELOCITY, block_corner
from mpm.lanes import fused, lanes
from mpm.taking import interpolate_second, take, total
from mpm.tile import fetch_second, fetch_tile, place_in_tile

ENERGY, SPEED = 0, 1


@kernel
def to_particles(
    first, last, scratch, geometry, shape, grid, order, dt, positions, velocities, affine, second, second_size, own,
    share, density, volumes, old_gradient, new_gradient, moves, new_velocities, volume_ratio, configuration, sums,
):  # fmt: skip
    """Deform the particles with the grid's velocity and give them new velocities.

    Parameters
    ----------
    first, last : homes, in the order of grid.homes. second : flat field w on the grid with records of second_size
    numbers, or None. own, share : see above. density : [kg/m^3]. volumes (n,) : reference [m^3]. configuration : says
    what F becomes (mpm.configurations).
    Written: new_gradient; new_velocities (n, d); moves (n, d), the velocity S v that particles move with [m/s], or
    None where that is the new one; volume_ratio (n,), det F; affine (n, d, d) or None; sums (homes, 2),
    kinetic energy [J] (affine part included) and largest squared speed [m^2/s^2].
    """
    tile, stencil = scratch.tile, scratch.stencil
    for number in range(first, last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        fetch_tile(geometry, shape, grid, home, grid.after, VELOCITY, tile)
        fetch_second(second, geometry, shape, grid, home, second_size, scratch.second)
        energy, fastest = lanes(0.0, 0.0, 0.0, 0.0), 0.0
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            start = place_in_tile(shape, corner, i, j, k)
            v, l_x, l_y, l_z, c_x, c_y, c_z, spin_squares = take(
                shape, affine, geometry, grid, stencil, tile, start, p, t
            )
            put_affine(affine, geometry, p, c_x, c_y, c_z)
            put_moves(moves, geometry, p, v)
            volume_ratio[p] = deform_particle(
                configuration, geometry, old_gradient, new_gradient, p, dt, l_x, l_y, l_z, v, positions
            )
            w = interpolate_second(second, shape, geometry, stencil, scratch.second, start)
            v = new_velocity(second, geometry, velocities, p, own, share, v, w)
            put_vector(geometry, new_velocities, p, v)
            squares = v * v
            fastest = max(fastest, total(squares))
            energy = fused(0.5 * density * volumes[p], squares + spin_squares, energy)
        sums[number, ENERGY] = total(energy)
        sums[number, SPEED] = fastest


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
def put_moves(moves, geometry, p, v):
    """Write the velocity that particle p moves with, if it is kept by itself."""


@put_moves.register(np.ndarray)
def _(moves, geometry, p, v):
    put_vector(geometry, moves, p, v)


@put_moves.register(type(None))
def _(moves, geometry, p, v):
    return
