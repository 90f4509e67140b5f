"""Steps of a loading program: the deformation that meets all controls, found by Newton's method."""

from dataclasses import dataclass

import numpy as np

from core_models.loading import Span, Trial
from core_models.loading_condition import conditions_of
from core_models.loading_program import Segment
from core_models.points import MaterialPoints, PointFailure

TRIALS = 10  # points that are advanced together: a deformation, and a change of each of its nine components
ITERATIONS = 40
HALVINGS = 12  # of a Newton step
CUTS = 8  # halvings of a time step
LARGEST_CORRECTION = 0.2  # of a component in an iteration, of the stretch of its fibre
DIFFERENCE = 1e-7  # for slopes, of the same
STRESS_TOLERANCE = 1e-9  # of the largest stress component
MEASURE_TOLERANCE = 1e-13  # of stretches and L dt
ROUND_OFF = 16.0 * np.finfo(float).eps  # of the stiffness: what stresses can be told apart by
NO_SLOPE = 1e-10  # of the largest one


class UnmetControls(Exception):
    """No deformation was found that meets the controls of a step; says what is missed by how much."""


@dataclass(frozen=True)
class Attempt:
    """A deformation gradient, the stretches of the fibres whose components are sought (k,), by how much the goals are
    missed (k,), the slopes of that by the components over these stretches (k, k), and how much may be missed (k,);
    stresses over the stiffness.
    """

    deformation: np.ndarray
    stretches: np.ndarray
    missed: np.ndarray
    slopes: np.ndarray
    limits: np.ndarray

    @property
    def is_met(self) -> np.ndarray:
        """Which goals are met; not-a-number meets none."""
        return np.abs(self.missed) <= self.limits

    @property
    def is_finite(self) -> bool:
        """Whether the slopes can be used."""
        return bool(np.all(np.isfinite(self.slopes)))


