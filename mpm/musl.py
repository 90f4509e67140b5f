"""Modified update stress last: the velocity gradient is that of the particles' new velocities, mapped once more.

    (m v)_i = sum_p m_p N_i (v_p + C_p (x_i - x_p)),   L_p = sum_i v_i grad N_i

with v_p and C_p after the step. Particles still move with the grid's velocity that they have taken theirs from.
Sources: Sulsky, Zhou & Schreyer, Comput. Phys. Commun. 87 (1995) 236; Nairn, Comput. Model. Eng. Sci. 4 (2003) 649.
"""

import numpy as np

from core_models.compilation import kernel
from core_models.errors import SceneError
from core_models.names import suggestion
from mpm.background import Background
from mpm.geometries import stand, vector
from mpm.giving import give_momentum
from mpm.grid import MASS, RECORD, VELOCITY, block_corner, block_nodes, clear
from mpm.tile import add_velocities, clear_tile, place_in_tile
from mpm.to_grid import momentum_slope

USL, MUSL = "usl", "musl"
UPDATES = (USL, MUSL)


def check_update(name: str) -> None:
    """Refuse an order of updates that does not exist; SceneError with the nearest name."""
    if name not in UPDATES:
        raise SceneError(f"no update is called {name!r}; {suggestion(name, UPDATES)}")


@kernel
def remap(
    first, last, scratch, geometry, shape, grid, order, offset, positions, velocities, affine, density, volumes,
    momenta,
):  # fmt: skip
    """Add the particles' momenta to flat records of four numbers; the rest as in `to_grid`."""
    tile, stencil = scratch.tile, scratch.stencil
    for number in range(offset + first, offset + last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        clear_tile(geometry, shape, tile, VELOCITY)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            start = place_in_tile(shape, corner, i, j, k)
            mass = density * volumes[p]
            momentum = mass * vector(geometry, velocities, p, 0.0)
            spin_x = momentum_slope(affine, geometry, p, 0, mass)
            spin_y = momentum_slope(affine, geometry, p, 1, mass)
            spin_z = momentum_slope(affine, geometry, p, 2, mass)
            give_momentum(
                shape, geometry, grid, stencil, tile, start, p, t, momentum, spin_x, spin_y, spin_z
            )  # fmt: skip
        add_velocities(geometry, shape, grid, home, tile, momenta)


@kernel
def divide_by_mass(first, last, geometry, grid, momenta):
    """Turn momenta into the velocities after the forces at the nodes of blocks first ... last-1; 0 without mass."""
    count = block_nodes(geometry)
    for node in range(first * count, last * count):
        mass = grid.nodes[RECORD * node + MASS]
        over = 1.0 / mass if mass > 0.0 else 0.0
        for axis in range(3):
            grid.after[VELOCITY * node + axis] = over * momenta[VELOCITY * node + axis]


class Remap:
    """Room for the second mapping; moves : (n, d) velocities that come back from it [m/s]."""

    def __init__(self, positions: np.ndarray) -> None:
        self.moves = np.empty_like(positions)
        self._momenta = np.zeros(0)

    def apply(self, background: Background, *particles) -> None:
        """Put the particles' velocities in place of the grid's after the forces, symmetry planes apart.

        particles : what `remap` takes from `positions` to `volumes`; the grid is full of their mass.
        """
        grid = background.grid
        if len(self._momenta) != len(grid.after):
            self._momenta = np.zeros(len(grid.after))
        size = VELOCITY * block_nodes(background.geometry)
        background.threads.run(clear, background.blocks, self._momenta, size)
        background.by_colour(remap, *particles, self._momenta)
        background.fold(self._momenta, VELOCITY)
        background.threads.run(divide_by_mass, background.blocks, background.geometry, grid, self._momenta)
