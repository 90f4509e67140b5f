"""What is prescribed for a component of a material point's deformation: one class per measure.

Every one of the nine components ij of the deformation gradient F has a control. `measure` says what a trial has of
its quantity, `goal` what it should have at the end of a step; a component that no deformation fixes is found such
that both agree (core_models.loading_step).
"""

import math
import numbers
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from core_models.errors import SceneError
from core_models.matrix_logarithm import matrix_logarithm

Target = float | Callable[[float], float]
STRESS_COLUMN = np.array([[0, 3, 5], [3, 1, 4], [5, 4, 2]])


@dataclass(frozen=True)
class Trial:
    """Deformation gradients (m, 3, 3) tried for the end of a step, the one before it (3, 3), stresses (m, 6) [Pa]."""

    gradients: np.ndarray
    before: np.ndarray
    stresses: np.ndarray

    @cached_property
    def rates(self) -> np.ndarray:
        """L dt = ln(F_1 F_0^-1) of each trial (m, 3, 3)."""
        return matrix_logarithm(self.gradients @ np.linalg.inv(self.before))


@dataclass(frozen=True)
class Span:
    """A step, or a part of one, as times since the segment's start, and the segment's duration [s]."""

    begin: float
    end: float
    duration: float

    @property
    def share(self) -> float:
        """Share of the segment that is over at the end of the span."""
        return self.end / self.duration


@dataclass(frozen=True)
class Deformation:
    """Component F_ij of the deformation gradient [-]: linearly to `target`, target(t), or held (None).

    t is the time since the segment's start [s].
    """

    name: ClassVar[str] = "F"
    unit: ClassVar[str] = ""
    target: Target | None = None

    def __post_init__(self) -> None:
        if self.target is not None:
            _check_target(self.name, self.target)

    def measure(self, trial: Trial, i: int, j: int) -> np.ndarray:
        """F_ij of each trial."""
        return trial.gradients[:, i, j]

    def goal(self, span: Span, start: float) -> float:
        """F_ij at the end of the span; start: at the segment's start."""
        return start if self.target is None else _ramp(self.target, span, start)

    def change(self, duration: float, start: float) -> float:
        """Size of the change over the segment as far as it is known before [-]."""
        return 0.0 if self.target is None or callable(self.target) else abs(self.target - start)

    def afterwards(self) -> "Deformation":
        """The control that keeps what this one has reached."""
        return Deformation()


@dataclass(frozen=True)
class Stretch:
    """Stretch |F e_i| of the fibre along axis i [-], > 0: to `target` at a constant true rate, target(t), or held.

    Only for the components 11, 22, 33; without shear it is F_ii.
    """

    name: ClassVar[str] = "ln stretch"
    unit: ClassVar[str] = ""
    target: Target | None = None

    def __post_init__(self) -> None:
        if self.target is not None:
            _check_target("stretch", self.target)
        if is_number(self.target) and not self.target > 0.0:
            raise SceneError(
                f"a stretch must be positive, not {self.target:g}: 1 is no change, 0.9 a compression"
            )

    def measure(self, trial: Trial, i: int, j: int) -> np.ndarray:
        """Logarithm of the stretch of each trial."""
        return 0.5 * np.log(np.sum(trial.gradients[:, :, i] ** 2, axis=1))

    def goal(self, span: Span, start: float) -> float:
        """Logarithm of the stretch at the end of the span; start: at the segment's start."""
        if self.target is None:
            return start
        if callable(self.target):
            stretch = float(self.target(span.end))
            if stretch <= 0.0:
                raise SceneError(
                    f"a stretch must be positive, not {stretch:g} at t = {span.end:g} s of its segment"
                )
            return math.log(stretch)
        return _ramp(math.log(self.target), span, start)

    def change(self, duration: float, start: float) -> float:
        """Size of the change of the logarithm over the segment as far as it is known before [-]."""
        return 0.0 if self.target is None or callable(self.target) else abs(math.log(self.target) - start)

    def afterwards(self) -> "Stretch":
        """The control that keeps what this one has reached."""
        return Stretch()


@dataclass(frozen=True)
class VelocityGradient:
    """Component L_ij of the velocity gradient dF/dt F^-1 [1/s]: constant `rate`, or rate(t) taken at mid-step.

    Over a step L is constant, F_1 = exp(L dt) F_0: a constant rate of stretching gives F_ii = exp(rate t) exactly.
    """

    name: ClassVar[str] = "L dt"
    unit: ClassVar[str] = ""
    rate: Target

    def __post_init__(self) -> None:
        _check_target("L", self.rate)

    def measure(self, trial: Trial, i: int, j: int) -> np.ndarray:
        """L_ij dt of each trial."""
        return trial.rates[:, i, j]

    def goal(self, span: Span, start: float) -> float:
        """L_ij dt over the span."""
        rate = self.rate(0.5 * (span.begin + span.end)) if callable(self.rate) else self.rate
        return float(rate * (span.end - span.begin))

    def change(self, duration: float, start: float) -> float:
        """Size of L_ij times the duration, as far as it is known before [-]."""
        return 0.0 if callable(self.rate) else abs(self.rate * duration)

    def afterwards(self) -> Deformation:
        """The control that keeps what this one has reached."""
        return Deformation()


@dataclass(frozen=True)
class Stress:
    """Component of the Cauchy stress [Pa]: linearly from what it is at the segment's start to `target`, or target(t).

    `Stress()` is a free component: it goes to zero, and stays there where it was zero.
    """

    name: ClassVar[str] = "stress"
    unit: ClassVar[str] = " Pa"
    target: Target = 0.0

    def __post_init__(self) -> None:
        _check_target(self.name, self.target)

    def measure(self, trial: Trial, i: int, j: int) -> np.ndarray:
        """Stress component ij of each trial."""
        return trial.stresses[:, STRESS_COLUMN[i, j]]

    def goal(self, span: Span, start: float) -> float:
        """The stress at the end of the span; start: at the segment's start."""
        return _ramp(self.target, span, start)

    def change(self, duration: float, start: float) -> float:
        """A stress says nothing about the size of the deformation."""
        return 0.0

    def afterwards(self) -> "Stress":
        """The control that keeps what this one has reached; a function of time goes on to zero."""
        return Stress() if callable(self.target) else Stress(self.target)


Control = Deformation | Stretch | VelocityGradient | Stress


def _ramp(target: Target, span: Span, start: float) -> float:
    if callable(target):
        return float(target(span.end))
    return (1.0 - span.share) * start + span.share * target


def is_number(value: object) -> bool:
    """Whether a value is a finite real number."""
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value)


def is_count(value: object, least: int) -> bool:
    """Whether a value is a whole number, not below `least`."""
    return isinstance(value, numbers.Integral) and not isinstance(value, bool) and value >= least


def _check_target(name: str, target: Target) -> None:
    if not (callable(target) or is_number(target)):
        raise SceneError(f"{name} takes a finite number or a function of time, not {target!r}")
