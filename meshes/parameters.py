"""Checks of the numbers that geometries are made from."""

import math
from collections.abc import Sequence
from numbers import Real

import numpy as np

from core_models.errors import MeshError
from meshes.kinds import find_kind

STEEPEST_GRADING = 100.0
"""Ratio of axial sizes up to which gmsh places nodes to some 1e-5 of an element."""

MOST_ELEMENTS = 50_000_000


def check_length(body: str, name: str, value: float) -> None:
    """Refuse a length [m] that is not finite and above 0; MeshError."""
    if not (math.isfinite(value) and value > 0.0):
        raise MeshError(f"{body}: {name} is {value:g}; give a positive number")


def check_number(body: str, name: str, value: float) -> None:
    """Refuse a number that is not finite; MeshError."""
    if not math.isfinite(value):
        raise MeshError(f"{body}: {name} is {value:g}; give a finite number")


def check_count(body: str, name: str, value: int, least: int = 1) -> None:
    """Refuse a number of elements that is not whole and at least `least`; MeshError."""
    if not isinstance(value, Real) or not math.isfinite(value) or value != int(value) or value < least:
        raise MeshError(f"{body}: {name} is {value}; give a whole number of at least {least}")


def check_counts(body: str, counts: Sequence[int], kind: str) -> np.ndarray:
    """Numbers of parts (d,), one per coordinate of a kind of element; MeshError unless whole and at least 1."""
    parts, dimension = np.asarray(counts), find_kind(kind).dimension
    if parts.shape != (dimension,):
        raise MeshError(f"{body}: counts is {parts.tolist()}; give {dimension} numbers for {kind} elements")
    if parts.dtype.kind not in "iu" or parts.min() < 1:
        raise MeshError(f"{body}: counts is {parts.tolist()}; give whole numbers of at least 1")
    check_total(body, math.prod(parts.tolist()))
    return parts


def check_total(body: str, elements: float) -> None:
    """Refuse more elements than fit in memory, before they are made; MeshError."""
    if elements > MOST_ELEMENTS:
        raise MeshError(f"{body}: makes some {elements:.2g} elements; give at most {MOST_ELEMENTS:.2g}")


def check_grading(body: str, grading: float) -> None:
    """Refuse a ratio of the heights of the first and the last layer that is too steep to mesh; MeshError."""
    if not 1.0 / STEEPEST_GRADING <= grading <= STEEPEST_GRADING:
        raise MeshError(f"{body}: grading is {grading:g}; give a number from 0.01 to 100 (1 is even)")


def check_cylinder(
    body: str,
    radius: float,
    length: float,
    across: int,
    along: int | None,
    grading: float,
    foot_height: float,
    dimension: int,
) -> int:
    """Refuse parameters of a standing cylinder that are outside their range; MeshError.

    Returns the elements along it: `along`, or if that is None as many as are as high as `across` are wide.
    """
    check_length(body, "radius", radius)
    check_length(body, "length", length)
    check_grading(body, grading)
    check_number(body, "foot_height", foot_height)
    check_count(body, "elements_across", across)
    if along is None:
        along = max(1, round(across * length / radius))
    check_count(body, "elements_along", along)
    check_total(body, float(across) ** (dimension - 1) * along)
    return along


def check_point(body: str, name: str, point: Sequence[float], dimension: int) -> np.ndarray:
    """The coordinates (d,) of a point [m]; MeshError unless they are `dimension` finite numbers."""
    value = np.asarray(point, dtype=float)
    if value.shape != (dimension,) or not np.isfinite(value).all():
        raise MeshError(f"{body}: {name} is {value.tolist()}; give {dimension} finite numbers")
    return value
