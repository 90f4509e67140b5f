"""The largest load that equilibrium was found for, in words."""

from collections.abc import Callable

import numpy as np

from core_models.loads import BodyForce, Load, Pressure, Traction, at_time


def growing_loads(
    loads: tuple[Load, ...], forces: Callable[[Load, float], np.ndarray], times: tuple[float, float]
) -> str:
    """Loads that differ between two times [s], and their sizes at the first; '' if none does.

    forces : of a load at a time on the body as it is, (n, d) [N], whose sum is the resultant.
    """
    told = []
    for load in loads:
        if not isinstance(load, Traction | BodyForce | Pressure):
            continue
        before, after = (forces(load, time) for time in times)
        if not np.array_equal(before, after):
            told.append(_size(load, before, times[0]))
    return ", ".join(told)


def _size(load: Load, forces: np.ndarray, time: float) -> str:
    if isinstance(load, Pressure):
        return f"a pressure of {at_time(load.pressure, time):.5g} Pa on {load.boundary!r}"
    resultant = float(np.linalg.norm(forces.sum(axis=0)))
    if isinstance(load, BodyForce):
        return f"a body force of {resultant:.5g} N"
    return f"a force of {resultant:.5g} N on {load.boundary!r}"
