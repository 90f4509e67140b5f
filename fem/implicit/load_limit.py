"""The largest load that equilibrium was found for, in words."""

import numpy as np

from core_models.geometry import Geometry
from core_models.loads import BodyForce, Load, Pressure, Traction, at_time
from fem.external import ExternalForces
from meshes.mesh import Mesh

ADVICE = "prescribe displacements, or follow the path with path=PathLength(...) or path=BoundaryMotion(...)"


def growing_loads(
    loads: tuple[Load, ...],
    mesh: Mesh,
    geometry: Geometry,
    masses: np.ndarray,
    x: np.ndarray,
    times: tuple[float, float],
) -> str:
    """Loads that differ between two times [s] on nodes at x (n, d) [m], and their sizes at the first; '' if none does.

    masses (n,) : of the nodes [kg].
    """
    told = []
    for load in loads:
        if not isinstance(load, Traction | BodyForce | Pressure):
            continue
        external = ExternalForces((load,), mesh, geometry, masses)
        before, after = (external.at(x, time) for time in times)
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
