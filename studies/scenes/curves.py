"""Reference curves that a scene names: CSV with one line of column names, SI units, '#' comments."""

import csv

import numpy as np

from core_models.errors import SceneError
from studies.scenes.scene import ReferenceCurve

COLUMNS = {"history": ("t", "length", "foot_radius"), "profile": ("r", "z")}


def read_curve(curve: ReferenceCurve) -> dict[str, np.ndarray]:
    """Columns by name; raises SceneError naming file and line for anything but numbers."""
    try:
        text = curve.path.read_text(encoding="utf-8")
    except OSError as error:
        raise SceneError(f"{curve.path}: cannot be read ({error.strerror})") from error
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    names, *rows = csv.reader(lines)
    if tuple(names) != COLUMNS[curve.kind]:
        raise SceneError(
            f"{curve.path}: columns must be {','.join(COLUMNS[curve.kind])}, not {','.join(names)}"
        )
    try:
        values = np.array([[float(cell) for cell in row] for row in rows])
    except ValueError as error:
        raise SceneError(f"{curve.path}: {error}; give numbers in SI units") from error
    return dict(zip(names, values.T, strict=True))
