"""A run of a necking scene: what was measured, the final shape, what it has cost."""

from dataclasses import dataclass

import numpy as np

from studies.necking.bar_necking import NeckingHistory


@dataclass(frozen=True)
class NeckingRun:
    """A run: its history, its final shape and what it cost.

    shape : domains (n, 4, 2) [m] of the points, of a solid those at its section y = 0; strains (n,) : their plastic
    strains. cuts, iterations, orders : of Newton's method; steps : increments or explicit steps. kinetic_share :
    largest share of kinetic energy, 0 for a static run. seconds : of processor time. stopped : why the run did not come
    to its end; all else then is up to where it got.
    """

    history: NeckingHistory
    shape: np.ndarray
    strains: np.ndarray
    seconds: float
    steps: int
    kinetic_share: float = 0.0
    iterations: int = 0
    cuts: int = 0
    orders: tuple[float, ...] = ()
    stopped: str = ""

    @property
    def strained_share(self) -> float:
        """Share of the shape's area where the plastic strain is more than half the largest: small in shear bands."""
        x, y = self.shape[..., 0], self.shape[..., 1]
        areas = 0.5 * np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1))
        return float(areas[self.strains > 0.5 * self.strains.max()].sum() / areas.sum())


def shape_of(solver) -> tuple[np.ndarray, np.ndarray]:
    """Shape and strains, as a run has them, of a solver's present state."""
    domains, strains = solver.domains(), solver.points.old.equivalent_plastic_strain
    if domains.shape[2] == 2:
        return domains, strains.copy()
    y = domains[..., 1]
    at_section = y.min(axis=1) < 0.25 * (y.max(axis=1) - y.min(axis=1))
    nearest = np.argsort(y[at_section], axis=1)[:, :4]
    faces = np.take_along_axis(domains[at_section], nearest[..., None], axis=1)[..., [0, 2]]
    return _in_order(faces), strains[at_section]


def _in_order(faces: np.ndarray) -> np.ndarray:
    """Corners (n, 4, 2) in the order in which they go round."""
    away = faces - faces.mean(axis=1, keepdims=True)
    order = np.argsort(np.arctan2(away[..., 1], away[..., 0]), axis=1)
    return np.take_along_axis(faces, order[..., None], axis=1)
