"""The bar's outline and section as half of a meridian plane, whatever dimension it is simulated in."""

import numpy as np

ON_PLANE = 1e-6  # of the bar's size: reference distance within which a point lies on a plane or axis
FACES = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
NEAR = 0.1  # of a domain's extent: how near to the plane a face of it is drawn


def bar_outline(solver) -> dict[str, np.ndarray]:
    """Boundary lines 'foot' (axis to rim), 'side' (foot to rear), 'rear' (rim to axis) as (r, z), (k, 2) [m].

    In three dimensions the mean of the two meridians in the planes x = 0 and y = 0 of a quarter.
    """
    if solver.mesh.dimension == 2:
        return solver.outline()
    lines = {name: _meridian(solver, name) for name in ("foot", "side", "rear")}
    lines["rear"] = lines["rear"][::-1]
    for name, following in (("foot", "side"), ("side", "rear")):
        corner = 0.5 * (lines[name][-1] + lines[following][0])
        lines[name][-1] = lines[following][0] = corner
    return lines


def bar_section(solver) -> tuple[np.ndarray, np.ndarray]:
    """Polygons (k, 4, 2) in (r, z) of the domains cut by the meridian, and the points (k,) that they belong to."""
    domains = solver.domains()
    if domains.shape[-1] == 2:
        return domains, np.arange(len(domains))
    faces = domains[:, FACES]
    distance = np.abs(faces[..., 1].mean(axis=2))
    nearest = distance.argmin(axis=1)
    points = np.arange(len(domains))
    near = distance[points, nearest] < NEAR * np.ptp(domains[..., 1], axis=1)
    return faces[points, nearest][near][..., [0, 2]], points[near]


def _meridian(solver, name: str) -> np.ndarray:
    """The line of a boundary in a quarter's symmetry planes, ordered by radius (foot, rear) or height (side)."""
    reference, current = solver.boundary_points(name)
    tolerance = ON_PLANE * float(solver.mesh.points.max())
    along = [_ordered(reference, current, axis, tolerance, name == "side") for axis in (0, 1)]
    keys, first = along[0]
    second = np.stack([np.interp(keys, along[1][0], along[1][1][:, k]) for k in (0, 1)], axis=1)
    line = 0.5 * (first + second)
    line[:, 0] = np.maximum(line[:, 0], 0.0)
    if name != "side":
        line[0, 0] = 0.0
    return line


def _ordered(
    reference: np.ndarray, current: np.ndarray, axis: int, tolerance: float, by_height: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Points in the plane where coordinate `axis` is 0: reference coordinates (k,) and means of (r, z) there (k, 2)."""
    here = reference[:, axis] < tolerance
    keys = np.round(reference[here, 2 if by_height else 1 - axis] / tolerance)
    unique, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    places = current[here][:, [1 - axis, 2]]
    sums = np.stack([np.bincount(inverse, places[:, k]) for k in (0, 1)], axis=1)
    return unique * tolerance, sums / counts[:, None]
