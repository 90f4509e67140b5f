"""Implicit quasi-static material point method: equilibrium at the end of every increment by Newton's method."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from core_models.arguments import check_between
from core_models.body_checks import check_body
from core_models.checkpoint import Checkpoint
from core_models.equilibrium.checkpoint import RestartableIncrements
from core_models.equilibrium.condition import condition_number
from core_models.equilibrium.free_motion import free_motion
from core_models.equilibrium.load_limit import growing_loads
from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stepping import QuasiStatic, refuse_damping
from core_models.errors import SingularStiffness, UnsupportedError
from core_models.geometry import Axisymmetric, find_geometry
from core_models.load_checks import check_loads
from core_models.loads import Load
from core_models.material import Material
from core_models.plane_symmetry import check_plane
from core_models.threads import Threads
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh, check_mesh
from meshes.single_body import refuse_several_bodies
from mpm.body import Body
from mpm.configurations import Total
from mpm.dilatation import find_cure
from mpm.implicit.grid import SplineGrid
from mpm.implicit.planes import grid_lines, held_ends, held_planes, weakly_held
from mpm.implicit.splines import DEGREES
from mpm.implicit.supports import Supports
from mpm.implicit.system import ParticleSystem
from mpm.implicit.weak_supports import WeakSupports
from mpm.interpolation.catalogue import check_interpolation
from mpm.particles import GAUSS, domain_corners

GHOST = 1e-4
SINGULAR = 1e15
"""Condition number from which the stiffness counts as singular."""

OWN_SHARE = {"linear": 0.0, "quadratic": 0.1, "cubic": 0.1}
"""Share alpha of its own change of volume that a particle keeps under the cure (mpm.implicit.deformation).

