"""Layers whose heights grow in geometric progression."""

import numpy as np


def progression(share: np.ndarray, count: int, grading: float) -> np.ndarray:
    """Heights from 0 to 1 of `count` layers, at shares from 0 to 1 of their number; linear within a layer.

    grading : height of the first layer divided by that of the last, > 0.
    """
    sizes = np.geomspace(grading, 1.0, count) if count > 1 else np.ones(1)
    heights = np.concatenate([[0.0], np.cumsum(sizes / sizes.sum())])
    heights[-1] = 1.0
    return np.interp(share * count, np.arange(count + 1.0), heights)
