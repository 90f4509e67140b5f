"""Convected particle domains (CPDI): linear functions at the corners of each particle's deformed domain.

With the half edges a_k = F r_k of a parallelogram or parallelepiped round the particle, its 2^d corners
x_c = x_p + sum s_k a_k (s_k = +-1), and the grid's linear functions N_i,

    N_ip = 2^-d sum_c N_i(x_c),   grad N_ip = 2^-d sum_c N_i(x_c) A^-T s_c,   A = (a_1 a_2 a_3)

A linear field comes out as it is, with its gradient. In a body of revolution the plane section is treated so.
"""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import CHUNK, inside_kernel, kernel
from core_models.dispatch import generic
from core_models.errors import RunFailure, SceneError
from core_models.geometry import AXES, Axisymmetric, Geometry, PlaneStrain, Spatial
from core_models.threads import Threads
from mpm.geometries import dimension_of
from mpm.interpolation import layers, locate_particle, reach
from mpm.lanes import lane, lanes
from mpm.taking import total

WIDEST = 3.0  # cells along an axis that a domain may cover: its corners then reach no more than five nodes


class ConvectedDomain(NamedTuple):
    """half_edges : (n, d, d) vectors r_k (by rows) in the reference body [m]. gradient : (n, 3, 3) F.

    Source: Sadeghirad, Brannon & Burghardt, Int. J. Numer. Meth. Eng. 86 (2011) 1435.
    """

    half_edges: np.ndarray
    gradient: np.ndarray


def half_edges(corners: np.ndarray, areas: np.ndarray) -> np.ndarray:
    """Half edges (n, d, d) [m] of parallelepipeds like the domains with these corners (n, 2^d, d), VTK order, and as
    large: areas or volumes (n,) [m^d].
    """
    d = corners.shape[2]
    signs = np.array([[-1, 1, 1, -1] * 2, [-1, -1, 1, 1] * 2, [-1] * 4 + [1] * 4])[:d, : 2**d]
    edges = np.einsum("kc,nci->nki", signs, corners) / 2**d
    return edges * ((areas / (2**d * np.linalg.det(edges))) ** (1.0 / d))[:, None, None]


def extents(shape: ConvectedDomain, which: np.ndarray | slice = slice(None)) -> np.ndarray:
    """Widths (n, d) [m] of the boxes round the particles' domains now."""
    d = shape.half_edges.shape[1]
    edges = np.einsum("nij,nkj->nki", shape.gradient[which, :d, :d], shape.half_edges[which])
    return 2.0 * np.abs(edges).sum(axis=1)


def corner_gradients(shape: ConvectedDomain) -> tuple[np.ndarray, np.ndarray]:
    """Offsets x_c - x_p (n, 2^d, d) [m] of the corners now, and 2^-d A^-T s_c (n, 2^d, d) [1/m]."""
    d = shape.half_edges.shape[1]
    edges = np.einsum("nij,nkj->nki", shape.gradient[:, :d, :d], shape.half_edges)
    signs = np.stack(np.meshgrid(*[[-1.0, 1.0]] * d, indexing="ij"), axis=-1).reshape(-1, d)
    return signs @ edges, np.einsum("nik,ck->nci", np.linalg.inv(edges), signs) / 2**d


def check_seeding(shape: ConvectedDomain, cell_size: float) -> None:
    """Refuse particles that are too wide from the start; SceneError with the numbers."""
    widest = float(extents(shape).max())
    if widest > WIDEST * cell_size:
        raise SceneError(
            f"interpolation 'cpdi' needs domains that cover at most {WIDEST:g} cells along each axis: the widest has "
            f"{widest:.4g} m, the cells have {cell_size:.4g} m: give larger cells or a finer mesh"
        )


def check_extent(shape: ConvectedDomain, particle: int, cell_size: float, where: str) -> None:
    """Raise RunFailure if the domain of a particle covers too many cells; where : says step, time and particle."""
    widths = extents(shape, np.array([particle]))[0] / cell_size
    axis = int(widths.argmax())
    if not widths[axis] <= WIDEST:
        raise RunFailure(
            f"{where}: the domain of the particle has been stretched over {widths[axis]:.3g} cells along "
            f"{AXES[axis]}, {WIDEST:g} are possible: give a finer mesh or larger cells, or try "
            "configuration='total', in which domains do not stretch"
        )


