"""The background grid at work: it follows the particles, takes what they bring, moves, and gives it back."""

from collections.abc import Sequence

import numpy as np

from core_models.compilation import CHUNK
from core_models.geometry import Geometry
from core_models.threads import Threads
from mpm.anchors import Anchors
from mpm.grid import MASS, RECORD, VELOCITY, block_nodes, clear, make_grid, with_storage
from mpm.interpolation import layers
from mpm.interpolation.catalogue import Interpolation
from mpm.mirrors import Mirror, fold, reflect
from mpm.motion import accelerate, measure_spreads, settle
from mpm.order import MOVED, lay_out, locate_particles, make_order, sort_particles
from mpm.tile import make_scratch
from mpm.to_grid import to_grid
from mpm.to_particles import to_particles


class Background:
    """Grid, order of the particles in it, and scratch of the threads.

    Parameters
    ----------
    geometry, shape : of the kernels (core_models.geometry, mpm.interpolation). cell_size : [m].
    base : (3,) point that cells are counted from [m]. mirrors : symmetry planes. bounds : (d, 2) where particles may
    be [m]. threads : worker threads.
    """

    def __init__(
        self,
        geometry: Geometry,
        shape: Interpolation,
        cell_size: float,
        base: np.ndarray,
        mirrors: Sequence[Mirror],
        bounds: np.ndarray,
        threads: Threads,
    ) -> None:
        self.geometry, self.shape, self.threads = geometry, shape, threads
        self.cell_size, self.mirrors, self.bounds = cell_size, mirrors, bounds
        self._base = base
        self._pairs = [(mirror.axis, *pair) for mirror in mirrors for pair in mirror.pairs(layers(shape))]
        self._scratch = [make_scratch(len(bounds)) for _thread in range(threads.count)]
        self.blocks = 0
        self._beyond = [0.0] * len(self._pairs)

    def surround(self, positions: np.ndarray) -> None:
        """Make a grid with room for particles at these positions (n, d) [m]."""
        self.grid = make_grid(self.geometry, self.cell_size, self._base, positions)
        self.order = make_order(len(positions), self.grid)
        self.blocks = 0

    def follow(self, positions: np.ndarray) -> int | None:
        """Sort the particles into the grid; returns the number of one that does not fit in, if there is one."""
        order, seen = self.order, self.order.seen
        self.threads.run(
            locate_particles, len(seen), self.geometry, self.shape, self.grid, self.bounds, positions, order
        )
        if seen.max() >= 0:
            return int(seen[seen >= 0][0])
        if (seen == MOVED).any():
            sort_particles(order)
            self.blocks = lay_out(self.geometry, self.grid, order)
            self.grid = with_storage(self.geometry, self.grid, self.blocks)
            self.energies = np.zeros((self.blocks, 2))
            self.sums = np.zeros((int(order.colours[-1]), 2))
        return None

    def fill(self, *particles) -> None:
        """Bring mass, momentum and force of the particles to the grid, then turn momentum into velocity.

        particles : what `to_grid` takes from `positions` on.
        """
        self.threads.run(clear, self.blocks, self.grid.nodes, RECORD * block_nodes(self.geometry))
        self.by_colour(to_grid, *particles)
        self._beyond = self.fold(self.grid.nodes, RECORD)
        self.threads.run(settle, self.blocks, self.geometry, self.grid, self.energies)
        self.reflect(self.grid.nodes, RECORD)

    def by_colour(self, kernel, *arguments) -> None:
        """Run a kernel that adds to nodes over all homes, those of one colour at a time."""
        # One thread may take all colours at once: the sums are the same, in the same order.
        colours = self.order.colours if self.threads.count > 1 else self.order.colours[[0, -1]]
        for begin, end in zip(colours[:-1].tolist(), colours[1:].tolist(), strict=True):
            self.threads.run_with(
                kernel,
                end - begin,
                self._scratch,
                self.geometry,
                self.shape,
                self.grid,
                self.order,
                begin,
                *arguments,
            )

    def fold(self, records: np.ndarray, size: int) -> list[float]:
        """Add what nodes beyond symmetry planes hold to their mirror images; returns what `mirrors.fold` does."""
        return [fold(self.geometry, self.grid, *pair, records, size) for pair in self._pairs]

    def accelerate(self, dt: float, keep: float) -> None:
        """Velocities after the forces have acted for dt [s]; nodes beyond symmetry planes wait for `reflect`.

        keep : part of the velocities before that damping leaves.
        """
        self.threads.run(accelerate, self.blocks, self.geometry, self.grid, dt, keep, self.energies)

    def damped_energy(self, keep: float) -> float:
        """What damping has taken [J]: its impulses times the mean of the velocities before and after all else."""
        count = self.blocks * block_nodes(self.geometry)
        records = self.grid.nodes.reshape(-1, RECORD)[:count]
        before, after = records[:, :MASS], self.grid.after.reshape(-1, VELOCITY)[:count, :MASS]
        return 0.5 * (1.0 - keep) * float((records[:, MASS, None] * before * (before + after)).sum())

    def reflect(self, velocities: np.ndarray, size: int) -> None:
        """Give the nodes beyond symmetry planes the velocities of their mirror images."""
        for axis, beyond, image in reversed(self._pairs):
            reflect(self.geometry, self.grid, axis, beyond, image, velocities, size)

    def mirror_force(self, mirror: Mirror) -> np.ndarray:
        """Force (d,) [N] of the mirror image on the body across a symmetry plane, at the last filling."""
        force = np.zeros(len(self.bounds))
        for (axis, beyond, image), part in zip(self._pairs, self._beyond, strict=True):
            if axis == mirror.axis and (beyond, image) in mirror.pairs(layers(self.shape)):
                force[axis] -= 2.0 * part
        return force

    def anchors(self, points: np.ndarray) -> Anchors:
        """Points (k, d) [m] of the surface, held in the grid that has been filled."""
        return Anchors(self.geometry, self.shape, self.grid, self._pairs, points)

    def spreads(self, positions: np.ndarray) -> np.ndarray:
        """Second moments of the weights along the axes (n, d) [m^2] at the particles: D of the affine velocity."""
        spreads = np.empty_like(positions)
        chunks = -(-len(positions) // CHUNK)
        self.threads.run(measure_spreads, chunks, self.geometry, self.shape, self.grid, positions, spreads)
        return spreads

    def give(self, dt: float, *particles) -> np.ndarray:
        """Bring deformation and velocity back; see `to_particles`, from `positions` on. Returns its sums."""
        self.threads.run_with(
            to_particles, len(self.sums), self._scratch, self.geometry, self.shape, self.grid, self.order, dt,
            *particles, self.sums,
        )  # fmt: skip
        return self.sums
