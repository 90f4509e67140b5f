"""Explicit material point method: axisymmetric, updated Lagrangian, quadratic B-splines."""

import math

import numpy as np

from core_models.arguments import check_between, check_motion, check_share
from core_models.bulk_viscosity import BulkViscosity, damped_step_factor
from core_models.compilation import CHUNK
from core_models.errors import RunFailure, SceneError
from core_models.ledger import EnergyLedger
from core_models.material import Material
from core_models.names import suggestion
from core_models.points import MaterialPoints, Work
from core_models.redo import VANISHING_STEP, redoing, step_within
from core_models.threads import Threads
from core_models.walls import PLANE, check_wall
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh
from mpm.grid import Grid, make_grid, make_order, sort_particles
from mpm.motion import AFTER, BEFORE, accelerate, measure_gaps, meet_wall
from mpm.particles import GAUSS, LATTICE, seed
from mpm.shape import outline, particle_domains
from mpm.transfer import ENERGY, SPEED, to_grid, to_particles

TRANSFERS = ("apic", "flip")


class Solver:
    """Explicit dynamics of an axisymmetric body that meets a rigid wall at z = 0.

    Parameters
    ----------
    mesh : `meshes.mesh.Mesh` that the particles are seeded from, four in each quad. material : `Material`.
    cell_size : h of the grid [m]. velocity : initial axial velocity [m/s], negative towards the wall.
    temperature : initial [K]. wall : 'unilateral' or 'plane'. viscosity : BulkViscosity or None.
    threads : number of threads. transfer : 'apic' or 'flip'. flip_fraction : share of FLIP in the blend with PIC.
    seeding : 'gauss' or 'lattice'. cfl : part of h / (c + |v|) that is taken as step, in (0, 1].

    `advance` makes one step: particles to grid -> motion of the grid -> wall -> grid to particles -> points.
    """

    method = "mpm"

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        *,
        cell_size: float,
        velocity: float,
        temperature: float | None = None,
        wall: str = "unilateral",
        viscosity: BulkViscosity | None = None,
        threads: int = 1,
        transfer: str = "apic",
        flip_fraction: float = 0.99,
        seeding: str = GAUSS,
        cfl: float = 0.5,
    ) -> None:
        if transfer not in TRANSFERS:
            raise SceneError(f"no transfer is called {transfer!r}; {suggestion(transfer, TRANSFERS)}")
        if seeding not in (GAUSS, LATTICE):
            raise SceneError(f"no seeding is called {seeding!r}: use {GAUSS!r} or {LATTICE!r}")
        check_between("cell_size", cell_size, 0.0, math.inf, "m")
        check_between("cfl", cfl, 0.0, 1.0)
        check_share("flip_fraction", flip_fraction)
        check_motion(velocity, temperature)
        mesh = axisymmetric(mesh)
        self.mesh, self.material, self.wall, self.cfl = mesh, material, check_wall(wall), cfl
        self.cell_size, self.transfer = cell_size, transfer
        self._flip = flip_fraction if transfer == "flip" else -1.0
        self.threads = Threads(threads)
        self.particles = seed(mesh, seeding)
        n = len(self.particles.volumes)
        self.points = MaterialPoints(material, self.particles.volumes, temperature, viscosity, self.threads)
        if self.points.lengths is not None:
            self.points.lengths[:] = cell_size
        self.particle_mass = material.density * self.particles.volumes
        self.positions = self.particles.positions.copy()
        self.velocities = np.tile([0.0, velocity], (n, 1))
        self.affine = np.zeros((n, 2, 2))
        self._volume_ratio = np.ones(n)
        self._next = tuple(
            a.copy() for a in (self.positions, self.velocities, self.affine, self._volume_ratio)
        )
        self._surface, self._surface_corners = self._boundary_faces()
        self._touched = np.zeros(len(self._surface), dtype=np.bool_)
        self._grow_grid()
        self._sums = np.zeros((-(-n // CHUNK), 2))
        self.time, self.step_count, self.point_updates = 0.0, 0, 0
        self.mass = float(self.particle_mass.sum())
        self.initial_momentum = self.momentum
        self.wall_impulse, self.wall_force = 0.0, 0.0
        energy = 0.5 * self.mass * velocity**2
        self.ledger = EnergyLedger(energy, energy)
        self._kinetic = energy
        self.time_step = self._stable_step(abs(velocity), float(self.points.wave_speed.max()), 0.0)
        self._first_step = self.time_step

    def advance(self, limit: float = math.inf) -> None:
        """Make one step; a step that some particle cannot take is redone smaller.

        limit : time not to go beyond [s], later than `time`; it is met exactly.
        Raises RunFailure naming step, time, particle and law when that does not help.
        """
        self._particles_to_grid()
        dt = step_within(self.time_step, limit - self.time)
        taken = redoing(
            self._attempt,
            dt,
            VANISHING_STEP * self._first_step,
            lambda: self.points.place(self.step_count + 1, self.time, int(self.points.wave_speed.argmax())),
            lambda reason: self.points.failure(reason, self.step_count + 1, self.time),
        )
        self.time = limit if taken == limit - self.time else self.time + taken
        self.step_count += 1
        self.point_updates += self.points.n
        self.time_step = self._stable_step(*self._fastest)

    def _particles_to_grid(self) -> None:
        """Sort the particles and fill the grid with their mass, momentum and forces; measure gaps to the wall."""
        points, over_h = self.points, 1.0 / self.cell_size
        outside = sort_particles(self.positions, over_h, self._grid, self._order)
        if outside >= 0:
            self._grow_grid(outside)
            sort_particles(self.positions, over_h, self._grid, self._order)
        stripes = len(self._order.start) - 1
        for parity in range(2):
            self.threads.run(
                to_grid, (stripes - parity + 1) // 2, parity, self._grid, self._order, self.cell_size,
                self.positions, self.velocities, self.affine, self.particle_mass, points.reference_volumes,
                self._volume_ratio, points.old.stress, points.viscous_pressure,
            )  # fmt: skip
        measure_gaps(
            self.cell_size, self.positions, points.old_deformation_gradient, self._surface, self._surface_corners,
            self.wall == PLANE, self._touched, self._gaps, self._held,
        )  # fmt: skip

    def _attempt(self, dt: float) -> None:
        """Move the grid, the particles and the points by dt; nothing of it lasts unless all of it works."""
        grid, points = self._grid, self.points
        x1, v1, c1, j1 = self._next
        self.threads.run(accelerate, len(grid.first), grid, dt, self._row_energies)
        impulse, contact, change = meet_wall(grid, dt, self._gaps, self._held)
        self.threads.run(
            to_particles, len(self._sums), grid, self.cell_size, dt, self._flip, self.positions, self.velocities,
            self.particle_mass, points.old_deformation_gradient, x1, v1, c1, points.deformation_gradient, j1,
            self._sums,
        )  # fmt: skip
        work = points.advance(dt)
        points.accept()
        self._next = (self.positions, self.velocities, self.affine, self._volume_ratio)
        self.positions, self.velocities, self.affine, self._volume_ratio = x1, v1, c1, j1
        self._keep_books(work, impulse, contact, change, dt)

    def _keep_books(self, work: Work, impulse: float, contact: float, change: float, dt: float) -> None:
        """Enter a step that worked in the ledger."""
        ledger = self.ledger
        rows = self._row_energies.sum(axis=0)
        kinetic = float(self._sums[:, ENERGY].sum())
        on_grid_after = float(rows[AFTER]) + change
        ledger.transfer += (self._kinetic - float(rows[BEFORE])) + (on_grid_after - kinetic)
        self._kinetic = kinetic
        # Velocities have had the whole step's force but belong to its middle: half a step's work brings both together.
        ledger.kinetic = kinetic - 0.5 * (work.stress + work.viscous)
        ledger.contact -= contact
        ledger.plastic += work.plastic
        ledger.viscosity += work.viscous
        ledger.strain += work.stress - work.plastic
        self.wall_impulse += impulse
        self.wall_force = impulse / dt
        self._fastest = (float(np.sqrt(self._sums[:, SPEED].max())), work.wave_speed, work.viscous_pressure)

    def _stable_step(self, speed: float, wave_speed: float, viscous_pressure: float) -> float:
        relative = viscous_pressure / (self.material.density * wave_speed**2)
        damping = damped_step_factor(self.points.viscosity, relative)
        return self.cfl * damping * self.cell_size / (wave_speed + speed)

    def _boundary_faces(self) -> tuple[np.ndarray, np.ndarray]:
        """Particle of each boundary face, and the face's two ends relative to it in the reference body."""
        faces = np.concatenate(list(self.particles.faces.values()))
        corners = self.particles.corners
        ends = [corners[faces[:, 0], (faces[:, 1] + k) % 4] for k in range(2)]
        return np.ascontiguousarray(faces[:, 0]), np.ascontiguousarray(np.stack(ends, axis=1))

    def _grow_grid(self, outside: int | None = None) -> None:
        """Make a grid with room for the particles where they are now; RunFailure where that cannot help."""
        if outside is not None:
            r, z = self.positions[outside]
            if not np.isfinite([r, z]).all() or r < 0.0 or z < -self.cell_size:
                raise RunFailure(
                    f"{self.points.place(self.step_count + 1, self.time, outside)}: the particle has left the domain "
                    f"(r = {r:.4g} m, z = {z:.4g} m); check velocity and material, or try another resolution"
                )
        reach = self.positions.max(axis=0)
        self._grid: Grid = make_grid(self.cell_size, 1.5 * reach[0], 1.1 * reach[1])
        rows, columns = self._grid.sums.shape[:2]
        self._held = np.zeros(columns, dtype=np.bool_)
        self._gaps = np.zeros(columns)
        self._row_energies = np.zeros((rows, 2))
        self._order = make_order(len(self.positions), rows)

    @property
    def momentum(self) -> np.ndarray:
        """Momentum (2,) [kg m/s], along the axis."""
        return np.array([0.0, (self.particle_mass * self.velocities[:, 1]).sum()])

    @property
    def in_contact(self) -> bool:
        """Whether the wall has pushed during the last step."""
        return self.wall_force != 0.0

    def point_positions(self) -> np.ndarray:
        """Positions of the particles (n, 2) [m]."""
        return self.positions.copy()

    def point_volumes(self) -> np.ndarray:
        """Current volumes of the particles (n,) [m^3]."""
        return self.points.reference_volumes * self._volume_ratio

    def domains(self) -> np.ndarray:
        """Deformed domains of the particles (n, 4, 2) [m]."""
        return particle_domains(self.particles, self.positions, self.points.old_deformation_gradient)

    def outline(self) -> dict[str, np.ndarray]:
        """Deformed boundary: 'foot' (axis to rim), 'side' (foot to rear), 'rear' (rim to axis), each (k, 2) [m]."""
        return outline(self.particles, self.positions, self.points.old_deformation_gradient)
