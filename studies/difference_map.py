"""Where two methods differ: their final fields on one mesh of the undeformed bar."""

from dataclasses import dataclass

import numpy as np

from studies.methods import find_method
from studies.output_folder import OutputFolder
from studies.run_result import RunResult

FILE = "difference.vtu"


@dataclass(frozen=True)
class DifferenceMap:
    """Fields of two runs as means over the same cells.

    cells : (m, 4, 2) undeformed, in (r, z) [m]. labels : of the runs. fields : by name, of both runs, (m,) or (m, 2).
    """

    cells: np.ndarray
    labels: tuple[str, str]
    fields: dict[str, tuple[np.ndarray, np.ndarray]]

    def difference(self, name: str) -> np.ndarray:
        """Second minus first, in every cell."""
        first, second = self.fields[name]
        return second - first

    def summary(self) -> dict[str, dict[str, float]]:
        """By field: root-mean-square and largest difference, and the first run's largest value."""
        return {
            name: {
                "rms": float(np.sqrt((self.difference(name) ** 2).mean())),
                "largest": float(np.abs(self.difference(name)).max()),
                "first_largest": float(np.abs(first).max()),
            }
            for name, (first, _) in self.fields.items()
        }


def difference_map(first: RunResult, second: RunResult) -> DifferenceMap:
    """Displacement and scalar fields that both have, on a mesh as fine as the coarser of the two runs.

    A cell's value is the mean over the points that began in it, and that of the nearest point where none did.
    """
    from meshes.taylor_bar import taylor_bar

    bar = first.scene.bar
    mesh = taylor_bar(bar.radius, bar.length, min(first.resolution, second.resolution))
    cells = mesh.points[mesh.cells]
    both = [_fields(run) for run in (first, second)]
    means = [
        _means(cells.mean(axis=1), run.final.reference, fields)
        for run, fields in zip((first, second), both, strict=True)
    ]
    names = [name for name in means[0] if name in means[1]]
    labels = tuple(f"{find_method(run.method).label} {run.resolution}" for run in (first, second))
    return DifferenceMap(cells, labels, {name: (means[0][name], means[1][name]) for name in names})


def write_difference_map(found: DifferenceMap, folder: OutputFolder) -> None:
    """Write all fields of both runs and their differences for ParaView."""
    from meshes.io import write_domains_vtu

    columns = {}
    for name, values in found.fields.items():
        columns |= {f"{name}, {label}": of for label, of in zip(found.labels, values, strict=True)}
        columns[f"{name}, difference"] = found.difference(name)
    write_domains_vtu(folder.file(FILE), found.cells, columns)


def _fields(run: RunResult) -> dict[str, np.ndarray]:
    scalars = {name: values for name, values in run.final.fields.items() if values.ndim == 1}
    return {"displacement": run.final.domains.mean(axis=1) - run.final.reference} | scalars


def _means(centres: np.ndarray, places: np.ndarray, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    from scipy.spatial import cKDTree

    cell = cKDTree(centres).query(places)[1]
    counts = np.bincount(cell, minlength=len(centres))
    empty = np.flatnonzero(counts == 0)
    nearest = cKDTree(places).query(centres[empty])[1]
    found = {}
    for name, values in fields.items():
        sums = np.zeros((len(centres), *values.shape[1:]))
        np.add.at(sums, cell, values)
        means = sums / np.maximum(counts, 1).reshape(-1, *[1] * (values.ndim - 1))
        means[empty] = values[nearest]
        found[name] = means
    return found
