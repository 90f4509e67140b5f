"""The background grid at work: it follows the particles, takes what they bring, moves, and gives it back."""

from collections.abc import Sequence

import numpy as np

from core_models.compilation import CHUNK
from core_models.geometry import Geometry
from core_models.threads import Threads
from mpm.anchors import Anchors, Through, particle_shape, point_shape
from mpm.configurations import Total, Updated
from mpm.grid import FORCE, MASS, RECORD, VELOCITY, block_nodes, clear, find_box, make_grid, with_storage
from mpm.interpolation import layers
from mpm.interpolation.catalogue import Interpolation
from mpm.interpolation.cpdi import ConvectedDomain, step_factor
from mpm.mirrors import Mirror, fold, reflect
from mpm.motion import accelerate, carry_affine, settle
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
    be [m]. threads : worker threads. configuration : which body the grid covers.
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
        configuration: Updated | Total,
    ) -> None:
        self.geometry, self.shape, self.threads = geometry, shape, threads
        self.configuration = configuration
        self.cell_size, self.mirrors, self.bounds = cell_size, mirrors, bounds
        self._base = base
        self._pairs = [(mirror.axis, *pair) for mirror in mirrors for pair in mirror.pairs(layers(shape))]
        self._scratch = [make_scratch(len(bounds)) for _thread in range(threads.count)]
        self.blocks = 0
        self._beyond = np.zeros(len(self._pairs))

    def surround(self, positions: np.ndarray) -> None:
        """Make a grid with room for particles at these positions (n, d) [m]."""
        self.box = find_box(self.cell_size, self._base, positions)
        self.renew(len(positions))

    def renew(self, particles: int) -> None:
        """Make the grid of the box anew, for so many particles."""
        self.grid = make_grid(self.cell_size, self._base, self.box, particles)
        self.order = make_order(particles, self.grid)
        self.blocks = 0

    def convect(self, deformation_gradient: np.ndarray) -> None:
        """Let the interpolation know the deformation gradient (n, 3, 3) of the particles, if it depends on it."""
        if isinstance(self.shape, ConvectedDomain):
            self.shape = self.shape._replace(gradient=deformation_gradient)

    def step_factor(self) -> float:
        """What the particles' domains leave of the stable step."""
        if isinstance(self.shape, ConvectedDomain):
            return step_factor(self.shape, self.geometry, self.cell_size, self.threads)
        return 1.0

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
            grid = self.grid._replace(stored=order.stored[: self.blocks])
            self.grid = with_storage(self.geometry, grid, self.blocks)
            self.energies = np.zeros((self.blocks, 2))
            self.sums = np.zeros((int(order.colours[-1]), 2))
        return None

    def fill(self, *particles) -> None:
        """Bring mass, momentum and force of the particles to the grid, then turn momentum into velocity.

        particles : what `to_grid` takes from `positions` to `forces`.
        """
        self.threads.run(clear, self.blocks, self.grid.nodes, RECORD * block_nodes(self.geometry))
        self.by_colour(to_grid, *particles, self.configuration)
        self._beyond[:] = self.fold(self.grid.nodes, RECORD)
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

    def over_homes(self, kernel, *arguments) -> None:
        """Run a kernel that only reads nodes over all homes."""
        self.threads.run_with(
            kernel,
            len(self.sums),
            self._scratch,
            self.geometry,
            self.shape,
            self.grid,
            self.order,
            *arguments,
        )

    @property
    def pairs(self) -> list[tuple[int, int, int]]:
        """Axis, node beyond and its image along the axis, for every layer beyond a symmetry plane."""
        return self._pairs

    def fold(self, records: np.ndarray, size: int) -> list[float]:
        """Add what nodes beyond symmetry planes hold to their mirror images; returns what `mirrors.fold` does."""
        return [fold(self.geometry, self.grid, *pair, records, size) for pair in self._pairs]

    def accelerate(self, dt: float, keep: float) -> None:
        """Velocities after the forces have acted for dt [s]; nodes beyond symmetry planes wait for `reflect`.

        keep : part of the velocities before that damping leaves.
        """
        self.threads.run(accelerate, self.blocks, self.geometry, self.grid, dt, keep, self.energies)

    @property
    def nodes(self) -> int:
        """How many nodes have storage: those of all blocks near particles."""
        return self.blocks * block_nodes(self.geometry)

    def damped_energy(self, keep: float) -> float:
        """What damping has taken [J]: its impulses times the mean of the velocities before and after all else."""
        records = self.grid.nodes.reshape(-1, RECORD)[: self.nodes]
        before, after = records[:, :MASS], self.grid.after.reshape(-1, VELOCITY)[: self.nodes, :MASS]
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
        """Points (k, d) [m] of the surface, held by the nodes that they reach in the grid that has been filled."""
        return Anchors(self.geometry, point_shape(self.shape), self.grid, self._pairs, points)

    def anchors_through(
        self, points: np.ndarray, particles: np.ndarray, positions: np.ndarray, thickness: np.ndarray
    ) -> Anchors:
        """Points (k, d) [m] held through particles (k,) of all these positions (n, d) [m], thickness (k, d) [m]."""
        through = Through(positions[particles], thickness, particle_shape(self.shape, particles))
        return Anchors(self.geometry, point_shape(self.shape), self.grid, self._pairs, points, through)

    def carried(self, positions: np.ndarray, affine: np.ndarray) -> np.ndarray:
        """Affine velocities C (n, d, d) [1/s] times the second moments D of the particles' weights [m^2/s]."""
        carried = np.empty_like(affine)
        chunks = -(-len(positions) // CHUNK)
        self.threads.run(
            carry_affine, chunks, self.geometry, self.shape, self.grid, positions, affine, carried
        )
        return carried

    def power_before(self) -> float:
        """Power of the forces on the nodes, as they have been found moving [W]."""
        return self._power(self.grid.nodes.reshape(-1, RECORD))

    def power(self) -> float:
        """Power of the forces on the nodes, as they move after them [W]."""
        return self._power(self.grid.after.reshape(-1, VELOCITY))

    def _power(self, velocities: np.ndarray) -> float:
        forces = self.grid.nodes.reshape(-1, RECORD)[: self.nodes, FORCE : FORCE + 3]
        return float((forces * velocities[: self.nodes, :3]).sum())

    def give(self, dt: float, *particles) -> np.ndarray:
        """Bring deformation and velocity back; returns the sums of `to_particles`.

        particles : what it takes from `positions` to `volume_ratio`.
        """
        self.threads.run_with(
            to_particles, len(self.sums), self._scratch, self.geometry, self.shape, self.grid, self.order, dt,
            *particles, self.configuration, self.sums,
        )  # fmt: skip
        return self.sums.copy()
