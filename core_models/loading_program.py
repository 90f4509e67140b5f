"""Loading programs: segments one after the other, each with a control for all nine components of the deformation."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from core_models.errors import SceneError
from core_models.loading import (
    Control,
    Deformation,
    Stress,
    Stretch,
    VelocityGradient,
    is_count,
    is_number,
)
from core_models.names import suggestion

COMPONENTS = tuple(f"{i}{j}" for i in "123" for j in "123")
MOST_STEPS = 1_000_000  # rows of a history; some 500 bytes each
FREE = {name: Stress() for name in ("11", "22", "33", "12", "13", "23")}
"""All stresses zero; F_21 = F_31 = F_32 = 0 settle the rotation: the fibre along x keeps its direction."""


@dataclass(frozen=True)
class Segment:
    """A part of a program: all controls change at an even pace.

    Parameters
    ----------
    duration : [s], > 0. steps : number of even steps, recorded one by one, >= 1.
    controls : component name ('11' ... '33') -> control; a component that is left out keeps its F_ij.

    A stress is symmetric: given for ij, it needs a deformation or a rate for ji, which settles the rotation. Stretches
    are for 11, 22 and 33.
    Raises SceneError : values or components that make no sense.
    """

    duration: float
    steps: int
    controls: Mapping[str, Control] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if not (is_number(self.duration) and self.duration > 0.0):
            raise SceneError(f"a segment takes a positive time, not {self.duration!r} s: a rate needs time")
        if not is_count(self.steps, 1) or self.steps > MOST_STEPS:
            raise SceneError(f"a segment takes 1 to {MOST_STEPS} steps, a whole number, not {self.steps!r}")
        for name, control in self.controls.items():
            _check_control(name, control)
        for name in ("12", "13", "23"):
            _check_pair(name, self.control(name), self.control(name[::-1]))

    def control(self, name: str) -> Control:
        """The control of a component."""
        return self.controls.get(name, Deformation())

    def held(self, duration: float, steps: int) -> "Segment":
        """The segment that keeps what this one has reached: its deformations and its stresses."""
        kept = {name: control.afterwards() for name, control in self.controls.items()}
        return Segment(duration, steps, kept)


@dataclass(frozen=True)
class Program:
    """Segments one after the other, from the undeformed, stress-free point. Raises SceneError when there are none."""

    segments: tuple[Segment, ...]

    def __init__(self, segments: Iterable[Segment]) -> None:
        object.__setattr__(self, "segments", tuple(segments))
        if not self.segments:
            raise SceneError("a program needs at least one segment")
        steps = sum(segment.steps for segment in self.segments)
        if steps > MOST_STEPS:
            raise SceneError(f"a program takes {MOST_STEPS} steps at most, not {steps}")

    @property
    def time_steps(self) -> np.ndarray:
        """Duration of every step [s]."""
        return np.concatenate([np.full(part.steps, part.duration / part.steps) for part in self.segments])

    def then_hold(self, duration: float, steps: int) -> "Program":
        """The program, and after it a time [s] in which the last deformations and stresses are kept."""
        return Program((*self.segments, self.segments[-1].held(duration, steps)))


def _check_control(name: str, control: Control) -> None:
    if name not in COMPONENTS:
        raise SceneError(f"unknown component '{name}'; {suggestion(name, COMPONENTS)}")
    if not isinstance(control, Deformation | Stretch | VelocityGradient | Stress):
        raise SceneError(
            f"component {name} takes a Deformation, Stretch, VelocityGradient or Stress, not {control!r}"
        )
    if isinstance(control, Stretch) and name[0] != name[1]:
        raise SceneError(
            f"component {name}: a stretch belongs to 11, 22 or 33; a shear takes a deformation, a rate or a stress"
        )


def _check_pair(name: str, first: Control, second: Control) -> None:
    if isinstance(first, Stress) and isinstance(second, Stress):
        raise SceneError(
            f"the stress {name} is the stress {name[::-1]}: give one of both, and a deformation or rate for the other"
        )
