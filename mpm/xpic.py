"""XPIC(m): the grid's velocity before the forces, filtered so that PIC's damping is taken out up to order m.

With S from grid to particles and S+ from particles to grid (by mass), v_1 the velocity of the grid and
v_k = S+ S v_(k-1),

    w = sum_(k = 1 ... m) (-1)^(k + 1) (m over k) v_k

m = 1 is PIC; S w tends to the part of the particles' velocities that the grid can hold as m grows.
Source: Hammerquist & Nairn, Comput. Methods Appl. Mech. Eng. 318 (2017) 724.
"""

import math

import numpy as np

from core_models.compilation import kernel
from mpm.background import Background
from mpm.geometries import stand
from mpm.giving import smooth
from mpm.grid import MASS, RECORD, VELOCITY, block_corner, block_nodes, clear
from mpm.tile import add_velocities, clear_tile, fetch_tile, place_in_tile


@kernel
def resample(
    first, last, scratch, geometry, shape, grid, order, offset, positions, density, volumes, source, size, momenta
):  # fmt: skip
    """Add to the momenta of the nodes what the particles of some homes carry with the velocity S v.

    first, last, offset : as in `to_grid`. source : flat field v with records of `size` numbers. momenta : flat.
    """
    tile, stencil, field = scratch.tile, scratch.stencil, scratch.second
    for number in range(offset + first, offset + last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        fetch_tile(geometry, shape, grid, home, source, size, field)
        clear_tile(geometry, shape, tile, VELOCITY)
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            i, j, k, t = stand(geometry, shape, grid, positions, p)
            start = place_in_tile(shape, corner, i, j, k)
            smooth(shape, geometry, grid, stencil, tile, field, start, p, t, density * volumes[p])
        add_velocities(geometry, shape, grid, home, tile, momenta)


@kernel
def begin(first, last, geometry, grid, factor, correction):
    """correction = factor times the velocity before the forces, at the nodes of blocks first ... last-1."""
    count = block_nodes(geometry)
    for node in range(first * count, last * count):
        for axis in range(VELOCITY):
            correction[VELOCITY * node + axis] = factor * grid.nodes[RECORD * node + axis]


@kernel
def add_term(first, last, geometry, grid, factor, momenta, correction):
    """Turn the momenta of the nodes of blocks first ... last-1 into velocities, and add factor times those."""
    count = block_nodes(geometry)
    for node in range(first * count, last * count):
        mass = grid.nodes[RECORD * node + MASS]
        over = 1.0 / mass if mass > 0.0 else 0.0
        for axis in range(VELOCITY):
            v = over * momenta[VELOCITY * node + axis]
            momenta[VELOCITY * node + axis] = v
            correction[VELOCITY * node + axis] += factor * v


class Filter:
    """The filter of XPIC; order : m, at least 2."""

    def __init__(self, order: int) -> None:
        self._order = order
        self._momenta, self._velocities, self.correction = np.zeros(0), np.zeros(0), np.zeros(0)

    def apply(
        self, background: Background, positions: np.ndarray, density: float, volumes: np.ndarray
    ) -> None:
        """Work out the correction w - v_1 on the grid that has been filled."""
        grid, blocks = background.grid, background.blocks
        if len(self.correction) < len(grid.after):
            self._momenta, self._velocities, self.correction = (np.zeros(len(grid.after)) for _ in range(3))
        threads, geometry = background.threads, background.geometry
        threads.run(begin, blocks, geometry, grid, self._order - 1.0, self.correction)
        source, size = grid.nodes, RECORD
        for k in range(2, self._order + 1):
            factor = (-1.0) ** (k + 1) * math.comb(self._order, k)
            threads.run(clear, blocks, self._momenta, VELOCITY * block_nodes(geometry))
            background.by_colour(resample, positions, density, volumes, source, size, self._momenta)
            background.fold(self._momenta, VELOCITY)
            threads.run(add_term, blocks, geometry, grid, factor, self._momenta, self.correction)
            background.reflect(self._momenta, VELOCITY)
            self._momenta, self._velocities = self._velocities, self._momenta
            source, size = self._velocities, VELOCITY
        background.reflect(self.correction, VELOCITY)
