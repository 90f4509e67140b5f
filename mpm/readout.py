"""What can be read from a solver: energy, angular momentum, reactions, contact, and whether the body has come apart."""

import numpy as np

from core_models.errors import SceneError, UnsupportedError
from core_models.geometry import Axisymmetric
from core_models.ledger import EnergyLedger
from core_models.names import suggestion
from mpm.configurations import Total
from mpm.fracture import Fracture, Neighbours, supports
from mpm.particles import domain_corners


class Readout:
    """The part of `Solver` that changes nothing."""

    @property
    def ledger(self) -> EnergyLedger:
        """Energies at `time`."""
        return self._ledger

    def kinetic_energy(self) -> float:
        """Kinetic energy at `time` [J]."""
        return self._ledger.kinetic

    @property
    def angular_momentum(self) -> float | np.ndarray:
        """About the origin [kg m^2/s], with what affine velocities carry: a number in the plane, (3,) in space.

        Raises UnsupportedError for an axisymmetric body, which does not turn.
        """
        if isinstance(self.geometry, Axisymmetric):
            raise UnsupportedError(
                "an axisymmetric body has no angular momentum: use geometry='plane-strain' or a 3-D mesh"
            )
        x, v = self.positions, self.velocities
        spin = np.einsum("nj,ni->nij", x, v)
        if self.affine is not None:
            carried = self._background.carried(self._places, self.affine)
            if isinstance(self.configuration, Total):
                d = x.shape[1]
                carried = carried @ self.points.old_deformation_gradient[:, :d, :d].transpose(0, 2, 1)
            spin += carried
        spin = (self.particle_mass[:, None, None] * spin).sum(axis=0)
        whole = spin - spin.T
        return float(whole[1, 0]) if len(whole) == 2 else np.array([whole[2, 1], whole[0, 2], whole[1, 0]])

    def boundary_force(self, name: str) -> np.ndarray:
        """Force (d,) [N] of a boundary with prescribed motion or symmetry on the body in the last step.

        Raises SceneError for any other boundary.
        """
        mirrors = self._background.mirrors
        known = [
            *self._supports.names,
            *(mirror_name for mirror in mirrors for mirror_name in mirror.names),
        ]
        if name not in known:
            raise SceneError(f"no support holds {name!r}; {suggestion(name, known, 'nothing is held')}")
        if name in self._supports.names:
            return self._supports.reactions[self._supports.names.index(name)].copy()
        return self._background.mirror_force(next(m for m in mirrors if name in m.names))

    @property
    def in_contact(self) -> bool:
        """Whether the wall has pushed during the last step."""
        return self.wall_force != 0.0

    def numerical_fracture(self) -> Fracture | None:
        """Where the body has come apart on the grid though its material is intact (mpm.fracture), or None.

        It looks at all pairs of neighbours: to be called now and then, not after every step.
        """
        if isinstance(self.configuration, Total):
            return None
        if self._neighbours is None:
            self._neighbours = Neighbours(domain_corners(self.mesh, self.seeding), self.reference_positions)
        damage, background = self.points.old.damage, self._background
        return self._neighbours.parted(
            self.positions,
            background.grid.base[: self.mesh.dimension],
            self.cell_size,
            supports(background.shape, self.cell_size),
            np.ones(self.points.n, dtype=bool) if damage is None else damage < 1.0,
        )
