"""Exact measures of half profiles: polylines of (r, z) in metres, rotated about the z axis.

Every function is pure and takes arrays of shape (k, 2); a closed half profile is a polygon whose missing side
is the axis. Straight segments are integrated exactly.
"""

import numpy as np

from core_models.errors import SceneError


def half_profile(outline: dict[str, np.ndarray]) -> np.ndarray:
    """Polygon of the half section: foot (from the axis), side, rear (back to the axis), each corner once."""
    return np.concatenate([outline["foot"], outline["side"][1:], outline["rear"][1:]])


def arc_length(line: np.ndarray) -> float:
    """Length of the line [m]."""
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def area(polygon: np.ndarray) -> float:
    """Area inside the polygon [m^2], positive when its corners run counter-clockwise."""
    return float(0.5 * _cross(polygon).sum())


def centroid(polygon: np.ndarray) -> np.ndarray:
    """Centroid (r, z) of the plane region inside the polygon [m]."""
    cross = _cross(polygon)
    moments = ((polygon + np.roll(polygon, -1, axis=0)) * cross[:, None]).sum(axis=0) / 6.0
    return moments / (0.5 * cross.sum())


def revolved_volume(polygon: np.ndarray) -> float:
    """Volume of the body of revolution [m^3]: V = 2 pi r_c A (Pappus)."""
    return float(2.0 * np.pi * centroid(polygon)[0] * area(polygon))


def mean_height(line: np.ndarray) -> float:
    """Area-weighted mean height of a face [m]: integral of z r dr over integral of r dr along the line."""
    r, z = line.T
    dr = np.diff(r)
    weighted = dr * (r[:-1] * (2.0 * z[:-1] + z[1:]) + r[1:] * (z[:-1] + 2.0 * z[1:])) / 6.0
    weight = dr * (r[:-1] + r[1:]) / 2.0
    return float(weighted.sum() / weight.sum())


def median_height(line: np.ndarray, radius: float) -> float:
    """Area-weighted median height of the part of a face within a radius [m]: robust against single corners."""
    pieces = 20  # per segment: the share of a piece in the area is then far below the corner noise
    r = _subdivided(line[:, 0], pieces)
    z = _subdivided(line[:, 1], pieces)
    middle, weight = 0.5 * (r[1:] + r[:-1]), np.abs(np.diff(r**2))
    height, weight = 0.5 * (z[1:] + z[:-1])[middle <= radius], weight[middle <= radius]
    order = np.argsort(height)
    cumulated = np.cumsum(weight[order])
    return float(height[order][np.searchsorted(cumulated, 0.5 * cumulated[-1])])


def radius_at_height(line: np.ndarray, height: float) -> float:
    """Largest radius at which the line crosses the height [m].

    Raises SceneError when the line does not reach it.
    """
    crossings = _crossings(line, height)
    if not crossings:
        raise SceneError(f"the profile does not reach the height {height:g} m: it was crushed below it")
    return max(crossings)


def first_exceeding(line: np.ndarray, radius: float) -> float | None:
    """Height at which the line, walked from its first point, first exceeds the radius [m]; None if never."""
    r, z = line.T
    beyond = np.flatnonzero(r > radius)
    if not beyond.size:
        return None
    i = int(beyond[0])
    if i == 0:
        return float(z[0])
    share = (radius - r[i - 1]) / (r[i] - r[i - 1])
    return float(z[i - 1] + share * (z[i] - z[i - 1]))


def distance_between(first: np.ndarray, second: np.ndarray, samples: int = 400) -> float:
    """Root-mean-square distance between two lines [m], both ways, sampled evenly along each."""
    there = _distances(_resampled(first, samples), second)
    back = _distances(_resampled(second, samples), first)
    return float(np.sqrt(0.5 * (np.mean(there**2) + np.mean(back**2))))


def _cross(polygon: np.ndarray) -> np.ndarray:
    following = np.roll(polygon, -1, axis=0)
    return polygon[:, 0] * following[:, 1] - following[:, 0] * polygon[:, 1]


def _subdivided(values: np.ndarray, pieces: int) -> np.ndarray:
    at = np.linspace(0.0, len(values) - 1.0, pieces * (len(values) - 1) + 1)
    return np.interp(at, np.arange(len(values)), values)


def _crossings(line: np.ndarray, height: float) -> list[float]:
    radii = []
    for (r0, z0), (r1, z1) in zip(line[:-1], line[1:], strict=True):
        if min(z0, z1) <= height <= max(z0, z1):
            share = 0.0 if z1 == z0 else (height - z0) / (z1 - z0)
            radii.append(float(max(r0, r1) if z1 == z0 else r0 + share * (r1 - r0)))
    return radii


def _resampled(line: np.ndarray, samples: int) -> np.ndarray:
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    at = np.linspace(0.0, along[-1], samples)
    return np.column_stack([np.interp(at, along, line[:, 0]), np.interp(at, along, line[:, 1])])


def _distances(points: np.ndarray, line: np.ndarray) -> np.ndarray:
    start, direction = line[:-1], np.diff(line, axis=0)
    squared = np.maximum((direction**2).sum(axis=1), np.finfo(float).tiny)
    offset = points[:, None, :] - start[None, :, :]
    share = np.clip((offset * direction).sum(axis=2) / squared, 0.0, 1.0)
    return np.linalg.norm(offset - share[:, :, None] * direction, axis=2).min(axis=1)
