"""Implicit quasi-static finite elements: equilibrium at the end of every increment by Newton's method."""

import math
from pathlib import Path as FilePath

import numpy as np

from core_models.arguments import check_between
from core_models.equilibrium.checkpoint import RestartableIncrements
from core_models.equilibrium.load_limit import growing_loads
from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stepping import QuasiStatic, refuse_damping
from core_models.errors import UnsupportedError
from core_models.geometry import find_geometry
from core_models.load_checks import check_loads
from core_models.loads import Load
from core_models.material import Material
from core_models.mirror_images import symmetry_planes
from core_models.plane_symmetry import check_plane
from core_models.points import MaterialPoints
from core_models.threads import Threads
from fem.body import Body
from fem.cures.choice import NODAL, cures_of, find_cure, make_cure
from fem.cures.own_share import check_own_share, default_share
from fem.elements import FULL, is_one_point_brick
from fem.external import ExternalForces
from fem.hourglass import DEFAULT
from fem.implicit.conduction import ImplicitConduction
from fem.implicit.frequency import lowest_frequency
from fem.implicit.path import Path, make_measure
from fem.implicit.system import ElementSystem
from fem.shape_readout import ShapeReadout
from fem.supports import Supports
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh
from meshes.single_body import refuse_several_bodies


class ImplicitSolver(RestartableIncrements, ShapeReadout, QuasiStatic):
    """Quasi-static deformation of a body: forces balance at the end of every increment, inertia plays no part.

    Parameters
    ----------
    mesh, material, geometry, temperature, loads, threads, conduction, integration, cure, own_share : as
    `fem.ExplicitSolver` takes them, but for nodal averages and one-point quads and hexahedra, which have no tangent
    here, and Damping, which is dynamic; own_share is None for 0.1 in quadratic elements but in plane strain, else 0.
    Heat is conducted after each increment, by backward Euler.
    increment : of time to take [s], > 0; it is cut on failure, and grows again on ease. smallest : below it the run
    gives up [s]; by default 1e-6 of the increment.
    tolerance : on the residual, relative to all forces on nodes, above 1e-12, up to 1e-3. iterations : allowed
    per increment, > 0.
    linear_solver : 'scipy', 'pardiso', 'petsc', or None for PARDISO where it can be imported, else SciPy. log : file
    for the convergence log in JSON lines, or None; `log.records` and `log.text()` hold it in any case.
    path : None, `PathLength` or `BoundaryMotion`: forces then grow and fall as equilibrium asks for, the body moves on;
    `time` is that of the motion, and `load_time` that at which loads are taken.

    Time is that of the histories of supports and loads, and of rate-dependent laws. A body force at current positions
    has no stiffness of its own, so that it costs iterations.
    `advance` makes one increment. Raises SceneError, MeshError or UnsupportedError for what cannot be.
    """

    method = "fem-implicit"
    PARTS = (*RestartableIncrements.PARTS, ("_body", ("scales",)), ("_conduction", ("temperatures",)))
    ADVICE = (
        "prescribe displacements, or follow the path with path=PathLength(...) or path=BoundaryMotion(...)"
    )

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        *,
        increment: float,
        geometry: str | None = None,
        temperature: float | None = None,
        loads: tuple[Load, ...] = (),
        threads: int = 1,
        integration: str = FULL,
        cure: str | None = None,
        own_share: float | None = None,
        smallest: float | None = None,
        tolerance: float = 1e-8,
        iterations: int = 20,
        linear_solver: str | None = None,
        log: FilePath | str | None = None,
        path: Path | None = None,
        conduction: bool = False,
    ) -> None:
        if temperature is not None:
            check_between("temperature", temperature, 0.0, math.inf, "K")
        self.geometry = find_geometry(geometry, mesh.dimension)
        check_plane(material, self.geometry)
        self.mesh = axisymmetric(mesh) if geometry in (None, "axisymmetric") and mesh.dimension == 2 else mesh
        refuse_several_bodies(self.mesh, "fem.ImplicitSolver")
        check_loads(loads, self.mesh, self.geometry, conduction=conduction)
        refuse_damping(loads, "fem.ExplicitSolver")
        self.material = material
        self.cure = find_cure(cure, mesh.kind, integration)
        _refuse_without_tangent(mesh.kind, integration, self.cure)
        self.threads = Threads(threads)
        share = default_share(mesh.kind, self.cure, self.geometry)
        if own_share is not None:
            share = check_own_share(own_share, self.cure)
        self._body = Body(
            self.mesh, material, self.geometry, integration, self.cure, share, DEFAULT, self.threads
        )
        self.mass = float(self._body.nodal_mass.sum())
        volumes = self._body.space.tables.weights.ravel()
        self.points = MaterialPoints(material, volumes, temperature, None, self.threads, conduction)
        planes = symmetry_planes(loads, self.mesh, self.geometry)
        self.points.connect(self.reference_positions, self.geometry, planes)
        supports = Supports(loads, self.mesh, self.geometry)
        projection = make_cure(self.cure, self.mesh, self._body.space, share)
        self._loads = tuple(loads)
        system = ElementSystem(
            self.mesh, self.geometry, self._body, projection, self.points, material, supports, self._loads,
            self.threads,
        )  # fmt: skip
        pattern = Pattern(system.tables, ~system.fixed.ravel(), self.threads)
        self._start(
            self.mesh.points, system, supports, pattern, increment=increment, smallest=smallest,
            tolerance=tolerance, iterations=iterations, linear_solver=linear_solver, log=log,
            measure=None if path is None else make_measure(path, self.mesh, supports),
        )  # fmt: skip
        self._conduction = None
        if conduction:
            self._conduction = ImplicitConduction(
                self.mesh, self.geometry, integration, self._body, self.points, self._loads, linear_solver
            )

    @property
    def positions(self) -> np.ndarray:
        """Positions of the nodes (n, d) [m]."""
        return self._places

    def lowest_frequency(self) -> float:
        """Lowest natural angular frequency at the present state [rad/s]; SingularStiffness for a body that is not held.

        Points are taken within 1 s to where they are, so that they unload elastically at most.
        """
        self._refuse_free_motion()
        system = self._system
        system.balance(self.positions, self.load_time, 1.0)
        free = ~system.fixed
        masses = np.broadcast_to(self.nodal_mass[:, None], free.shape)[free]
        return lowest_frequency(self._pattern, system.stiffness(), masses)

    def _accept(self, places: np.ndarray, dt: float, end: float) -> None:
        start = self.time
        super()._accept(places, dt, end)
        self._body.accept()
        if self._conduction is not None:
            self._ledger.heat += self._conduction.advance(dt, start)

    def _growing(self, before: float, after: float) -> str:
        def forces(load: Load, time: float) -> np.ndarray:
            external = ExternalForces((load,), self.mesh, self.geometry, self.nodal_mass)
            return external.at(self.positions, time)

        return growing_loads(self._loads, forces, (before, after))

    def _whereabouts(self, point: int) -> str:
        return f" (element {point // (self.points.n // len(self.mesh.cells))})"


def _refuse_without_tangent(kind: str, integration: str, cure: str) -> None:
    if is_one_point_brick(kind, integration):
        raise UnsupportedError(
            f"one-point {kind} has no implicit hourglass control: use integration='full', which has a cure"
        )
    if cure == NODAL:
        quadratic = {"tri3": "tri6", "tet4": "tet10"}[kind]
        others = " or ".join(repr(each) for each in cures_of(kind, integration) if each != NODAL)
        raise UnsupportedError(
            f"the cure {NODAL!r} has no implicit tangent: use {quadratic} elements, or cure={others}"
        )