class SegmentLoading:
    """Leads points along a segment; all of them are always in the same state.

    Parameters
    ----------
    points : TRIALS points of the material, which stand where the segment begins.
    segment : controls. number : of the segment, for messages.

    Each step solves measure(F) = goal for the components of F that no Deformation gives, with slopes by differences:
    one call of the point update does for a deformation and all its changes. A step that is not found is halved.
    Raises SceneError : a segment that deforms too much in a step, or to no volume.
    """

    def __init__(self, points: MaterialPoints, segment: Segment, number: int) -> None:
        self._points = points
        self._segment = segment
        conditions = conditions_of(points, segment, number)
        self._given = [c for c in conditions if c.is_given]
        self._sought = [c for c in conditions if not c.is_given]
        self._is_stress = np.array([c.is_stress for c in self._sought], dtype=bool)
        stiffness = points.material.density * float(points.wave_speed[0]) ** 2
        self._scale = np.where(self._is_stress, stiffness, 1.0)
        of_return = getattr(points.material.update, "tolerance", 0.0)  # an update without plasticity has none
        self._stress_tolerance = max(STRESS_TOLERANCE, 10.0 * of_return)
        self._last_rate = np.zeros((3, 3))

    def advance(self, begin: float, end: float, cuts: int = 0) -> np.ndarray:
        """Advance and accept from `begin` to `end`, counted in steps of the segment.

        Returns work of the stress and plastic dissipation [J/m^3].
        Raises PointFailure or UnmetControls.
        """
        try:
            return self._follow(begin, end)
        except (PointFailure, UnmetControls):
            if cuts == CUTS:
                raise
        middle = 0.5 * (begin + end)
        return self.advance(begin, middle, cuts + 1) + self.advance(middle, end, cuts + 1)

    def _follow(self, begin: float, end: float) -> np.ndarray:
        duration, steps = self._segment.duration, self._segment.steps
        span = Span(begin / steps * duration, end / steps * duration, duration)
        dt = (end - begin) * (duration / steps)
        before = self._points.old_deformation_gradient[0].copy()
        try:
            deformation = self._found(span, dt, before, before + self._last_rate * dt)
        except (PointFailure, UnmetControls):
            deformation = self._found(span, dt, before, before)
        self._points.deformation_gradient[:] = deformation
        work = self._points.advance(dt)
        self._points.accept()
        self._last_rate = (deformation - before) / dt
        return np.array([work.stress, work.plastic])

    def _found(self, span: Span, dt: float, before: np.ndarray, guess: np.ndarray) -> np.ndarray:
        deformation = guess.copy()
        for c in self._given:
            deformation[c.i, c.j] = c.goal(span)
        if not self._sought:
            return deformation
        goals = np.array([c.goal(span) for c in self._sought])
        attempt = self._attempt(deformation, dt, before, goals)
        for _iteration in range(ITERATIONS):
            if attempt.is_met.all():
                return attempt.deformation
            better = self._better(attempt, dt, before, goals) if attempt.is_finite else None
            if better is None:
                break
            attempt = better
        raise UnmetControls(self._complaint(goals, attempt))

    def _better(self, attempt: Attempt, dt: float, before: np.ndarray, goals: np.ndarray) -> Attempt | None:
        """The attempt after a Newton step, made smaller until it misses less than before; None if it never does."""
        correction = self._correction(attempt)
        for halving in range(HALVINGS):
            try:
                candidate = self._attempt(attempt.deformation + 0.5**halving * correction, dt, before, goals)
            except PointFailure:
                continue
            if np.linalg.norm(candidate.missed) < np.linalg.norm(attempt.missed):
                return candidate
        return None

    def _attempt(self, deformation: np.ndarray, dt: float, before: np.ndarray, goals: np.ndarray) -> Attempt:
        trials = self._points.deformation_gradient
        trials[:] = deformation
        stretches = np.array([np.linalg.norm(deformation[:, c.j]) for c in self._sought])
        changes = self._spread(trials, DIFFERENCE * stretches)
        if self._is_stress.any():
            self._points.advance(dt)
        trial = Trial(trials, before, self._points.new.stress)
        measures = np.stack([c.control.measure(trial, c.i, c.j) for c in self._sought], axis=1)
        missed = (measures - goals) / self._scale
        slopes = ((missed[1 : len(changes) + 1] - missed[0]) * (stretches / changes)[:, None]).T
        return Attempt(deformation, stretches, missed[0], slopes, self._limits(goals, trial.stresses[0]))

    def _spread(self, trials: np.ndarray, sizes: np.ndarray) -> np.ndarray:
        """Change one sought component in each trial but the first; returns by how much, after rounding."""
        for row, (c, size) in enumerate(zip(self._sought, sizes, strict=True), 1):
            trials[row, c.i, c.j] += size
        return np.array(
            [trials[row, c.i, c.j] - trials[0, c.i, c.j] for row, c in enumerate(self._sought, 1)]
        )

    def _limits(self, goals: np.ndarray, stress: np.ndarray) -> np.ndarray:
        largest = max(np.abs(stress).max(), np.abs(goals[self._is_stress]).max(initial=0.0))
        return np.where(
            self._is_stress, self._stress_tolerance * largest / self._scale + ROUND_OFF, MEASURE_TOLERANCE
        )

    def _correction(self, attempt: Attempt) -> np.ndarray:
        # Least squares: a point without strength leaves components open, and these then stay where they are.
        found = np.linalg.lstsq(attempt.slopes, -attempt.missed, rcond=NO_SLOPE)[0]
        found *= LARGEST_CORRECTION / max(np.abs(found).max(), LARGEST_CORRECTION)
        correction = np.zeros((3, 3))
        for c, value in zip(self._sought, found * attempt.stretches, strict=True):
            correction[c.i, c.j] = value
        return correction

    def _complaint(self, goals: np.ndarray, attempt: Attempt) -> str:
        rows = zip(self._sought, goals, attempt.missed * self._scale, attempt.is_met, strict=True)
        told = [
            f"{c.name} = {goal:.6g}{c.control.unit} is missed by {gap:.3g}"
            for c, goal, gap, met in rows
            if not met
        ]
        return f"no deformation was found that meets all controls: {', '.join(told)}"
