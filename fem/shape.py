"""The deformed boundary as lines, for pictures and quantities of interest."""

import numpy as np


def chain(facets: np.ndarray) -> np.ndarray:
    """Nodes along a boundary of two-dimensional facets (k, 2), or (k, 3) with the middle node last, head to tail."""
    order = facets[:, [0, *range(2, facets.shape[1])]]
    return np.append(order.ravel(), facets[-1, 1])


def outline(
    boundaries: dict[str, np.ndarray], positions: np.ndarray, on_axis: np.ndarray | None
) -> dict[str, np.ndarray]:
    """Deformed lines (k, 2) of the named boundaries, but for those whose nodes are all on the axis (n,) bool."""
    return {
        name: positions[chain(facets)]
        for name, facets in boundaries.items()
        if on_axis is None or not on_axis[facets].all()
    }
