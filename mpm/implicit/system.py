"""A body of particles in a grid of splines as a system of equations: forces out of balance and their derivatives."""

import numpy as np

from core_models.equilibrium.gradient_operator import gradient_operator
from core_models.equilibrium.newton import Balance
from core_models.equilibrium.pattern import dofs_of
from core_models.geometry import Geometry
from core_models.loads import Load
from core_models.material import Material
from core_models.points import MaterialPoints, PointFailure
from core_models.status import OK
from core_models.threads import Threads
from mpm.implicit.deformation import CELL_CHUNK, deform_cells
from mpm.implicit.external import ExternalForces
from mpm.implicit.ghost import ghost_faces
from mpm.implicit.grid import SplineGrid, gradients_at
from mpm.implicit.stiffness import make_scratch, stiffen_cells
from mpm.implicit.weak_supports import WeakSupports
from mpm.particles import Particles

UNLOADED = 1e-6
"""Strain below which a body's forces may be round-off: its residual is measured by this strain's."""


class ParticleSystem:
    """`core_models.equilibrium.newton.System` of a body with its supports and loads; x are the grid's coefficients.

    fixed (n, d) : given components. tables : degrees of freedom of cells, ghost faces, faces that are held
    weakly, and faces under pressure.
    forces (n, d) : of cells and ghost faces [N], loads (n, d) or None : from outside
    and of weak supports [N], work : of the points,
    ghost_energy : of the ghost penalty [J], scales (particles,) : s of `deform_cells`; all of the last balance.
    """

    def __init__(
        self, grid: SplineGrid, geometry: Geometry, particles: Particles, points: MaterialPoints, material: Material,
        fixed: np.ndarray, loads: tuple[Load, ...], weak: WeakSupports, share: float, ghost: float,
        threads: Threads,
    ) -> None:  # fmt: skip
        self._grid, self._points, self._threads, self.fixed, self._share = grid, points, threads, fixed, share
        d = grid.places.shape[1]
        self._operator = gradient_operator(geometry, d)
        nodes, self.values, slopes = grid.reach(particles.positions)
        self.nodes = nodes
        self._slopes = gradients_at(geometry, particles.positions, self.values, slopes)
        self._weak = weak
        given = (particles, geometry, grid, (nodes, self.values), self._operator, material.density)
        self._external = ExternalForces(loads, *given)
        self._external_of = lambda load: ExternalForces((load,), *given)
        shear = material.shear_at_rest(material.room_temperature)
        faces, self._ghosts = ghost_faces(grid, geometry, ghost * shear) if ghost else ([], [])
        self._ghost_tables = [d * each + i for each in faces for i in range(d)]
        self._ghosts = [block for block in self._ghosts for _i in range(d)]
        pressed = [dofs_of(faces.nodes, d) for faces in self._external.pressed]
        self.tables = [dofs_of(grid.nodes, d), *self._ghost_tables, *weak.tables, *pressed]
        cells, dofs = self.tables[0].shape
        self._chunks = -(-cells // CELL_CHUNK)
        self._scratch = [make_scratch(dofs) for _thread in range(threads.count)]
        self._forces, self._matrices = np.zeros((cells, dofs)), np.zeros((cells, dofs, dofs))
        self._stresses, self._tangents = np.zeros((points.n, 3, 3)), np.zeros((points.n, 9, 9))
        self._failures = np.zeros((self._chunks, 2), dtype=np.int64)
        self.scales, self._pressures = np.ones(points.n), np.zeros(points.n)
        self._smallest = UNLOADED * shear * float(np.linalg.norm(self._cell_forces())) * dofs**0.5
        self.forces, self.loads, self.work, self.ghost_energy = np.zeros_like(grid.places), None, None, 0.0

    def balance(self, x: np.ndarray, time: float, dt: float) -> Balance:
        """Forces out of balance at x (n, d) [m] at the end of a step dt [s]; PointFailure if that cannot be."""
        self._x, self._time = x, time
        points, grid = self._points, self._grid
        common = (self._slopes, self._operator, points.reference_volumes)
        self._threads.run(
            deform_cells, self._chunks, self._share, grid.starts, grid.order, grid.nodes, *common, x,
            points.deformation_gradient, self.scales, self._failures,
        )  # fmt: skip
        bad = np.flatnonzero(self._failures[:, 0] != OK)
        if bad.size:
            raise PointFailure(*(int(value) for value in self._failures[bad[0]]))
        self.work = points.linearise(dt, self._stresses, self._tangents)
        self._threads.run_with(
            stiffen_cells, self._chunks, self._scratch, self._share, grid.starts, grid.order, *common,
            points.deformation_gradient, self.scales, self._stresses, self._tangents, self._pressures, self._forces,
            self._matrices,
        )  # fmt: skip
        square = float((self._forces**2).sum())
        flat = np.bincount(self.tables[0].ravel(), weights=self._forces.ravel(), minlength=x.size)
        flat += self._resist(x - grid.places)
        self.forces = flat.reshape(x.shape)
        self.loads = self._external.at(x, time)
        if self._weak.names:
            pulled = self._weak.pull(x, time)
            self.loads = pulled if self.loads is None else self.loads + pulled
        residual = -self.forces
        if self.loads is not None:
            residual, square = residual - self.loads, square + float((self.loads**2).sum())
        return Balance(residual, max(square**0.5, self._smallest), self._flowing())

    def forces_of(self, load: Load, x: np.ndarray, time: float) -> np.ndarray:
        """Forces (n, d) [N] of one body force, traction or pressure at x (n, d) [m] and a time [s]."""
        return self._external_of(load).at(x, time)

    def stiffness(self) -> list[np.ndarray]:
        """d residual / d x where `balance` has been last: blocks for each of `tables` [N/m]."""
        pressed = (faces.stiffness(self._x, self._time) for faces in self._external.pressed)
        return [self._matrices, *self._ghosts, *self._weak.blocks, *pressed]

    def _resist(self, u: np.ndarray) -> np.ndarray:
        """Forces (n d,) [N] of the ghost penalty for displacements u (n, d) [m]; notes its energy."""
        flat, forces = u.ravel(), np.zeros(u.size)
        for table, block in zip(self._ghost_tables, self._ghosts, strict=True):
            parts = np.einsum("fab,fb->fa", block, flat[table])
            forces -= np.bincount(table.ravel(), weights=parts.ravel(), minlength=u.size)
        self.ghost_energy = -0.5 * float((forces * flat).sum())
        return forces

    def _cell_forces(self) -> np.ndarray:
        """Volume over size (m,) [m^2] of what there is of the body in each cell."""
        grid, volumes = self._grid, self._points.reference_volumes
        sizes = np.stack([np.diff(axis.lines)[grid.cells[:, i]] for i, axis in enumerate(grid.axes)])
        return np.add.reduceat(volumes[grid.order], grid.starts[:-1]) / sizes.min(axis=0)

    def _flowing(self) -> np.ndarray:
        new, old = self._points.new.equivalent_plastic_strain, self._points.old.equivalent_plastic_strain
        return np.zeros(self._points.n, dtype=np.bool_) if new is None else new > old
