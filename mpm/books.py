"""Energies and stable steps of the explicit material point method."""

import math

import numpy as np

from core_models.bulk_viscosity import damped_step_factor
from core_models.points import Work
from mpm.configurations import pull_back
from mpm.contact import Push
from mpm.motion import AFTER, BEFORE
from mpm.supports import Hold
from mpm.to_particles import ENERGY, SPEED


class Books:
    """The part of `Solver` that keeps the ledger, and says how long the next step may be."""

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
        ledger, background = self._ledger, self._background
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
        self._supports.reactions[:] = hold.impulses / kick
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

    def _speed(self) -> float:
        return float(np.sqrt((self.velocities**2).sum(axis=1).max()))

    def _particle_energy(self) -> float:
        """Kinetic energy of the particles as they are, affine part included [J]."""
        squares = (self.velocities**2).sum(axis=1)
        if self.affine is not None and self.affine.any():
            carried = self._background.carried(self._places, self.affine)
            squares += (carried * self.affine).sum(axis=(1, 2))
        return 0.5 * float((self.particle_mass * squares).sum())
