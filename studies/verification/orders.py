"""Observed orders of convergence."""

from collections.abc import Sequence

import numpy as np


def fitted_order(sizes: Sequence[float], errors: Sequence[float]) -> float:
    """Exponent p of the least-squares fit error = a size^p; not a number when an error is 0 or none."""
    sizes, errors = np.asarray(sizes, dtype=float), np.asarray(errors, dtype=float)
    if not np.all(errors > 0.0):
        return float("nan")
    return float(np.polyfit(np.log(sizes), np.log(errors), 1)[0])


def sizes_before_floor(sizes: Sequence[float], errors: Sequence[float], flat: float, least: int = 4) -> int:
    """How many of the sizes, coarsest first, come before the first local order below `flat`; at least `least`."""
    local = [fitted_order(sizes[i : i + 2], errors[i : i + 2]) for i in range(len(sizes) - 1)]
    first_flat = next((i for i, order in enumerate(local) if not order >= flat), len(local))
    return min(max(first_flat + 1, least), len(sizes))


def error_at(seconds: float, times: Sequence[float], errors: Sequence[float]) -> float | None:
    """Error that a run of `seconds` would have, on the polygon through (log time, log error); None outside it."""
    times, errors = np.asarray(times, dtype=float), np.asarray(errors, dtype=float)
    times, errors = times[errors > 0.0], errors[errors > 0.0]
    rising = np.argsort(times)
    times, errors = times[rising], errors[rising]
    if len(times) < 2 or not times[0] <= seconds <= times[-1]:
        return None
    return float(np.exp(np.interp(np.log(seconds), np.log(times), np.log(errors))))
