"""The controls of a segment where it begins: what they measured there, and whether they can be followed."""

import math
from dataclasses import dataclass

import numpy as np

from core_models.errors import SceneError
from core_models.loading import Control, Deformation, Span, Stress, Trial
from core_models.loading_program import COMPONENTS, Segment
from core_models.points import MaterialPoints

LARGEST_CHANGE = 0.5  # of a component of the deformation in a step


@dataclass(frozen=True)
class Condition:
    """The control of component ij, and what it measured where the segment begins."""

    i: int
    j: int
    control: Control
    start: float

    @property
    def name(self) -> str:
        """Quantity and component, for messages."""
        return f"{self.control.name} {self.i + 1}{self.j + 1}"

    @property
    def is_given(self) -> bool:
        """Whether the control says the component of F itself."""
        return isinstance(self.control, Deformation)

    @property
    def is_stress(self) -> bool:
        """Whether the control is one of a stress."""
        return isinstance(self.control, Stress)

    def goal(self, span: Span) -> float:
        """What the control asks for at the end of a span. Raises SceneError where its function gives no number."""
        goal = self.control.goal(span, self.start)
        if not math.isfinite(goal):
            raise SceneError(
                f"the function for {self.name} gives {goal!r} at t = {span.end:g} s of its segment"
            )
        return goal


def conditions_of(points: MaterialPoints, segment: Segment, number: int) -> list[Condition]:
    """The conditions of all nine components; points stand where segment `number` begins.

    Raises SceneError : a segment that changes a component by more than LARGEST_CHANGE in a step, or leads to no volume.
    """
    gradients = points.old_deformation_gradient
    now = Trial(gradients[:1], gradients[0], points.old.stress[:1])
    conditions = []
    for name in COMPONENTS:
        i, j, control = int(name[0]) - 1, int(name[1]) - 1, segment.control(name)
        conditions.append(Condition(i, j, control, float(control.measure(now, i, j)[0])))
    _check_changes(conditions, segment, number)
    _check_volume(conditions, segment, number)
    return conditions


def _check_changes(conditions: list[Condition], segment: Segment, number: int) -> None:
    for c in conditions:
        change = c.control.change(segment.duration, c.start)
        if change > LARGEST_CHANGE * segment.steps:
            raise SceneError(
                f"segment {number} changes {c.name} by {change / segment.steps:.4g} in each of its {segment.steps} "
                f"steps, more than {LARGEST_CHANGE:g}: take {math.ceil(change / LARGEST_CHANGE)} or more"
            )


def _check_volume(conditions: list[Condition], segment: Segment, number: int) -> None:
    if not all(c.is_given and not callable(c.control.target) for c in conditions):
        return
    whole = Span(0.0, segment.duration, segment.duration)
    ratio = float(np.linalg.det(np.reshape([c.goal(whole) for c in conditions], (3, 3))))
    if not ratio > 0.0:
        raise SceneError(f"segment {number} leads to det F = {ratio:.6g}: a volume must stay positive")
