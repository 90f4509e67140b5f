"""A body of particles: where they start, what they carry, and what can be read from them."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from core_models.bulk_viscosity import BulkViscosity
from core_models.geometry import Geometry
from core_models.initial_deformation import deform_slowly
from core_models.initial_motion import field_values, initial_velocities
from core_models.loads import Load
from core_models.material import Material
from core_models.mirror_images import symmetry_planes
from core_models.points import MaterialPoints
from core_models.threads import Threads
from meshes.mesh import Mesh
from mpm.configurations import Total, Updated
from mpm.initial import field_gradients, initial_gradients
from mpm.particles import domain_corners, seed
from mpm.shape import Boundary, deformed


class Body:
    """Particles with positions, velocities and material state.

    Parameters
    ----------
    mesh, material, geometry, threads : as the solver's. seeding : see `mpm.particles`. velocity, displacement,
    temperature, viscosity : initial state, see the solver. affine : whether particles carry an affine velocity.
    conduction : whether heat is conducted. configuration : of mpm.configurations. loads : in whose symmetry
    planes the body is continued.

    positions, velocities (n, d) [m], [m/s]; affine (n, d, d) [1/s] or None; volume_ratio (n,) det F.
    """

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        geometry: Geometry,
        threads: Threads,
        *,
        seeding: str,
        velocity: Any,
        displacement: Any,
        temperature: float | None,
        viscosity: BulkViscosity | None,
        affine: bool,
        conduction: bool,
        configuration: Updated | Total,
        loads: Sequence[Load],
    ) -> None:
        self.mesh, self.material, self.geometry, self.threads, self.seeding = (
            mesh,
            material,
            geometry,
            threads,
            seeding,
        )
        self.configuration = configuration
        self.particles = seed(mesh, geometry, seeding)
        self.reference_positions = self.particles.positions
        self.boundary = Boundary(self.particles.faces, self.reference_positions, geometry)
        self.points = MaterialPoints(
            material, self.particles.volumes, temperature, viscosity, threads, conduction
        )
        planes = symmetry_planes(loads, mesh, geometry)
        self.points.connect(self.reference_positions, geometry, planes)
        n, d = self.reference_positions.shape
        self.positions = self.reference_positions.copy()
        self.velocities = initial_velocities(velocity, self.reference_positions)
        self.affine = np.zeros((n, d, d)) if affine else None
        self.volume_ratio = np.ones(n)
        self.stored_energy, self.plastic_energy = 0.0, 0.0
        if displacement is not None:
            self._displace(displacement)
        if affine and callable(velocity):
            self._turn(velocity)
        self.mass = float(self.particle_mass.sum())

    @property
    def particle_mass(self) -> np.ndarray:
        """Masses (n,) [kg]."""
        return self.material.density * self.points.reference_volumes

    @property
    def momentum(self) -> np.ndarray:
        """Momentum (d,) [kg m/s]."""
        return (self.particle_mass[:, None] * self.velocities).sum(axis=0)

    def point_positions(self) -> np.ndarray:
        """Positions of the particles (n, d) [m]."""
        return self.positions.copy()

    def point_velocities(self) -> np.ndarray:
        """Velocities of the particles (n, d) [m/s]."""
        return self.velocities.copy()

    def point_volumes(self) -> np.ndarray:
        """Current volumes of the particles (n,) [m^3]."""
        return self.points.reference_volumes * self.points.volume_ratio

    def domains(self) -> np.ndarray:
        """Deformed domains of the particles [m]: (n, 4, 2) polygons, or (n, 8, 3) hexahedra in VTK's order."""
        offsets = domain_corners(self.mesh, self.seeding) - self.reference_positions[:, None]
        return deformed(slice(None), offsets, self.positions, self.points.old_deformation_gradient)

    def outline(self) -> dict[str, np.ndarray]:
        """In two dimensions, each named boundary but the axis as a deformed line (k, 2) [m], the body on its left."""
        return self.boundary.lines(self.positions, self.points.old_deformation_gradient)

    def boundary_positions(self, name: str) -> np.ndarray:
        """Current positions (k, d) [m] of the corners of the particles' faces on a named boundary, each once."""
        return self.boundary.corners(name, self.positions, self.points.old_deformation_gradient)

    def boundary_points(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        """Reference and current positions (k, d) [m] of the same corners."""
        undeformed = np.broadcast_to(np.eye(3), (self.points.n, 3, 3))
        return self.boundary.corners(name, self.reference_positions, undeformed), self.boundary_positions(
            name
        )

    def _displace(self, displacement: Any) -> None:
        """Move the particles to X + u(X) and give them the state of that deformation."""
        reference = self.reference_positions
        self.positions += field_values("displacement", displacement, reference, "m")
        self.points.deformation_gradient[:] = initial_gradients(displacement, reference, self.geometry)
        self.stored_energy, self.plastic_energy = deform_slowly(self.points)
        self.volume_ratio = self.points.volume_ratio

    def _turn(self, velocity: Any) -> None:
        """Give the particles the affine velocity of a field v(X), a gradient in the body that the grid covers."""
        self.affine[:] = field_gradients(velocity, self.reference_positions)
        if not isinstance(self.configuration, Total):
            d = self.positions.shape[1]
            self.affine[:] = self.affine @ np.linalg.inv(self.points.old_deformation_gradient[:, :d, :d])
