"""From particles to grid: mass, momentum and force.

With N_i the weight of node i, x_i - x_p the vector to it, V the current volume and b a force on the particle:

    m_i = sum_p m_p N_i,   (m v)_i = sum_p m_p N_i (v_p + C_p (x_i - x_p)),
    f_i = sum_p [N_i b_p - V_p (sigma_p grad N_i + hoop stress N_i / r e_r)]

C is the affine velocity of APIC; it is absent in the other transfers. The viscous pressure acts with the stress.
Source: Jiang et al., ACM Trans. Graph. 34 (2015) 51.
"""

import numpy as np

from core_models.compilation import kernel
from core_models.dispatch import generic
from core_models.state import read
from mpm.configurations import pulls
from mpm.geometries import column, hoop_force, stand, vector
from mpm.giving import give
from mpm.grid import RECORD, block_corner
from mpm.lanes import lanes
from mpm.tile import add_tile, clear_tile, place_in_tile


@kernel
def to_grid(
    first, last, scratch, geometry, shape, grid, order, offset, positions, velocities, affine, density, volumes,
    volume_ratio, gradients, stress, viscous, forces, configuration,
):  # fmt: skip
    """Add mass, momentum and force of the particles of some homes to the grid.

    Parameters
    ----------
    first, last : homes of one colour, counted from `offset` in grid.homes; two of one colour share no node.
    positions, velocities (n, d). affine (n, d, d) [1/s] or None. density [kg/m^3] : in the reference body.
    volumes (n,) : reference [m^3]. volume_ratio (n,). stress (n, 6) [Pa]. viscous (n,) [Pa] or None.
    forces (n, d) : on the particles [N], or None. configuration : what positions and stress belong to
    (mpm.configurations); in the total one, gradients (n, 3, 3) turn the stress into that of the reference body.
    """
    tile, stencil = scratch.tile, scratch.stencil
    for number in range(offset + first, offset + last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        clear_tile(geometry, shape, tile, RECORD)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            start = place_in_tile(shape, corner, i, j, k)
            mass = density * volumes[p]
            momentum = mass * vector(geometry, velocities, p, 1.0)
            spin_x = momentum_slope(affine, geometry, p, 0, mass)
            spin_y = momentum_slope(affine, geometry, p, 1, mass)
            spin_z = momentum_slope(affine, geometry, p, 2, mass)
            q = read(viscous, p, 0.0)
            pull_x, pull_y, pull_z, hoop = pulls(
                configuration, geometry, gradients, p, volumes[p], volume_ratio[p], stress[p, 0] - q,
                stress[p, 1] - q, stress[p, 2] - q, stress[p, 3], stress[p, 4], stress[p, 5],
            )  # fmt: skip
            carried = force_on(forces, geometry, p) + hoop_force(geometry, positions, p, hoop)
            give(
                shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z, carried, pull_x,
                pull_y, pull_z,
            )  # fmt: skip
        add_tile(geometry, shape, grid, home, tile)


@generic
def momentum_slope(affine, geometry, p, axis, mass):
    """Slope of particle p's momentum along an axis as lanes [kg/s]; 0 without an affine velocity."""


@momentum_slope.register(np.ndarray)
def _(affine, geometry, p, axis, mass):
    return mass * column(geometry, affine, p, axis)


@momentum_slope.register(type(None))
def _(affine, geometry, p, axis, mass):
    return lanes(0.0, 0.0, 0.0, 0.0)


@generic
def force_on(forces, geometry, p):
    """Force on particle p as lanes [N]."""


@force_on.register(np.ndarray)
def _(forces, geometry, p):
    return vector(geometry, forces, p, 0.0)


@force_on.register(type(None))
def _(forces, geometry, p):
    return lanes(0.0, 0.0, 0.0, 0.0)
