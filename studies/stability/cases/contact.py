"""Contact that comes and goes, friction, and motion onto the axis."""

import numpy as np

from core_models.loads import gravity
from core_models.walls import Wall
from studies.stability.bodies import bar, classic, copper, elastic
from studies.stability.case import Case

DOWN = -2e7  # m/s^2: back on the wall within a few axial periods


def _bouncing(variant: str):
    return bar(variant, elastic(), velocity=-20.0, wall="unilateral", loads=(gravity([0.0, DOWN]),))


def _rubbing(variant: str):
    return bar(variant, copper(), velocity=-400.0, wall=Wall("unilateral", 1.0))


def _imploding(variant: str):
    """All of the bar runs onto its axis."""
    return bar(
        variant,
        classic(),
        velocity=lambda places: np.column_stack([-3e5 * places[:, 0], np.zeros(len(places))]),
    )


CASES = (
    Case("bouncing", "An elastic bar that bounces on the wall under a body force", _bouncing, 40e-6),
    Case("friction", "Copper bar at 400 m/s on a wall with a coefficient of friction of 1", _rubbing, 15e-6),
    Case("onto-the-axis", "A bar that runs onto its axis", _imploding, 2e-6),
)