Where the stress exceeds the slope of the flow stress, beyond the largest force of a bar, changes of volume that a
cell's mean does not see grow by themselves if nothing else holds them, and the surface wrinkles. One of ten parts of
the bulk modulus holds them, and does not lock splines that are smooth; linear functions have next to no such changes.
"""


class ImplicitSolver(RestartableIncrements, QuasiStatic, Body):
    """Quasi-static deformation of a body of particles: forces balance at the end of every increment.

    The grid covers the reference body (total Lagrangian), so that particles cross no cells and their tables stay.

    Parameters
    ----------
    mesh, material, geometry, temperature, loads, threads, seeding : as `mpm.Solver` takes them, but for Damping.
    cell_size : of all cells [m], or for each axis a size or the lines between the cells, ascending [m]: finer where it
    matters. The grid ends where the body is held (mpm.implicit.planes).
    interpolation : B-splines, 'quadratic', 'cubic' or 'linear', which end with the grid.
    cure : of volumetric locking, 'mean-dilatation' (over each cell, but for a share) or None.
    ghost : factor gamma of the penalty that stabilises cells which the body cuts (mpm.implicit.ghost), 0 for none.
    increment, smallest, tolerance, iterations, linear_solver, log : as `fem.ImplicitSolver` takes them; the log begins
    with the condition number of the stiffness of the undeformed body.

    Supports hold whole faces of the body that are plane and normal to an axis exactly, others by stiff springs
    (mpm.implicit.weak_supports). A body force at current positions has no stiffness of its own, so that it costs
    iterations.
    `advance` makes one increment. Raises SceneError, MeshError or UnsupportedError for what cannot be.
    """

    method = "mpm-implicit"
    PARTS = (*RestartableIncrements.PARTS, ("_weak", ("moved", "reactions", "time")))

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        *,
        cell_size: float | Sequence[ArrayLike],
        increment: float,
        geometry: str | None = None,
        temperature: float | None = None,
        loads: tuple[Load, ...] = (),
        threads: int = 1,
        interpolation: str = "quadratic",
        cure: str | None = None,
        seeding: str = GAUSS,
        ghost: float = GHOST,
        smallest: float | None = None,
        tolerance: float = 1e-8,
        iterations: int = 20,
        linear_solver: str | None = None,
        log: Path | str | None = None,
    ) -> None:
        check_mesh(mesh)
        check_body(material, temperature, None)
        check_interpolation(interpolation)
        if interpolation not in DEGREES:
            raise UnsupportedError(
                f"interpolation {interpolation!r} is not available in implicit MPM: give one of {', '.join(DEGREES)}"
            )
        if ghost != 0.0:
            check_between("ghost", ghost, 0.0, 1.0)
        share = OWN_SHARE[interpolation] if find_cure(cure) else 1.0
        kind = find_geometry(geometry, mesh.dimension)
        check_plane(material, kind)
        mesh = axisymmetric(mesh) if isinstance(kind, Axisymmetric) else mesh
        refuse_several_bodies(mesh, "mpm.ImplicitSolver")
        check_loads(loads, mesh, kind)
        refuse_damping(loads, "mpm.Solver")
        self._loads = tuple(loads)
        planes = held_planes(mesh, kind, loads)
        ends = held_ends(mesh, kind, planes)
        lines = grid_lines(mesh, kind, ends, cell_size)
        super().__init__(
            mesh, material, kind, Threads(threads), seeding=seeding, velocity=0.0, displacement=None,
            temperature=temperature, viscosity=None, affine=False, conduction=False, configuration=Total(),
            loads=loads,
        )  # fmt: skip
        grid = SplineGrid(DEGREES[interpolation], lines, ends, self.reference_positions)
        shear = material.shear_at_rest(material.room_temperature)
        self._weak = WeakSupports(weakly_held(mesh, loads, planes), self.particles, kind, grid, shear)
        supports = Supports(loads, mesh, kind, grid, planes, self._weak)
        system = ParticleSystem(
            grid, kind, self.particles, self.points, material, supports.fixed, self._loads, self._weak, share, ghost,
            self.threads,
        )  # fmt: skip
        self._grid, self._undeformed = grid, np.broadcast_to(np.eye(3), (self.points.n, 3, 3))
        pattern = Pattern(system.tables, ~system.fixed.ravel(), self.threads)
        condition = None
        if not free_motion(grid.places, supports.fixed | self._weak.reached, kind):
            system.balance(grid.places, 0.0, increment)
            condition = condition_number(pattern, pattern.assemble(system.stiffness()))
        self._start(
            grid.places, system, supports, pattern, increment=increment, smallest=smallest,
            tolerance=tolerance, iterations=iterations, linear_solver=linear_solver, log=log, condition=condition,
        )  # fmt: skip

    def _growing(self, before: float, after: float) -> str:
        def forces(load: Load, time: float) -> np.ndarray:
            return self._system.forces_of(load, self._places, time)

        return growing_loads(self._loads, forces, (before, after))

    @property
    def cells(self) -> int:
        """Number of cells with particles."""
        return len(self._grid.cells)

    def condition_number(self) -> float:
        """Condition number of the stiffness in the 1-norm at the present state, an estimate; inf if it is singular.

        Points are taken within 1 s to where they are, so that they unload elastically at most.
        """
        self._system.balance(self._places, self.time, 1.0)
        return condition_number(self._pattern, self._pattern.assemble(self._system.stiffness()))

    def domains(self) -> np.ndarray:
        """Deformed domains of the particles [m]: (n, 4, 2) polygons, or (n, 8, 3) hexahedra in VTK's order."""
        corners = domain_corners(self.mesh, self.seeding)
        return self._now(corners.reshape(-1, corners.shape[2])).reshape(corners.shape)

    def outline(self) -> dict[str, np.ndarray]:
        """In two dimensions, each named boundary but the axis as a deformed line (k, 2) [m], the body on its left."""
        lines = self.boundary.lines(self.reference_positions, self._undeformed)
        return {name: self._now(line) for name, line in lines.items()}

    def boundary_positions(self, name: str) -> np.ndarray:
        """Current positions (k, d) [m] of the corners of the particles' faces on a named boundary, each once."""
        return self._now(self.boundary.corners(name, self.reference_positions, self._undeformed))

    def _now(self, reference: np.ndarray) -> np.ndarray:
        """Current positions (k, d) [m] of points of the reference body, by the grid's splines."""
        nodes, values, _slopes = self._grid.reach(reference)
        return np.einsum("ka,kai->ki", values, self._places[nodes])

    def restore(self, checkpoint: Checkpoint) -> None:
        """Go on from a checkpoint of a solver that was built alike: the increments to come are bitwise the same.

        Raises SceneError for a checkpoint of another body, material or option.
        """
        super().restore(checkpoint)
        self._carry()

    def _accept(self, places: np.ndarray, dt: float, end: float) -> None:
        super()._accept(places, dt, end)
        self._weak.accept(end)
        self._ledger.hourglass = self._system.ghost_energy
        self._carry()

    def _free_motion(self) -> str:
        held = self._supports.fixed | self._weak.reached
        return free_motion(self._nodes, held, self.geometry)

    def _refuse_free_motion(self) -> None:
        super()._refuse_free_motion()
        condition = self.log.records[0].condition
        if not condition < SINGULAR:
            raise SingularStiffness(
                f"the stiffness is singular, its condition number {condition:.1e}: {self.points.n} particles in "
                f"{self.cells} cells do not see every motion of the grid; give a finer mesh, so that each cell has two "
                "particles or more along every edge, or larger cells"
            )

    def _carry(self) -> None:
        """Let the particles go where the grid is; their velocities are those of the last increment."""
        system = self._system
        for of_particles, of_grid in ((self.positions, self._places), (self.velocities, self._velocity)):
            of_particles[:] = np.einsum("pa,pai->pi", system.values, of_grid[system.nodes])
        self.volume_ratio = self.points.volume_ratio
