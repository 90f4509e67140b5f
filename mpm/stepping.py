"""One step of the explicit material point method: particles to grid, motion of the grid, grid to particles, points."""

import math

import numpy as np

from core_models.compilation import CHUNK
from core_models.errors import RunFailure, SceneError
from core_models.geometry import axis_names
from core_models.load_checks import damping_rate
from core_models.redo import VANISHING_STEP, redoing, step_within
from mpm.contact import Push
from mpm.grid import RECORD, VELOCITY
from mpm.interpolation.cpdi import ConvectedDomain, check_extent
from mpm.motion import advect
from mpm.supports import Hold


class Stepping:
    """The part of `Solver` that makes steps."""

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
        self.node_updates += self._background.nodes
        self._last_step, self._filled = taken, False
        self.time_step = self._stable_step(*self._fastest)

    def _fill(self) -> None:
        """Fill the grid with what the particles bring, and measure gaps to the wall."""
        points, background = self.points, self._background
        outside = background.follow(self._places)
        if outside is not None:
            self._check_inside(outside)
            self._surround(outside)
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
        keep = math.exp(-kick * damping_rate(self._damping, self.time))
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
        power = self._background.power()
        given = dt * power - external
        # Forces act for half of the last step and half of this one, stress for all of a step. Where steps differ, so
        # does their work, without bound at nodes of next to no mass; here those deform nothing.
        longer = self._last_step - dt if self.step_count else 0.0
        uneven = 0.25 * longer * (power - self._background.power_before())
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
        return 0.5 * (taken - given) - uneven

    def _conduct(self, dt: float) -> None:
        """Conduct heat, if the scene asks for it, on the grid and with the shape that the step began with."""
        if self._conduction is not None:
            self._ledger.heat += self._conduction.advance(
                self._background,
                dt,
                self.time,
                self.positions,
                self.points.deformation_gradient,
                self.volume_ratio,
            )

    def _surround(self, particle: int) -> None:
        """Make a grid that has room for this particle too; RunFailure where it has gone too far."""
        try:
            self._background.surround(self._places)
        except SceneError as error:
            where = self.points.place(self.step_count + 1, self.time, particle)
            raise RunFailure(f"{where}: the particle has flown too far from the others: {error}") from error

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
