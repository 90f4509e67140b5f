"""What can be read from a body of finite elements at any time."""

from dataclasses import replace

import numpy as np

from core_models.errors import SceneError, UnsupportedError
from core_models.geometry import Axisymmetric
from core_models.ledger import EnergyLedger
from core_models.names import suggestion
from fem.domains import domain_shape
from fem.shape import chain, outline


class Readout:
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
    def nodal_mass(self) -> np.ndarray:
        """Lumped mass (n,) [kg]."""
        return self._body.nodal_mass

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

    def boundary_positions(self, name: str) -> np.ndarray:
        """Positions (k, d) [m] of the nodes of a boundary, in two dimensions along it; SceneError if unknown."""
        if name not in self.mesh.boundaries:
            raise SceneError(f"the mesh has no boundary {name!r}; {suggestion(name, self.mesh.boundaries)}")
        facets = self.mesh.boundaries[name]
        return self.positions[chain(facets) if self.mesh.dimension == 2 else np.unique(facets)]

    def boundary_points(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        """Reference and current positions (k, d) [m] of the nodes of a boundary; SceneError if unknown."""
        current = self.boundary_positions(name)
        facets = self.mesh.boundaries[name]
        return self.mesh.points[chain(facets) if self.mesh.dimension == 2 else np.unique(facets)], current

    def boundary_force(self, name: str) -> np.ndarray:
        """Mean force (d,) [N] of the supports of a boundary on the body in the last step; SceneError if it has none."""
        return self._supports.reaction(name) / self._middle

    @property
    def reference_positions(self) -> np.ndarray:
        """Positions of the points in the reference body (n, d) [m]."""
        return self._at_points(self.mesh.points)

    def point_positions(self) -> np.ndarray:
        """Positions of the points (n, d) [m]."""
        return self._at_points(self.positions)

    def point_velocities(self) -> np.ndarray:
        """Velocities at the points (n, d) [m/s], half a step before `time`."""
        return self._at_points(self.velocities)

    def _at_points(self, nodal: np.ndarray) -> np.ndarray:
        corners = nodal[self.mesh.cells]
        return np.einsum("qa,eai->eqi", self._body.space.shape, corners).reshape(-1, corners.shape[2])

    def point_volumes(self) -> np.ndarray:
        """Current volumes of the points (n,) [m^3]."""
        volumes = self.points.reference_volumes * self.points.volume_ratio
        return volumes if self._body.scales is None else volumes / self._body.scales**3

    def domains(self) -> np.ndarray:
        """The deformed part of the body round each point: quads (n, 4, 2) or hexahedra (n, 8, 3) [m]."""
        shape = domain_shape(self.mesh.kind, self._body.space.places)
        corners = np.einsum("qca,eai->eqci", shape, self.positions[self.mesh.cells])
        return corners.reshape(-1, *corners.shape[2:])

    def outline(self) -> dict[str, np.ndarray]:
        """Deformed boundaries by name, each a line (k, 2) [m], without the axis; UnsupportedError in 3-D."""
        if self.mesh.dimension == 3:
            raise UnsupportedError("a 3-D body has no outline: use boundary_positions(name)")
        on_axis = self.mesh.points[:, 0] == 0.0 if isinstance(self.geometry, Axisymmetric) else None
        return outline(self.mesh.boundaries, self.positions, on_axis)
