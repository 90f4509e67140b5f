"""Rigid walls at the plane where the last coordinate is 0: the same meaning in every method."""

import math
from dataclasses import dataclass

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Geometry, axis_names
from core_models.names import suggestion

UNILATERAL = "unilateral"
PLANE = "plane"

BELOW = 1e-9  # of the body's size: what is lower than this is below the wall

MEANING = {
    UNILATERAL: "nothing passes, everything may leave",
    PLANE: "what touches the wall is held at zero normal velocity from then on",
}


@dataclass(frozen=True)
class Wall:
    """A rigid wall in the plane where the last coordinate is 0, the body above it.

    kind : 'unilateral' or 'plane'. friction : Coulomb coefficient [-], >= 0; |tangential impulse| <= friction times
    normal impulse, what does not reach that sticks.

    Raises SceneError for an unknown kind or a friction that is no number >= 0.
    """

    kind: str = UNILATERAL
    friction: float = 0.0

    def __post_init__(self) -> None:
        check_wall(self.kind)
        if not (isinstance(self.friction, int | float) and 0.0 <= self.friction < math.inf):
            raise SceneError(f"friction = {self.friction!r} is out of range: give a finite number from 0")


def check_wall(name: str) -> str:
    """The wall's name if there is such a wall; SceneError with the nearest one otherwise."""
    if name in MEANING:
        return name
    raise SceneError(f"no wall is called {name!r}; {suggestion(name, MEANING)}")


def as_wall(wall: Wall | str | None) -> Wall | None:
    """A wall from itself, from the name of its kind (frictionless), or none; SceneError for anything else."""
    if isinstance(wall, str):
        return Wall(wall)
    if wall is None or isinstance(wall, Wall):
        return wall
    raise SceneError(
        f"wall = {wall!r} is no wall: give a core_models.walls.Wall, {' or '.join(MEANING)}, or None"
    )


def check_above(wall: Wall | None, points: np.ndarray, geometry: Geometry) -> None:
    """Refuse a body with points (n, d) [m] that starts below the wall; SceneError with the numbers."""
    if wall is None:
        return
    low, high = float(points[:, -1].min()), float(points[:, -1].max())
    if low < -BELOW * (high - low):
        name = axis_names(geometry)[points.shape[1] - 1]
        raise SceneError(
            f"the body starts from {name} = {low:.6g} to {high:.6g} m, and the wall is at {name} = 0: move the body "
            f"up by {-low:.6g} m, or leave the wall out"
        )
