"""Explicit material point method: updated or total Lagrangian, in the plane, with axial symmetry or in space."""

import math
from typing import Any

import numpy as np

from core_models.arguments import check_between
from core_models.body_checks import check_body
from core_models.bulk_viscosity import BulkViscosity, damped_step_factor
from core_models.compilation import CHUNK
from core_models.errors import RunFailure
from core_models.geometry import Axisymmetric, axis_names, find_geometry
from core_models.ledger import EnergyLedger
from core_models.load_checks import check_loads, damping_of
from core_models.loads import Load, Symmetry, at_time
from core_models.material import Material
from core_models.points import Work
from core_models.redo import VANISHING_STEP, redoing, step_within
from core_models.threads import Threads
from core_models.walls import Wall, as_wall, check_above
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh, check_mesh
from mpm.background import Background
from mpm.body import Body
from mpm.checkpoint import Restartable
from mpm.conduction import Conduction
from mpm.configurations import Total, find_configuration, pull_back
from mpm.contact import Contact, Push
from mpm.dilatation import Dilatation, find_cure
from mpm.forces import Forces
from mpm.fracture import Neighbours
from mpm.grid import RECORD, VELOCITY
from mpm.interpolation.catalogue import check_interpolation, make_interpolation
from mpm.interpolation.cpdi import ConvectedDomain, check_extent
from mpm.limits import bounds_of, check_size
from mpm.mirrors import find_mirrors
from mpm.motion import AFTER, BEFORE, advect
from mpm.musl import MUSL, USL, Remap, check_update
from mpm.particles import GAUSS, rim_faces
from mpm.readout import Readout
from mpm.reference_contact import ReferenceContact
from mpm.stress_power import StressPower
from mpm.supports import Hold, Supports
from mpm.surface import Surface
from mpm.to_particles import ENERGY, SPEED
from mpm.transfers import make_transfer
from mpm.xpic import Filter


