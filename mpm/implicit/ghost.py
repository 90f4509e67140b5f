"""Ghost penalty: what keeps the stiffness of cells of which the body fills next to nothing from vanishing.

Across a face F between a cell on the rim of the body and its neighbour, the p-th derivative along the normal is all
that splines of degree p can jump in. With h the mean size of both cells along the normal and G the shear modulus,

    E = 1/2 sum_F gamma G h^(2 p - 1) int_F |[d^p u / dn^p]|^2 dA

is 0 for every displacement that is one polynomial of degree p across the face, rigid motions of any size and uniform
strain among them, and of the order of the splines' own error for smooth ones.
Sources: Burman, C. R. Math. 348 (2010) 1217; in the material point method Coombs, Int. J. Numer. Meth. Eng. 124 (2023)
4841.
"""

import math

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from mpm.implicit.grid import SplineGrid


def ghost_faces(
    grid: SplineGrid, geometry: Geometry, factor: float
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Functions (f, b) of the faces normal to each axis, and stiffness (f, b, b) of one component [N/m].

    factor : gamma G [Pa].
    """
    rim = grid.rim
    number = {tuple(index): k for k, index in enumerate(grid.indices.tolist())}
    nodes, blocks = [], []
    for axis, splines in enumerate(grid.axes):
        lower, upper = grid.neighbours(axis)
        cut = rim[lower] | rim[upper]
        cells = grid.cells[lower[cut]]
        if not len(cells):
            continue
        sizes = np.diff(splines.lines)
        along = cells[:, axis]
        h = 0.5 * (sizes[along] + sizes[along + 1])
        jump = splines.jumps()[along] * (h ** (grid.degree - 0.5))[:, None]
        factors = [
            np.einsum("fa,fb->fab", jump, jump)
            if other == axis
            else _masses(grid, geometry, other, cells[:, other])
            for other in range(len(grid.axes))
        ]
        block = factors[0]
        for each in factors[1:]:
            size = block.shape[1] * each.shape[1]
            block = np.einsum("fab,fcd->facbd", block, each).reshape(-1, size, size)
        if isinstance(geometry, Axisymmetric) and axis == 0:
            block *= (2.0 * math.pi * splines.lines[along + 1])[:, None, None]
        counts = [grid.degree + (2 if other == axis else 1) for other in range(len(grid.axes))]
        steps = np.indices(counts).reshape(len(counts), -1).T
        around = cells[:, None] + steps
        nodes.append(np.array([[number[tuple(place)] for place in face] for face in around.tolist()]))
        blocks.append(factor * block)
    return nodes, blocks


def _masses(grid: SplineGrid, geometry: Geometry, axis: int, cells: np.ndarray) -> np.ndarray:
    """int N_a N_b (f, p + 1, p + 1) along an axis over each of some cells (f,) [m]; of a body of revolution 2 pi r."""
    splines = grid.axes[axis]
    places, shares = np.polynomial.legendre.leggauss(grid.degree + 2)
    low, size = splines.lines[cells], np.diff(splines.lines)[cells]
    total = np.zeros((len(cells), grid.degree + 1, grid.degree + 1))
    for place, share in zip(places, shares, strict=True):
        x = low + 0.5 * (1.0 + place) * size
        weight = 0.5 * share * size
        if isinstance(geometry, Axisymmetric) and axis == 0:
            weight = weight * 2.0 * math.pi * x
        values = splines.values(x, cells)
        total += np.einsum("f,fa,fb->fab", weight, values, values)
    return total
