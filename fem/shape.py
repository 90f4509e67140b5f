"""The deformed body as polygons and lines, for pictures and quantities of interest."""

import numpy as np


def outline(boundaries: dict[str, np.ndarray], positions: np.ndarray) -> dict[str, np.ndarray]:
    """Deformed polylines of the named boundaries but the axis, from ordered node pairs."""
    lines = {}
    for name, pairs in boundaries.items():
        if name != "axis":
            lines[name] = positions[np.append(pairs[:, 0], pairs[-1, 1])]
    return lines
