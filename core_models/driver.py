"""The bare driver: one material point along a deformation path or a loading program, without mesh or grid."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import RunFailure, SceneError
from core_models.loading_program import Program
from core_models.loading_step import TRIALS, SegmentLoading, UnmetControls
from core_models.material import Material
from core_models.points import MaterialPoints, PointFailure


class History(NamedTuple):
    """What a point went through; row i belongs to the end of step i of the path or program, row 0 is the start.

    times : (k,) [s]. fields : every field of the point's state by name, (k, ...), in the units of
    `MaterialPoints.fields`. stress_work, plastic, viscous : (k,) work of the stress, plastic dissipation and work of
    the bulk viscosity up to then, per reference volume [J/m^3]. wave_speed : (k,) [m/s].
    """

    times: np.ndarray
    fields: dict[str, np.ndarray]
    stress_work: np.ndarray
    plastic: np.ndarray
    viscous: np.ndarray
    wave_speed: np.ndarray

    @property
    def stress(self) -> np.ndarray:
        """Cauchy stress (k, 6) [Pa], components 11, 22, 33, 12, 23, 31."""
        return self.fields["stress"]

    @property
    def deformation_gradient(self) -> np.ndarray:
        """F (k, 3, 3) [-]."""
        return self.fields["deformation_gradient"]

    @property
    def pressure(self) -> np.ndarray:
        """-(s11 + s22 + s33) / 3 (k,) [Pa], positive in compression."""
        return 0.0 - self.stress[:, :3].mean(axis=1)

    @property
    def mises(self) -> np.ndarray:
        """von Mises' equivalent stress sqrt(3/2 s:s) (k,) [Pa]."""
        normal = self.stress[:, :3] + self.pressure[:, None]
        return np.sqrt(1.5 * (normal**2).sum(axis=1) + 3.0 * (self.stress[:, 3:] ** 2).sum(axis=1))


def drive(
    material: Material,
    deformation_gradients: ArrayLike,
    time_steps: ArrayLike,
    *,
    temperature: float | None = None,
    viscosity: BulkViscosity | None = None,
    length: float = 0.0,
) -> History:
    """Lead one stress-free point along a path with the kernel that the solvers run.

    Parameters
    ----------
    material : laws.
    deformation_gradients : (k, 3, 3), the first one the identity (see core_models.paths).
    time_steps : duration of each step [s], (k-1,), or one number for all; > 0.
    temperature : at the start [K]; None for the material's room temperature.
    viscosity : bulk viscosity or None. length : its characteristic length [m].

    Raises
    ------
    SceneError : a path of another shape, that starts elsewhere, or with a step that takes no time.
    RunFailure : a step that the point cannot follow; names step, time and law.
    """
    path, steps = _checked(deformation_gradients, time_steps)
    points = MaterialPoints(material, np.ones(1), temperature, viscosity)
    if viscosity is not None:
        points.lengths[:] = length
    history = _empty_history(points, steps)
    _record(history, 0, points, np.zeros(3))
    for step, dt in enumerate(steps, 1):
        points.deformation_gradient[0] = path[step]
        try:
            work = points.advance(float(dt))
        except PointFailure as reason:
            raise _failure(material, reason, step, history.times[step]) from reason
        points.accept()
        _record(history, step, points, np.array([work.stress, work.plastic, work.viscous]))
    return history


def drive_program(material: Material, program: Program, *, temperature: float | None = None) -> History:
    """Lead one stress-free point through a loading program with the kernel that the solvers run.

    Parameters
    ----------
    material : laws; `isothermal(material)` leaves the heating out. program : see core_models.loading_program.
    temperature : at the start [K]; None for the material's room temperature.

    The states are those that `drive` finds along the deformation of the history, bit for bit, where no step had to
    be halved.

    Raises
    ------
    SceneError : a segment that deforms too much in a step, or to no volume.
    RunFailure : a step whose controls no deformation was found to meet; names step, components and what is missed.
    """
    points = MaterialPoints(material, np.r_[1.0, np.zeros(TRIALS - 1)], temperature)
    history = _empty_history(points, program.time_steps)
    _record(history, 0, points, np.zeros(3))
    row = 0
    for number, segment in enumerate(program.segments, 1):
        loading = SegmentLoading(points, segment, number)
        for step in range(segment.steps):
            row += 1
            try:
                stress_work, plastic = loading.advance(step, step + 1)
            except (PointFailure, UnmetControls) as reason:
                raise _failure(material, reason, row, history.times[row]) from reason
            _record(history, row, points, np.array([stress_work, plastic, 0.0]))
    return history


def isothermal(material: Material) -> Material:
    """The material without heating by plastic work: its temperature stays what it was at the start."""
    return replace(material, heating=None)


def _checked(deformation_gradients: ArrayLike, time_steps: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    path = np.asarray(deformation_gradients, dtype=np.float64)
    if path.ndim != 3 or path.shape[1:] != (3, 3) or not np.array_equal(path[:1], np.eye(3)[None]):
        raise SceneError(
            f"a path is an array (k, 3, 3) that starts with the identity, not one of shape {path.shape}"
        )
    try:
        steps = np.broadcast_to(np.asarray(time_steps, dtype=np.float64), len(path) - 1)
    except ValueError:
        raise SceneError(
            f"a path of {len(path)} needs {len(path) - 1} time steps: give that many, or one"
        ) from None
    if not np.all(steps > 0.0):
        raise SceneError("every time step must be positive: a rate needs time")
    return path, steps


def _empty_history(points: MaterialPoints, steps: np.ndarray) -> History:
    k = len(steps) + 1
    fields = {field.name: np.empty((k, *field.shape)) for field in points.fields().values()}
    return History(np.concatenate([[0.0], np.cumsum(steps)]), fields, *np.zeros((4, k)))


def _record(history: History, row: int, points: MaterialPoints, work: np.ndarray) -> None:
    for field in points.fields().values():
        history.fields[field.name][row] = field.array[0]
    before = max(row - 1, 0)
    for total, increment in zip((history.stress_work, history.plastic, history.viscous), work, strict=True):
        total[row] = total[before] + increment
    history.wave_speed[row] = points.wave_speed[0]


def _failure(material: Material, reason: Exception, step: int, time: float) -> RunFailure:
    laws = ", ".join(type(law).__name__ for law in material.laws)
    return RunFailure(
        f"step {step}, t = {time:.6e} s: {reason} (material {material.name}: {laws}); "
        "lead the point there in smaller steps, or not so far"
    )