class Solver(Readout, Restartable, Body):
    """Explicit dynamics of a body, from a mesh that its particles are seeded from.

    Parameters
    ----------
    mesh : `meshes.mesh.Mesh`. material : `Material`. cell_size : h of the grid [m].
    geometry : 'axisymmetric' (default in 2-D), 'plane-strain' or 'spatial' (default in 3-D).
    velocity : initial [m/s]: a number (along the last axis), a vector (d,), or a function of positions (n, d).
    displacement : initial, a function of positions (n, d) [m], or None. temperature : initial [K].
    loads : of `core_models.loads`. wall : `Wall`, 'unilateral', 'plane' or None. viscosity : BulkViscosity or None.
    threads : number of threads. conduction : whether heat is conducted (core_models.conduction), else the body is
    adiabatic. interpolation : 'quadratic', 'cubic', 'linear', 'gimp' or 'cpdi'.
    transfer : 'apic', 'flip', 'pic' or 'xpic'. flip_fraction : share of FLIP in the blend with PIC.
    xpic_order : m of XPIC(m). update : of the stress, 'usl' (last) or 'musl' (last, modified).
    configuration : that the grid covers, 'updated' (the body as it is) or 'total' (the reference body).
    cure : of volumetric locking, 'mean-dilatation' or None. seeding : 'gauss' or 'lattice'.
    cfl : part of h / (c + |v|), in the total configuration of h / (c |F^-1|), that is taken as step, in (0, 1].

    `advance` makes one step: particles to grid -> motion of the grid -> wall -> grid to particles -> points.
    Velocities belong to the middle of the last step, positions and stress to its end.
    """

    method = "mpm"

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        *,
        cell_size: float,
        geometry: str | None = None,
        velocity: Any = 0.0,
        displacement: Any = None,
        temperature: float | None = None,
        loads: tuple[Load, ...] = (),
        wall: Wall | str | None = None,
        viscosity: BulkViscosity | None = None,
        threads: int = 1,
        conduction: bool = False,
        interpolation: str = "quadratic",
        transfer: str = "apic",
        flip_fraction: float = 0.99,
        xpic_order: int = 2,
        update: str = USL,
        configuration: str = "updated",
        cure: str | None = None,
        seeding: str = GAUSS,
        cfl: float = 0.5,
    ) -> None:
        check_mesh(mesh)
        check_body(material, temperature, viscosity)
        check_interpolation(interpolation)
        check_update(update)
        cured = find_cure(cure)
        frame = find_configuration(configuration, interpolation, conduction)
        self._transfer = make_transfer(transfer, flip_fraction, xpic_order)
        check_between("cell_size", cell_size, 0.0, math.inf, "m")
        self.cfl = check_between("cfl", cfl, 0.0, 1.0)
        kind = find_geometry(geometry, mesh.dimension)
        mesh = axisymmetric(mesh) if isinstance(kind, Axisymmetric) else mesh
        wall = as_wall(wall)
        self._agreement = check_loads(loads, mesh, kind, conduction=conduction)
        check_above(wall, mesh.points, kind)
        base, mirrors = find_mirrors(mesh, kind, loads, wall, cell_size)
        check_size(mesh, kind, cell_size, mirrors)
        super().__init__(
            mesh, material, kind, Threads(threads), seeding=seeding, velocity=velocity, displacement=displacement,
            temperature=temperature, viscosity=viscosity, affine=self._transfer.affine, conduction=conduction,
            configuration=frame,
        )  # fmt: skip
        if self.points.lengths is not None:
            self.points.lengths[:] = cell_size
        self.cell_size, self.transfer, self.wall = cell_size, transfer, wall
        shape = make_interpolation(
            interpolation,
            cell_size,
            mesh,
            seeding,
            self.particles.areas,
            self.points.old_deformation_gradient,
        )
        bounds = bounds_of(mesh, cell_size, base, mirrors, wall)
        self._background = Background(kind, shape, cell_size, base, mirrors, bounds, self.threads, frame)
        is_total = isinstance(frame, Total)
        # Where the particles are in the body that the grid covers: this array itself moves along in the updated one.
        self._places = self.reference_positions if is_total else self.positions
        self._cure = Dilatation(self.points.reference_volumes, is_total) if cured else None
        if self._cure is not None:
            self._cure.accept(self._background)
        self._background.surround(self._places)
        mirrored = [load.boundary for load in loads if isinstance(load, Symmetry)]
        self._contact = None
        if wall is not None:
            rim = rim_faces(mesh, kind, seeding, self.particles, mirrored)
            if is_total:
                self._contact = ReferenceContact(wall, Surface(rim, self.particles, kind))
            else:
                self._contact = Contact(wall, rim)
        self._filter = Filter(self._transfer.order) if self._transfer.order else None
        self._remap = Remap(self.positions) if update == MUSL else None
        self._damping = damping_of(loads)
        self._forces = Forces(loads, self.particles, kind, material.density)
        self._supports = Supports(loads, self.particles, kind)
        self._conduction = None
        if conduction:
            self._conduction = Conduction(loads, self.particles, kind, self.points, cell_size)
        self._waves = np.zeros(-(-self.points.n // CHUNK)) if is_total else None
        self._new_velocities = np.empty_like(self.velocities)
        self._moves = np.empty_like(self.velocities) if self._transfer.share else None
        self._filled = False
        self._reactions: dict[str, np.ndarray] = {}
        self._neighbours: Neighbours | None = None
        self.time, self.step_count, self.point_updates, self._last_step = 0.0, 0, 0, 0.0
        self.initial_momentum = self.momentum
        self.wall_impulse, self.wall_force = 0.0, 0.0
        self._kinetic, self._stress_power, self._ahead = self._particle_energy(), 0.0, 0.0
        self._powers = StressPower(self.points)
        stored, dissipated = self.stored_energy, self.plastic_energy
        self.ledger = EnergyLedger(
            self._kinetic + stored + dissipated, self._kinetic, stored, plastic=dissipated
        )
        self.time_step = self._stable_step(self._speed(), float(self.points.wave_speed.max()), 0.0)
        self._first_step = self.time_step

    def advance(self, limit: float = math.inf) -> None:
        """Make one step; a step that some particle cannot take is redone smaller.

        limit : time not to go beyond [s], later than `time`; it is met exactly.
        Raises RunFailure naming step, time, particle and law when that does not help.
        """
        if not self._filled:
            self._fill()
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
        self._last_step, self._filled = taken, False
        self.time_step = self._stable_step(*self._fastest)

    def _fill(self) -> None:
        """Fill the grid with what the particles bring, and measure gaps to the wall."""
        points, background = self.points, self._background
        outside = background.follow(self._places)
        if outside is not None:
            self._check_inside(outside)
            background.surround(self._places)
            background.follow(self._places)
        viscous = points.viscous_pressure
        if self._cure is not None:
            viscous = self._cure.average_pressures(
                background, self._places, self.volume_ratio, points.old.stress, viscous
            )
        background.fill(
            self._places, self.velocities, self.affine, self.material.density, points.reference_volumes,
            self.volume_ratio, points.old_deformation_gradient, points.old.stress, viscous,
            self._forces.on_particles(self.time, self.positions),
        )  # fmt: skip
        if self._filter is not None:
            self._filter.apply(background, self._places, self.material.density, points.reference_volumes)
        self._forces.load_surfaces(
            background, self.time, self._places, self.positions, points.old_deformation_gradient
        )
        if self._contact is not None:
            self._contact.measure(background, self.positions, points.old_deformation_gradient)
        # A step that fails for good leaves the grid as it is: what it was filled from may have been overwritten.
        self._filled = True

    def _attempt(self, dt: float) -> None:
        """Move the grid, the particles and the points by dt; nothing of it lasts unless all of it works."""
        background, points, transfer = self._background, self.points, self._transfer
        kick = 0.5 * (self._last_step + dt)
        keep = math.exp(-kick * at_time(self._damping.rate, self.time)) if self._damping else 1.0
        background.accelerate(kick, keep)
        hold, push = self._constrain(dt)
        second, size = (background.grid.nodes, RECORD) if transfer.keeps_velocity else (None, 0)
        if self._filter is not None:
            second, size = self._filter.correction, VELOCITY
        sums = background.give(
            dt, self._places, self.velocities, self.affine, second, size, transfer.own, transfer.share,
            self.material.density, points.reference_volumes, points.old_deformation_gradient,
            points.deformation_gradient, self._moves, self._new_velocities, self.volume_ratio,
        )  # fmt: skip
        moves = self._new_velocities if self._moves is None else self._moves
        found, power = self._forces.power_before(self.velocities), self._forces.power(moves)
        damped = background.damped_energy(keep) if self._damping else 0.0
        lost = 0.0 if self._remap is None else self._deform_again(dt, dt * power)
        if self._cure is not None:
            self._cure.average_ratios(
                background, self._places, points.deformation_gradient, self.volume_ratio
            )
        work = points.advance(dt)
        points.accept()
        if self._cure is not None:
            self._cure.accept(background)
        self._conduct(dt)
        background.convect(points.old_deformation_gradient)
        self.threads.run(advect, -(-points.n // CHUNK), dt, moves, self.positions)
        self.velocities, self._new_velocities = self._new_velocities, self.velocities
        self._keep_books(work, found, power, damped, lost, hold, push, sums, dt)

    def _constrain(self, dt: float) -> tuple[Hold, Push]:
        """Change the grid's velocity after the forces to what supports, wall and symmetry planes allow."""
        background = self._background
        middle = self.time + 0.5 * dt
        self._agreement.check(middle)
        earlier = self.time - 0.5 * self._last_step if self.step_count else middle
        hold = self._supports.impose(
            background, earlier, middle, self.positions, self.points.old_deformation_gradient
        )
        push = Push() if self._contact is None else self._contact.meet(background, dt)
        background.reflect(background.grid.after, VELOCITY)
        return hold, push

    def _deform_again(self, dt: float, external: float) -> float:
        """Deform the particles by their own new velocities instead (mpm.musl); external : work of the loads [J].

        Returns the energy that this has lost [J]: what the grid's motion has put in less what the stress gets.
        """
        points, moves = self.points, self._remap.moves
        given = dt * self._background.power() - external
        self._remap.apply(
            self._background, self._places, self._new_velocities, self.affine, self.material.density,
            points.reference_volumes,
        )  # fmt: skip
        self._constrain(dt)
        self._background.give(
            dt, self._places, self.velocities, None, None, 0, 0.0, 0.0, self.material.density,
            points.reference_volumes, points.old_deformation_gradient, points.deformation_gradient, None, moves,
            self.volume_ratio,
        )  # fmt: skip
        taken = dt * (self._background.power() - self._forces.power(moves))
        # Half of a step's force works on the velocity that it finds, which is that of the particles already.
        return 0.5 * (taken - given)

    def _conduct(self, dt: float) -> None:
        """Conduct heat, if the scene asks for it, on the grid and with the shape that the step began with."""
        if self._conduction is not None:
            self.ledger.heat += self._conduction.advance(
                self._background,
                dt,
                self.time,
                self.positions,
                self.points.deformation_gradient,
                self.volume_ratio,
            )

    def _keep_books(
        self,
        work: Work,
        found: float,
        power: float,
        damped: float,
        lost: float,
        hold: Hold,
        push: Push,
        sums: np.ndarray,
        dt: float,
    ) -> None:
        """Enter a step that worked in the ledger; found, power : of the loads on the velocities before and after [W].

        A force acts for half the last step on the velocities that it finds, and for half of this one on those after.
        """
        ledger, background = self.ledger, self._background
        kick = 0.5 * (self._last_step + dt)
        on_grid = background.energies.sum(axis=0)
        kinetic = float(sums[:, ENERGY].sum())
        resisted = found - background.power_before()
        starts = self.step_count == 0
        if starts:
            # Velocities start at t = 0, not half a step before: what the first forces do to them is half their work.
            ledger.initial -= 0.25 * dt * (background.power() - background.power_before())
        ledger.transfer += (
            lost
            + (0.0 if starts else hold.lost)
            + (self._kinetic - float(on_grid[BEFORE]))
            + (float(on_grid[AFTER]) + hold.energy + push.energy - kinetic)
            + 0.5 * self._last_step * (resisted - self._stress_power)
        )
        self._kinetic, self._stress_power = kinetic, self._powers.over(dt)
        # Velocities belong to the middle of the step: half a step's work of all forces leads to its end.
        before, self._ahead = self._ahead, 0.5 * dt * (power + (0.0 if starts else hold.later / kick))
        ledger.kinetic = kinetic + self._ahead - 0.5 * dt * self._stress_power
        ledger.external += 0.5 * (self._last_step * found + dt * power) + hold.work + self._ahead - before
        ledger.contact += (hold.lost if starts else 0.0) - push.work
        ledger.friction -= push.rubbed
        ledger.damping += damped
        ledger.plastic += work.plastic
        ledger.viscosity += work.viscous
        ledger.strain += work.stress - work.plastic
        self.wall_impulse += push.impulse
        self.wall_force = push.impulse / kick
        self._reactions = {name: impulse / kick for name, impulse in hold.impulses.items()}
        self._fastest = (math.sqrt(float(sums[:, SPEED].max())), work.wave_speed, work.viscous_pressure)

    def _stable_step(self, speed: float, wave_speed: float, viscous_pressure: float) -> float:
        relative = viscous_pressure / (self.material.density * wave_speed**2) if viscous_pressure else 0.0
        factor = damped_step_factor(self.points.viscosity, relative) * self._background.step_factor()
        step = self.cfl * factor * self.cell_size / self._fastest_wave(speed, wave_speed)
        return step if self._conduction is None else min(step, self._conduction.limit)

    def _fastest_wave(self, speed: float, wave_speed: float) -> float:
        """Speed [m/s] of what moves fastest through the grid: waves, and particles where they cross it."""
        if self._waves is None:
            return wave_speed + speed
        points = self.points
        self.threads.run(
            pull_back, len(self._waves), self.geometry, points.old_deformation_gradient, points.wave_speed,
            self.cell_size, points.lengths, self._waves,
        )  # fmt: skip
        return math.sqrt(float(self._waves.max()))

    def _check_inside(self, particle: int) -> None:
        """Raise RunFailure for a particle that no grid could hold."""
        background, where = self._background, self.points.place(self.step_count + 1, self.time, particle)
        place, bounds = self.positions[particle], background.bounds
        if not ((bounds[:, 0] <= place) & (place <= bounds[:, 1]) & np.isfinite(place)).all():
            names = axis_names(self.geometry)
            outside = ", ".join(f"{name} = {x:.4g} m" for name, x in zip(names, place, strict=False))
            raise RunFailure(
                f"{where}: the particle has left the domain ({outside}); check velocity and material, or try another "
                "resolution"
            )
        if isinstance(background.shape, ConvectedDomain):
            check_extent(background.shape, particle, self.cell_size, where)

    def _speed(self) -> float:
        return float(np.sqrt((self.velocities**2).sum(axis=1).max()))

    def _particle_energy(self) -> float:
        """Kinetic energy of the particles as they are, affine part included [J]."""
        squares = (self.velocities**2).sum(axis=1)
        if self.affine is not None and self.affine.any():
            carried = self._background.carried(self._places, self.affine)
            squares += (carried * self.affine).sum(axis=(1, 2))
        return 0.5 * float((self.particle_mass * squares).sum())
