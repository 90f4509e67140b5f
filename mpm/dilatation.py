"""Mean dilatation: particles see changes of volume that are means over the cells near them.

An incompressible material allows each velocity field on the grid few changes of volume, and more particles than that
ask for none: they stiffen the body and their pressures oscillate. With H_i the linear functions between the corners of
the cells, V the particles' current volumes, and the projection

    (P a)_p = sum_i H_i(x_p) sum_q V_q H_i(x_q) a_q / sum_q V_q H_i(x_q)

a particle's volume grows by P r instead of by its own r = det F_new / det F_old, and forces come from s + (P p) 1:

    F_new <- (P r / r)^(1/3) F_new,   f_i = - sum_p V_p [s + (P p) 1] grad N_i

with s the deviator and p the mean of the stress, bulk viscosity included. P leaves constants alone and is symmetric
with respect to V: the sum of all volumes stays what it was, and the power of the forces is that of the stress.
The corners lie half a cell off the nodes and on symmetry planes and axis: what is beyond these changes no mean.
Sources: Simo, Taylor & Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177; in increments, for particles, Coombs et
al., Comput. Methods Appl. Mech. Eng. 333 (2018) 1.
"""

import numpy as np

from core_models.compilation import kernel
from core_models.errors import SceneError
from core_models.names import suggestion
from core_models.state import write
from core_models.tensors import THIRD, cube_root, load_tensor, store_tensor
from mpm.background import Background
from mpm.cell_means import PAIR, fetch_means, gather_means, mean_at, stand_in_cell
from mpm.grid import VELOCITY, block_corner, block_nodes, clear

NONE, MEAN = "none", "mean-dilatation"
CURES = (NONE, MEAN)


def find_cure(name: str | None) -> bool:
    """Whether that cure does anything; SceneError for an unknown one, with the nearest name."""
    if name is not None and name not in CURES:
        raise SceneError(f"no locking cure is called {name!r}; {suggestion(name, CURES)}")
    return name == MEAN


@kernel
def take_pressures(first, last, scratch, geometry, shape, grid, order, positions, sums, stress, pressures):
    """Pressures (n,) [Pa] which, taken from the stress (n, 6) of homes first ... last-1, leave s + (P p) 1."""
    tile = scratch.tile
    for number in range(first, last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        fetch_means(geometry, grid, home, sums, tile)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            at, x, y, z = stand_in_cell(geometry, grid, positions, p, corner)
            own = (stress[p, 0] + stress[p, 1] + stress[p, 2]) * THIRD
            pressures[p] = own - mean_at(geometry, tile, at, x, y, z)


@kernel
def take_ratios(
    first, last, scratch, geometry, shape, grid, order, positions, sums, reference, volumes, gradient, volume_ratio,
    stretch,
):  # fmt: skip
    """Let the volumes of the particles of homes first ... last-1 grow by their means.

    reference, volumes (n,) : of the particles in the reference body and before the step [m^3]. gradient (n, 3, 3),
    volume_ratio (n,) : F and J, changed. stretch (n,) : what F has been divided by, written, or None.
    """
    tile = scratch.tile
    for number in range(first, last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        fetch_means(geometry, grid, home, sums, tile)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            at, x, y, z = stand_in_cell(geometry, grid, positions, p, corner)
            change = mean_at(geometry, tile, at, x, y, z) * volumes[p] / (reference[p] * volume_ratio[p])
            # A particle turned inside out stays so, for its points to refuse the step.
            factor = cube_root(change) if change > 0.0 else 1.0
            f = load_tensor(gradient, p)
            store_tensor(
                gradient, p,
                (
                    factor * f[0], factor * f[1], factor * f[2], factor * f[3], factor * f[4], factor * f[5],
                    factor * f[6], factor * f[7], factor * f[8],
                ),
            )  # fmt: skip
            volume_ratio[p] *= change
            write(stretch, p, 1.0 / factor)


class Dilatation:
    """The cure at work, once for the stress that a step begins with and once for the deformation that it makes.

    Parameters
    ----------
    volumes : (n,) of the particles in the reference body [m^3]. is_total : whether the grid covers the reference body.
    """

    def __init__(self, volumes: np.ndarray, is_total: bool) -> None:
        self._reference, self._volumes, self._values = volumes, np.empty_like(volumes), np.empty_like(volumes)
        self._sums = np.zeros(0)
        # The reference body's grid adds to the particles' own F, which is this times the one that the points see.
        self.stretch = np.ones_like(volumes) if is_total else None
        self._new_stretch = np.ones_like(volumes) if is_total else None

    def _gather(self, background: Background, positions: np.ndarray) -> None:
        """Means of the values, weighted with the volumes, at the corners."""
        nodes = block_nodes(background.geometry)
        if len(self._sums) < PAIR * nodes * background.blocks:
            self._sums = np.zeros(PAIR * (len(background.grid.after) // VELOCITY))
        background.threads.run(clear, background.blocks, self._sums, PAIR * nodes)
        background.by_colour(gather_means, positions, self._volumes, self._values, self._sums)

    def average_pressures(
        self,
        background: Background,
        positions: np.ndarray,
        volume_ratio: np.ndarray,
        stress: np.ndarray,
        viscous: np.ndarray | None,
    ) -> np.ndarray:
        """What is to be taken from the stress (n, 6) [Pa] as pressure (n,) in place of the viscous one (n,) or None.

        positions (n, d) : in the grid that has been laid out [m]. volume_ratio (n,) : as the points see it.
        """
        np.multiply(self._reference, volume_ratio, out=self._volumes)
        np.add(stress[:, 0], stress[:, 1], out=self._values)
        self._values += stress[:, 2]
        self._values *= THIRD
        if viscous is not None:
            self._values -= viscous
        self._gather(background, positions)
        pressures = np.empty_like(self._values)
        background.over_homes(take_pressures, positions, self._sums, stress, pressures)
        return pressures

    def average_ratios(
        self, background: Background, positions: np.ndarray, gradient: np.ndarray, volume_ratio: np.ndarray
    ) -> None:
        """Turn F (n, 3, 3) and J (n,) after the step into what the points see; lasts if `accept` is called."""
        np.divide(volume_ratio * self._reference, self._volumes, out=self._values)
        if self.stretch is not None:
            self._values /= self.stretch * self.stretch * self.stretch
        self._gather(background, positions)
        background.over_homes(
            take_ratios, positions, self._sums, self._reference, self._volumes, gradient, volume_ratio,
            self._new_stretch,
        )  # fmt: skip

    def accept(self, background: Background) -> None:
        """Let the last deformation last."""
        if self.stretch is not None:
            self.stretch, self._new_stretch = self._new_stretch, self.stretch
            background.configuration = background.configuration._replace(stretch=self.stretch)
