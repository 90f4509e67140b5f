"""What the way of a body along its path of equilibrium is measured by, where the size of the loads is unknown."""

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from core_models.arguments import check_between
from core_models.errors import SceneError


class Measure(Protocol):
    """A length m of the displacements u (n, d) [m] and of the rise of the load time s [s] within an increment."""

    speed: float

    def value(self, u: np.ndarray, s: float) -> float:
        """m [m], 0 for no motion."""

    def slopes(self, u: np.ndarray, s: float) -> tuple[np.ndarray, float]:
        """dm/du (n, d) and dm/ds [m/s], for motions other than 0."""


@dataclass(frozen=True)
class PathLength:
    """Arc length: m^2 = sum u^2 / n + (weight s)^2; cylindrical with weight 0, else spherical.

    speed : m per time [m/s], > 0. weight : [m/s], >= 0.
    Raises SceneError for numbers out of range.
    Source: Crisfield, Comput. Struct. 13 (1981) 55; Riks, Int. J. Solids Struct. 15 (1979) 529.
    """

    speed: float
    weight: float = 0.0

    def __post_init__(self) -> None:
        check_between("speed", self.speed, 0.0, math.inf, "m/s")
        if not 0.0 <= self.weight < math.inf:
            raise SceneError(
                f"weight = {self.weight!r} m/s is out of range: give a finite number, at least 0"
            )

    def value(self, u: np.ndarray, s: float) -> float:
        """See `Measure`."""
        return float(np.sqrt((u * u).sum() / len(u) + (self.weight * s) ** 2))

    def slopes(self, u: np.ndarray, s: float) -> tuple[np.ndarray, float]:
        """See `Measure`."""
        length = self.value(u, s)
        return u / (len(u) * length), self.weight**2 * s / length


@dataclass(frozen=True)
class MeanDisplacement:
    """m = mean of a component of the displacements of some nodes. nodes : (k,). speed : [m/s], not 0."""

    nodes: np.ndarray
    component: int
    speed: float

    def value(self, u: np.ndarray, s: float) -> float:
        """See `Measure`."""
        return float(u[self.nodes, self.component].mean())

    def slopes(self, u: np.ndarray, s: float) -> tuple[np.ndarray, float]:
        """See `Measure`."""
        slope = np.zeros_like(u)
        slope[self.nodes, self.component] = 1.0 / len(self.nodes)
        return slope, 0.0
