"""Bodies of the verification problems, from the size of their cells."""

from collections.abc import Callable
from math import pi

from meshes.annulus import annulus
from meshes.block import block
from meshes.mesh import Mesh


def strip(length: float, height: float, size: float, kind: str, along: int = 0) -> Mesh:
    """A plane strip of cells of about a given size [m], its long side along the axis `along`, one corner at 0."""
    counts = [max(round(length / size), 1), max(round(height / size), 1)]
    upper = [length, height]
    if along == 1:
        counts.reverse()
        upper.reverse()
    return block([0.0, 0.0], upper, counts, kind)


def strip_body(length: float, height: float, along: int = 0) -> Callable[[float, str], Mesh]:
    """Makes the strip from cell size and kind."""
    return lambda size, kind: strip(length, height, size, kind, along)


def ring(inner: float, outer: float, size: float, kind: str) -> Mesh:
    """A whole ring between two radii [m], of cells of about a given size [m] at the mean radius."""
    counts = [max(round((outer - inner) / size), 1), round(pi * (inner + outer) / size)]
    return annulus(inner, outer, counts, kind)
