"""Explicit material point method: updated or total Lagrangian, in the plane, with axial symmetry or in space."""

import math
from typing import Any

import numpy as np

from core_models.arguments import check_between
from core_models.body_checks import check_body
from core_models.bulk_viscosity import BulkViscosity
from core_models.compilation import CHUNK
from core_models.geometry import Axisymmetric, find_geometry
from core_models.initial_deformation import check_displacement
from core_models.ledger import EnergyLedger
from core_models.load_checks import check_loads, damping_of
from core_models.loads import Load, Symmetry
from core_models.material import Material
from core_models.plane_symmetry import check_plane
from core_models.threads import Threads
from core_models.walls import Wall, as_wall, check_above
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh, check_mesh
from mpm.background import Background
from mpm.body import Body
from mpm.books import Books
from mpm.checkpoint import RestartableSteps
from mpm.conduction import Conduction
from mpm.configurations import Total, find_configuration
from mpm.contact import Contact
from mpm.dilatation import Dilatation, find_cure
from mpm.forces import Forces
from mpm.fracture import Neighbours
from mpm.interpolation.catalogue import check_interpolation, make_interpolation
from mpm.limits import bounds_of, check_size
from mpm.mirrors import find_mirrors
from mpm.musl import MUSL, USL, Remap, check_update
from mpm.particles import GAUSS, rim_faces
from mpm.readout import Readout
from mpm.reference_contact import ReferenceContact
from mpm.small_masses import warn_of_small_masses
from mpm.stepping import Stepping
from mpm.stress_power import StressPower
from mpm.supports import Supports
from mpm.surface import Surface
from mpm.transfers import make_transfer
from mpm.xpic import Filter


class Solver(RestartableSteps, Stepping, Books, Readout, Body):
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
        warn_of_small_masses(interpolation, transfer, update)
        cured = find_cure(cure)
        frame = find_configuration(configuration, interpolation, conduction)
        self._transfer = make_transfer(transfer, flip_fraction, xpic_order)
        check_between("cell_size", cell_size, 0.0, math.inf, "m")
        self.cfl = check_between("cfl", cfl, 0.0, 1.0)
        kind = find_geometry(geometry, mesh.dimension)
        check_plane(material, kind)
        mesh = axisymmetric(mesh) if isinstance(kind, Axisymmetric) else mesh
        wall = as_wall(wall)
        self._agreement = check_loads(loads, mesh, kind, conduction=conduction)
        check_above(wall, mesh.points, kind)
        check_displacement(displacement, mesh, kind, loads, wall)
        base, mirrors = find_mirrors(mesh, kind, loads, wall, cell_size)
        check_size(mesh, kind, cell_size, mirrors)
        super().__init__(
            mesh, material, kind, Threads(threads), seeding=seeding, velocity=velocity, displacement=displacement,
            temperature=temperature, viscosity=viscosity, affine=self._transfer.affine, conduction=conduction,
            configuration=frame, loads=loads,
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
        self._neighbours: Neighbours | None = None
        self.time, self.step_count, self.point_updates, self.node_updates = 0.0, 0, 0, 0
        self._last_step = 0.0
        self.initial_momentum = self.momentum
        self.wall_impulse, self.wall_force = 0.0, 0.0
        self._kinetic, self._stress_power, self._ahead = self._particle_energy(), 0.0, 0.0
        self._powers = StressPower(self.points)
        stored, dissipated = self.stored_energy, self.plastic_energy
        self._ledger = EnergyLedger(
            self._kinetic + stored + dissipated, self._kinetic, stored, plastic=dissipated
        )
        self.time_step = self._stable_step(self._speed(), float(self.points.wave_speed.max()), 0.0)
        self._first_step = self.time_step
