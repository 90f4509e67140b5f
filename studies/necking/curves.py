"""Curves from elsewhere that a necking scene names."""

import csv

import numpy as np

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.necking.scene import NeckingCurve


def read_curve(curve: NeckingCurve, quantity: str) -> tuple[np.ndarray, np.ndarray]:
    """Elongation [m] and a quantity [SI] of a curve, where it has values; SceneError for a column that is not there."""
    lines = [line for line in curve.path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    column = curve.columns[quantity]
    for name in ("elongation", column):
        if name not in rows[0]:
            raise SceneError(f"{curve.path.name}: no column {name!r}; {suggestion(name, list(rows[0]))}")
    values = [(float(row["elongation"]), float(row[column])) for row in rows if row[column]]
    return tuple(np.array(values, dtype=np.float64).T)
