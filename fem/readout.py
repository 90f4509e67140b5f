"""What can be read from a body of finite elements at any time."""

from dataclasses import replace

import numpy as np

from core_models.errors import UnsupportedError
from core_models.geometry import Axisymmetric
from core_models.ledger import EnergyLedger
from fem.shape_readout import ShapeReadout


class Readout(ShapeReadout):
    """Energies, momenta, positions and volumes: the reading half of `ExplicitSolver`."""

    def nodal_forces(self) -> np.ndarray:
        """Internal forces on the nodes (n, d) [N]."""
        return self._body.nodal_forces()

    def kinetic_energy(self) -> float:
        """Kinetic energy at `time` [J]: that of the half step before, and half a step's power of the forces."""
        return self.ledger.kinetic

    @property
    def ledger(self) -> EnergyLedger:
        """Energies at `time`. Velocities, and what forces from outside have done, belong to half a step before."""
        mass, v, fixed = self._body.nodal_mass[:, None], self.velocities, self._supports.fixed
        power = self.nodal_forces() * v
        braking = self._damping * mass * v**2
        loads = np.zeros_like(v) if self._loads is None else self._loads * v
        half = 0.5 * self._last_step
        return replace(
            self._ledger,
            kinetic=0.5 * float((mass * v**2).sum()) + half * float((power + loads - braking)[~fixed].sum()),
            external=self._ledger.external + half * float(np.where(fixed, braking - power, loads).sum()),
            damping=self._ledger.damping + half * float(braking.sum()),
        )

    @property
    def momentum(self) -> np.ndarray:
        """Momentum (d,) [kg m/s], half a step before `time`; that of an axisymmetric body is along its axis."""
        total = (self._body.nodal_mass[:, None] * self.velocities).sum(axis=0)
        return total * [0.0, 1.0] if isinstance(self.geometry, Axisymmetric) else total

    @property
    def angular_momentum(self) -> float | np.ndarray:
        """Angular momentum about the origin [kg m^2/s], half a step before `time`: a number, or (3,) in 3-D.

        Raises UnsupportedError for an axisymmetric body, which does not turn.
        """
        if isinstance(self.geometry, Axisymmetric):
            raise UnsupportedError(
                "an axisymmetric body has no angular momentum: use geometry='plane-strain' or a 3-D mesh"
            )
        middle = self.positions - 0.5 * self._last_step * self.velocities
        momenta = self._body.nodal_mass[:, None] * self.velocities
        if len(momenta[0]) == 2:
            return float((middle[:, 0] * momenta[:, 1] - middle[:, 1] * momenta[:, 0]).sum())
        return np.cross(middle, momenta).sum(axis=0)

    @property
    def in_contact(self) -> bool:
        """Whether the wall has pushed during the last step."""
        return self.wall_force != 0.0

    def boundary_force(self, name: str) -> np.ndarray:
        """Mean force (d,) [N] of the supports of a boundary on the body in the last step; SceneError if it has none."""
        return self._supports.reaction(name) / self._middle

    def point_velocities(self) -> np.ndarray:
        """Velocities at the points (n, d) [m/s], half a step before `time`."""
        return self._at_points(self.velocities)
