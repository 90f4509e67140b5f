"""Fields of two runs on one mesh: cell means over the undeformed bar, their difference and its norm."""

from dataclasses import dataclass

import numpy as np

from studies.runs.result import RunResult
from studies.scenes.scene import Scene

FIELDS = {"equivalent_plastic_strain": "1", "temperature": "K", "pressure": "Pa"}
"""Fields that are compared, with their units."""


@dataclass(frozen=True)
class FieldGap:
    """How far a field of the second run is from the first's, over the reference volume.

    rms : root-mean-square difference. relative : by that of the first run's field, of temperature by its rise (None:
    that is zero). largest : difference of largest size, at position (r, z) [m] of the undeformed bar.
    """

    field: str
    unit: str
    first: str
    second: str
    rms: float
    relative: float | None
    largest: float
    position: tuple[float, float]


@dataclass(frozen=True)
class FieldMaps:
    """Cell means of both runs.

    cells (k, 4, 2) : of the undeformed bar [m]. first, second : name -> means (k,), NaN in cells without a point of the
    run. cell_of (n,) : the cell of each point of the first run. gaps : norms.
    """

    cells: np.ndarray
    first: dict[str, np.ndarray]
    second: dict[str, np.ndarray]
    cell_of: np.ndarray
    gaps: list[FieldGap]

    def cell_data(self) -> dict[str, np.ndarray]:
        """Both fields and second minus first, by name, for a file."""
        data = {}
        for name, first in self.first.items():
            second = self.second[name]
            data |= {f"{name}_first": first, f"{name}_second": second, f"{name}_difference": second - first}
        return data


def field_maps(first: RunResult, second: RunResult) -> FieldMaps:
    """Both runs' final fields as volume-weighted means over the cells of an even mesh, as fine as the coarser run."""
    scene, across = first.scene, min(first.resolution, second.resolution)
    along = max(round(across * scene.bar.length / scene.bar.radius), 1)
    cells, volumes = _cells(scene, across, along)
    places = [_cell_numbers(run, across, along) for run in (first, second)]
    names = [name for name in FIELDS if all(name in run.final.fields for run in (first, second))]
    means = [
        {name: _means(run.final.fields[name], run.final.volumes, place, len(cells)) for name in names}
        for run, place in zip((first, second), places, strict=True)
    ]
    gaps = [_gap(name, first, second, means, cells, volumes) for name in names]
    return FieldMaps(cells, *means, places[0], gaps)


def _cells(scene: Scene, across: int, along: int) -> tuple[np.ndarray, np.ndarray]:
    """Corners (k, 4, 2) and volumes (k,), row by row from the foot."""
    r = np.linspace(0.0, scene.bar.radius, across + 1)
    z = np.linspace(0.0, scene.bar.length, along + 1)
    low, left = (index.ravel() for index in np.meshgrid(np.arange(along), np.arange(across), indexing="ij"))
    corners = [(r[left + i], z[low + j]) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    cells = np.stack([np.column_stack(corner) for corner in corners], axis=1)
    return cells, np.pi * (r[left + 1] ** 2 - r[left] ** 2) * (z[low + 1] - z[low])


def _cell_numbers(run: RunResult, across: int, along: int) -> np.ndarray:
    bar = run.scene.bar
    shares = run.final.reference / [bar.radius, bar.length]
    left, low = (np.clip((shares[:, k] * n).astype(int), 0, n - 1) for k, n in enumerate((across, along)))
    return low * across + left


def _means(values: np.ndarray, volumes: np.ndarray, place: np.ndarray, count: int) -> np.ndarray:
    total = np.bincount(place, volumes, count)
    total[total == 0.0] = np.nan
    return np.bincount(place, volumes * values, count) / total


def _gap(
    name: str,
    first: RunResult,
    second: RunResult,
    means: list[dict[str, np.ndarray]],
    cells: np.ndarray,
    volumes: np.ndarray,
) -> FieldGap:
    base, other = (mean[name] for mean in means)
    known = np.isfinite(base) & np.isfinite(other)
    difference = np.where(known, other - base, 0.0)
    if name == "temperature":
        base = base - first.scene.bar.temperature
    weights = np.where(known, volumes, 0.0)
    rms, size = (
        float(np.sqrt(weights @ values**2 / weights.sum()))
        for values in (difference, np.where(known, base, 0.0))
    )
    worst = int(np.abs(difference).argmax())
    r, z = cells[worst].mean(axis=0)
    return FieldGap(
        name,
        FIELDS[name],
        first.label,
        second.label,
        rms,
        rms / size if size else None,
        float(difference[worst]),
        (float(r), float(z)),
    )
