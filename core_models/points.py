"""Material points: what a particle of the material point method and a quadrature point of a finite element share."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core_models.arguments import check_not_negative, check_step, numbers_of, require_writable
from core_models.at_rest import bulk_at_rest, initial_state, initial_wave_speed
from core_models.bulk_viscosity import BulkViscosity
from core_models.compilation import CHUNK
from core_models.errors import RunFailure, UnsupportedError
from core_models.geometry import Geometry
from core_models.kernels import PLASTIC, PRESSURE, SPEED, VISCOUS, WORK, advance_points
from core_models.laws import (
    damage_of_porosity,
    stability_measure,
)
from core_models.material import Material
from core_models.mirror_images import Plane
from core_models.nonlocal_average import SPATIAL, NonlocalAverage
from core_models.rows import make_workspace
from core_models.status import MEANING, OK
from core_models.threads import Threads
from core_models.updates import continuing_general  # noqa: F401
from core_models.updates.continuing_tangent import continuing_tangents
from core_models.updates.tangent_kernel import linearise_points

UNITS = {
    "stress": "Pa",
    "rotation": "1",
    "elastic_left_cauchy_green": "1",
    "equivalent_plastic_strain": "1",
    "hardening_variable": "Pa",
    "temperature": "K",
    "damage": "1",
    "internal_energy": "J/m^3",
    "plastic_volume": "1",
    "porosity": "1",
    "back_stress": "Pa",
}


class Field(NamedTuple):
    """A named quantity at material points."""

    name: str
    unit: str
    shape: tuple[int, ...]
    array: np.ndarray


class Work(NamedTuple):
    """What a step did to all points: work of the stress, plastic and viscous dissipation [J]; and the largest wave
    speed [m/s] and viscous pressure [Pa].
    """

    stress: float
    plastic: float
    viscous: float
    wave_speed: float
    viscous_pressure: float


class PointFailure(Exception):
    """A step that some point cannot take; the solver redoes it smaller before it gives up."""

    def __init__(self, status: int, point: int) -> None:
        self.status = status
        self.point = point
        super().__init__(MEANING[status])


class MaterialPoints:
    """State of n material points, laid out from the material: no array for an effect that is off.

    Parameters
    ----------
    material : laws. reference_volumes : (n,) [m^3]. temperature : initial [K], None for the card's room temperature.
    viscosity : bulk viscosity or None. threads : worker threads. conduction : whether heat is conducted, so that the
    points have a temperature even if no law feels it.

    `advance` reads the state `old` and writes `new`; `accept` makes the new state the old one. A step that is
    rejected is simply advanced again.

    Raises SceneError for volumes and temperatures that are negative or not finite, no points, deformation gradients
    that are not (n, 3, 3), and for steps that are not positive.
    """

    def __init__(
        self,
        material: Material,
        reference_volumes: np.ndarray,
        temperature: float | None = None,
        viscosity: BulkViscosity | None = None,
        threads: Threads | None = None,
        conduction: bool = False,
    ) -> None:
        self.material = material
        self.model = material.model
        self.viscosity = viscosity
        self.reference_volumes = numbers_of("reference_volumes", reference_volumes, (None,))
        self.n = len(self.reference_volumes)
        check_not_negative("a reference volume", self.reference_volumes, "m^3")
        self.threads = threads or Threads(1)
        start = material.room_temperature if temperature is None else temperature
        check_not_negative("a temperature", start, "K")
        self.old = initial_state(material, self.n, start, conduction)
        self.new = initial_state(material, self.n, start, conduction)
        self.old_deformation_gradient = np.tile(np.eye(3), (self.n, 1, 1))
        self.deformation_gradient = self.old_deformation_gradient.copy()
        self.viscous_pressure = None if viscosity is None else np.zeros(self.n)
        self._new_viscous_pressure = None if viscosity is None else np.zeros(self.n)
        self.lengths = None if viscosity is None else np.zeros(self.n)
        self.wave_speed = np.full(self.n, initial_wave_speed(material))
        self._average: NonlocalAverage | None = None
        chunks = -(-self.n // CHUNK)
        self._workspaces = [make_workspace() for _thread in range(self.threads.count)]
        self._sums = np.zeros((chunks, 5))
        self._failures = np.zeros((chunks, 2), dtype=np.int64)

    def advance(self, dt: float) -> Work:
        """Advance all points from `old_deformation_gradient` to `deformation_gradient` within dt [s].

        Raises PointFailure naming the first point that cannot follow.
        """
        check_step(dt)
        before, after = self._motion()
        self.threads.run_with(
            advance_points, len(self._sums), self._workspaces, self.model, self.viscosity, before, after, dt,
            self.reference_volumes, self.lengths, self.old,
            self.new, self.wave_speed, self._new_viscous_pressure, self._sums, self._failures,
        )  # fmt: skip
        return self._outcome()

    def linearise(self, dt: float, stresses: np.ndarray, tangents: np.ndarray) -> Work:
        """Advance as `advance` does, and fill first Piola stresses and consistent tangents.

            P = J sigma F^-T,   dP_iJ / dF_kL in row 3 i + J and column 3 k + L

        Parameters
        ----------
        dt : [s]. stresses : (n, 3, 3) [Pa]; tangents : (n, 9, 9) [Pa]; both contiguous, written: the derivative of the
        step from `old_deformation_gradient` to `deformation_gradient` within dt, at a kink of a law that of one side.

        Raises PointFailure as `advance` does, UnsupportedError with bulk viscosity, which belongs to explicit steps,
        and for arrays that cannot be written.
        Source: Simo & Taylor, Comput. Methods Appl. Mech. Eng. 48 (1985) 101.
        """
        check_step(dt)
        if self.viscosity is not None:
            raise UnsupportedError("a step with bulk viscosity has no tangent: leave the viscosity out")
        require_writable("stresses", stresses, (self.n, 3, 3))
        require_writable("tangents", tangents, (self.n, 9, 9))
        before, after = self._motion()
        self.threads.run_with(
            linearise_points, len(self._sums), self._workspaces, self.model, before, after, dt,
            self.reference_volumes, self.old, self.new, self.wave_speed, self._sums,
            self._failures, stresses.reshape(self.n, 9), tangents,
        )  # fmt: skip
        return self._outcome()

    def stability(self) -> np.ndarray:
        """Measure of the material's stability law for the accepted state, (n,) [-]: lost at and below 0.

        A point that flows is taken to flow on, at its rate; one without strength has nothing to lose and counts as
        elastic.
        Raises UnsupportedError without a stability law.
        """
        material = self.material
        if material.stability is None:
            raise UnsupportedError(f"{material.name} has no stability law: give it one, such as drucker")
        f = self.old_deformation_gradient
        stresses, tangents = np.empty((self.n, 3, 3)), np.empty((self.n, 9, 9))
        self.threads.run_with(
            continuing_tangents, len(self._sums), self._workspaces, self.model, f.reshape(self.n, 9), self.old,
            stresses.reshape(self.n, 9), tangents,
        )  # fmt: skip
        over_volume = 1.0 / np.linalg.det(f)
        spatial = np.einsum(
            "n,njJ,niJkL,nlL->nijkl", over_volume, f, tangents.reshape(self.n, 3, 3, 3, 3), f, optimize=True
        )
        cauchy = np.einsum("n,niJ,njJ->nij", over_volume, stresses, f)
        shear = material.shear_at_rest(material.room_temperature)
        bulk = bulk_at_rest(material)
        return stability_measure(material.stability, spatial, cauchy, bulk, shear)

    def _motion(self) -> list[np.ndarray]:
        """Deformation gradients before and after the step, (n, 9) each."""
        names = ("old_deformation_gradient", "deformation_gradient")
        return [numbers_of(name, getattr(self, name), (self.n, 3, 3)).reshape(self.n, 9) for name in names]

    def _outcome(self) -> Work:
        bad = np.flatnonzero(self._failures[:, 0] != OK)
        if bad.size:
            raise PointFailure(*(int(value) for value in self._failures[bad[0]]))
        totals, largest = self._sums.sum(axis=0), self._sums.max(axis=0)
        return Work(
            float(totals[WORK]), float(totals[PLASTIC]), float(totals[VISCOUS]), float(largest[SPEED]),
            float(largest[PRESSURE]),
        )  # fmt: skip

    def connect(
        self, positions: np.ndarray, geometry: Geometry = SPATIAL, planes: Sequence[Plane] = ()
    ) -> None:
        """Prepare the average of a nonlocal damage, if the material asks for one.

        positions : of the points in the reference body (n, d) [m]. geometry : of these coordinates. planes : of
        symmetry, in which the body is continued. Raises SceneError for positions that are not (n, d).
        """
        radius = self.material.damage_radius
        if radius is not None:
            positions = numbers_of("positions", positions, (self.n, None))
            self._average = NonlocalAverage(positions, self.reference_volumes, radius, geometry, planes)

    def accept(self) -> None:
        """Make the new state the old one."""
        if self._average is not None:
            self._average_damage(self._average)
        self.old, self.new = self.new, self.old
        self.viscous_pressure, self._new_viscous_pressure = self._new_viscous_pressure, self.viscous_pressure
        self.old_deformation_gradient, self.deformation_gradient = (
            self.deformation_gradient,
            self.old_deformation_gradient,
        )

    def _average_damage(self, average: NonlocalAverage) -> None:
        """Spread what the step has added to the damage; with voids to the porosity, which the damage follows."""
        old, new = self.old, self.new
        is_sound = old.damage < 1.0
        if new.porosity is None:
            average.apply(old.damage, new.damage, is_sound)
            return
        average.apply(old.porosity, new.porosity, is_sound)
        condition = self.material.yield_condition
        new.damage[is_sound] = damage_of_porosity(condition, new.porosity[is_sound], old.damage[is_sound])

    @property
    def volume_ratio(self) -> np.ndarray:
        """J = det F of the accepted state, (n,)."""
        return np.linalg.det(self.old_deformation_gradient)

    def fields(self) -> dict[str, Field]:
        """All quantities of the accepted state by name, with unit and shape."""
        arrays = {"deformation_gradient": ("1", self.old_deformation_gradient)}
        arrays |= {
            name: (UNITS[name], array) for name, array in self.old._asdict().items() if array is not None
        }
        if self.material.stability is not None:
            arrays["stability"] = ("1", self.stability())
        if self.viscous_pressure is not None:
            arrays["viscous_pressure"] = ("Pa", self.viscous_pressure)
        return {name: Field(name, unit, array.shape[1:], array) for name, (unit, array) in arrays.items()}

    def place(self, step: int, time: float, point: int) -> str:
        """Step, time, point, material and laws, for error messages."""
        laws = ", ".join(type(law).__name__ for law in self.material.laws)
        return f"step {step}, t = {time:.6e} s, point {point} (material {self.material.name}: {laws})"

    def failure(self, reason: PointFailure, step: int, time: float) -> RunFailure:
        """The error that ends a run: names step, time, point, law and what to try."""
        return RunFailure(
            f"{self.place(step, time, reason.point)}: {reason} even after the step was made smaller; "
            "check velocity and material, or try another resolution"
        )