@inside_kernel
def edge_along(shape, geometry, p, k, axis):
    """Component of the half edge a_k of particle p along an axis [m]."""
    a = 0.0
    for j in range(dimension_of(geometry)):
        a += shape.gradient[p, axis, j] * shape.half_edges[p, k, j]
    return a


@generic
def half_edge(geometry, shape, p, k):
    """Half edge a_k of particle p as lanes [m]; in the plane the third is a unit vector."""


@half_edge.register(Axisymmetric)
@half_edge.register(PlaneStrain)
def _(geometry, shape, p, k):
    if k == 2:
        return lanes(0.0, 0.0, 1.0, 0.0)
    return lanes(edge_along(shape, geometry, p, k, 0), edge_along(shape, geometry, p, k, 1), 0.0, 0.0)


@half_edge.register(Spatial)
def _(geometry, shape, p, k):
    x, y = edge_along(shape, geometry, p, k, 0), edge_along(shape, geometry, p, k, 1)
    return lanes(x, y, edge_along(shape, geometry, p, k, 2), 0.0)


@inside_kernel
def dot(a, b):
    """Scalar product."""
    return total(a * b)


@inside_kernel
def cross(a, b):
    """Vector product."""
    return lanes(
        lane(a, 1) * lane(b, 2) - lane(a, 2) * lane(b, 1),
        lane(a, 2) * lane(b, 0) - lane(a, 0) * lane(b, 2),
        lane(a, 0) * lane(b, 1) - lane(a, 1) * lane(b, 0),
        0.0,
    )


@reach.register(ConvectedDomain)
def _(shape):
    return 5


@layers.register(ConvectedDomain)
def _(shape):
    return 2


@locate_particle.register(ConvectedDomain)
def _(shape, geometry, p, axis, x, over_h):
    half = 0.0
    for k in range(dimension_of(geometry)):
        half += abs(edge_along(shape, geometry, p, k, axis)) * over_h
    first = math.floor(x - half - 0.5) + 0.0
    # No grid has a node of that number, so that the particle is told to be nowhere.
    return first if 2.0 * half <= WIDEST else -math.inf, x - 0.5 - first


@inside_kernel
def sign(corner, k):
    """Sign of the half edge a_k at a corner."""
    return 1.0 if (corner >> k) & 1 else -1.0


@kernel
def measure_thickness(first, last, geometry, shape, thickness):
    """Half the least distance between opposite faces of a domain [m], the smallest of each chunk of particles."""
    for chunk in range(first, last):
        steepest = 0.0
        for p in range(chunk * CHUNK, min((chunk + 1) * CHUNK, shape.half_edges.shape[0])):
            a, b = half_edge(geometry, shape, p, 0), half_edge(geometry, shape, p, 1)
            c = half_edge(geometry, shape, p, 2)
            d_a, d_b, d_c = cross(b, c), cross(c, a), cross(a, b)
            square = max(dot(d_a, d_a), dot(d_b, d_b))
            if dimension_of(geometry) == 3:
                square = max(square, dot(d_c, d_c))
            volume = dot(a, d_a)
            steepest = max(steepest, square / (volume * volume))
        thickness[chunk] = 1.0 / math.sqrt(steepest)


def step_factor(shape: ConvectedDomain, geometry: Geometry, cell_size: float, threads: Threads) -> float:
    """What thin domains leave of the stable step.

    A node that only the corners of one domain of half thickness l reach feels a stiffness over mass of up to
    c^2 / (h l), against 4 c^2 / h^2 of the grid as such; with some margin the factor is min(1, sqrt(8 l / h)).
    """
    thickness = np.empty(-(-len(shape.half_edges) // CHUNK))
    threads.run(measure_thickness, len(thickness), geometry, shape, thickness)
    return min(1.0, math.sqrt(8.0 * float(thickness.min()) / cell_size))
