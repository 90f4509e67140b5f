"""Tables of a finite element space in the reference body, taken once from scikit-fem's reference elements."""

from typing import NamedTuple

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from fem.elements import FULL, is_one_point_brick
from fem.reference import rule, shape_functions
from meshes.kinds import KINDS
from meshes.mesh import Mesh

_REDUCED_DEGREE = 3  # 2 points along each edge of quad8 and hex20


class Tables(NamedTuple):
    """What the kernels need of the space.

    nodes : (m, a) node numbers. gradients : (m, q, a, D) dN_a/dX at the points [1/m]; the axisymmetric body has a third
    component N_a / R, whose sum with the radii is the hoop stretch. weights : (m, q) reference volumes [m^3].
    areas : (m, q) areas in the plane of the mesh, or volumes in three dimensions [m^d]. size_factor : element size over
    the d-th root of its area or volume [-].
    """

    nodes: np.ndarray
    gradients: np.ndarray
    weights: np.ndarray
    areas: np.ndarray
    size_factor: float


class Space(NamedTuple):
    """Tables of the space; reference places (q, d) of the points and the shape functions (q, a) there; mass of the
    corners of elements (m, a) [kg].
    """

    tables: Tables
    places: np.ndarray
    shape: np.ndarray
    corner_mass: np.ndarray


def make_space(mesh: Mesh, geometry: Geometry, integration: str, density: float) -> Space:
    """The space of a mesh: isoparametric elements of its kind with full or reduced integration."""
    kind = KINDS[mesh.kind]
    one_point = is_one_point_brick(mesh.kind, integration)
    places, rule_weights = rule(mesh.kind, None if integration == FULL or one_point else _REDUCED_DEGREE)
    corners = mesh.points[mesh.cells]
    jacobian, areas, weights = _measures(mesh.kind, corners, geometry, places, rule_weights)
    gradients = _gradients(mesh.kind, corners, geometry, places, jacobian)
    if one_point:
        # Flanagan & Belytschko's uniform gradient: the mean over the volume, which passes the patch test in all
        # geometries; the gradient at the centre does not where the volume's weight is not constant.
        volumes = weights.sum(axis=1, keepdims=True)
        gradients = np.einsum("eq,eqaD->eaD", weights / volumes, gradients)[:, None]
        places = np.full((1, kind.dimension), 0.5)
        weights, areas = volumes, areas.sum(axis=1, keepdims=True)
    simplex_factor = (2.0 if kind.dimension == 2 else 6.0) ** (1.0 / kind.dimension)
    tables = Tables(
        mesh.cells,
        np.ascontiguousarray(gradients),
        np.ascontiguousarray(weights),
        np.ascontiguousarray(areas),
        (simplex_factor if kind.simplex else 1.0) / kind.degree,
    )
    return Space(
        tables,
        places,
        shape_functions(mesh.kind, places)[0],
        lumped_mass(mesh.kind, corners, geometry, density),
    )


def lumped_mass(kind: str, corners: np.ndarray, geometry: Geometry, density: float) -> np.ndarray:
    """Mass of the corners of elements (m, a) [kg]: row sums of linear kinds, scaled diagonal of quadratic ones.

    Row sums of quadratic shape functions are negative or zero at vertices; the diagonal of the consistent mass,
    scaled to the element's mass, is positive. Source: Hinton, Rock & Zienkiewicz, Earthq. Eng. Struct. Dyn. 4 (1976)
    245.
    """
    degree = KINDS[kind].degree
    places, rule_weights = rule(kind, 2 * degree + 1)
    shape = shape_functions(kind, places)[0]
    weights = _measures(kind, corners, geometry, places, rule_weights)[2]
    if degree == 1:
        return density * np.einsum("eq,qa->ea", weights, shape)
    diagonal = np.einsum("eq,qa->ea", weights, shape**2)
    total = density * weights.sum(axis=1, keepdims=True)
    return diagonal * (total / diagonal.sum(axis=1, keepdims=True))


def _measures(
    kind: str, corners: np.ndarray, geometry: Geometry, places: np.ndarray, rule_weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Jacobians (m, q, d, d) dX/dxi, plane areas and reference volumes (m, q) at reference places (q, d)."""
    shape, local = shape_functions(kind, places)
    jacobian = corners.transpose(0, 2, 1)[:, None] @ local
    areas = rule_weights * np.linalg.det(jacobian)
    if not isinstance(geometry, Axisymmetric):
        return jacobian, areas, areas
    return jacobian, areas, 2.0 * np.pi * np.einsum("qa,ea->eq", shape, corners[:, :, 0]) * areas


def _gradients(
    kind: str, corners: np.ndarray, geometry: Geometry, places: np.ndarray, jacobian: np.ndarray
) -> np.ndarray:
    """Gradients (m, q, a, D) of the shape functions, and N_a / R behind them in the axisymmetric body."""
    shape, local = shape_functions(kind, places)
    gradients = local @ np.linalg.inv(jacobian)
    if not isinstance(geometry, Axisymmetric):
        return gradients
    hoop = shape / np.einsum("qa,ea->eq", shape, corners[:, :, 0])[:, :, None]
    return np.concatenate([gradients, hoop[..., None]], axis=3)


class NodeElements(NamedTuple):
    """Elements round each node: entries[start[i] : start[i + 1]] are a element + local number."""

    start: np.ndarray
    entries: np.ndarray


def elements_round_nodes(nodes: np.ndarray, count: int) -> NodeElements:
    """For each of `count` nodes the corners of elements that meet there, in order of element."""
    flat = nodes.ravel()
    order = np.argsort(flat, kind="stable")
    start = np.concatenate([[0], np.cumsum(np.bincount(flat, minlength=count))])
    return NodeElements(start.astype(np.int64), order.astype(np.int64))
