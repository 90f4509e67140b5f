"""Axisymmetric quads with four points: tables taken once from scikit-fem."""

from typing import NamedTuple

import numpy as np

from meshes.mesh import Mesh

POINTS = 4  # quadrature points of an element, 2 x 2 Gauss


class QuadTables(NamedTuple):
    """What the kernels need of the finite element space, in the reference configuration.

    nodes : (m, 4) node numbers. gradients : (m, 4, 4, 2) dN_I/dX at point q, index [element, q, I]. shape : (4, 4)
    N_I at point q. radius : (m, 4) reference radius of the points [m]. weights : (m, 4) reference volumes, 2 pi R
    dR dZ [m^3].
    """

    nodes: np.ndarray
    gradients: np.ndarray
    shape: np.ndarray
    radius: np.ndarray
    weights: np.ndarray


def quad_tables(mesh: Mesh) -> QuadTables:
    """Tables of bilinear quads with 2 x 2 points from a `meshes.mesh.Mesh`."""
    from skfem import Basis, ElementQuad1

    basis = Basis(mesh.to_skfem(), ElementQuad1(), intorder=3)
    shape = np.array([np.asarray(phi[0])[0] for phi in basis.basis]).T
    gradients = np.array([np.asarray(phi[0].grad) for phi in basis.basis])
    radius = np.ascontiguousarray(np.asarray(basis.global_coordinates())[0])
    return QuadTables(
        nodes=np.ascontiguousarray(basis.element_dofs.T.astype(np.int64)),
        gradients=np.ascontiguousarray(gradients.transpose(2, 3, 0, 1)),
        shape=np.ascontiguousarray(shape),
        radius=radius,
        weights=np.ascontiguousarray(2.0 * np.pi * radius * basis.dx),
    )


class NodeElements(NamedTuple):
    """Elements round each node: entries[start[i] : start[i + 1]] are 4 element + local number."""

    start: np.ndarray
    entries: np.ndarray


def elements_round_nodes(nodes: np.ndarray, count: int) -> NodeElements:
    """For each of `count` nodes the corners of elements that meet there, in order of element."""
    flat = nodes.ravel()
    order = np.argsort(flat, kind="stable")
    start = np.concatenate([[0], np.cumsum(np.bincount(flat, minlength=count))])
    return NodeElements(start.astype(np.int64), order.astype(np.int64))


def lumped_mass(tables: QuadTables, density: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Row-sum mass of the nodes (count,) and of the corners of elements (m, 4) [kg]."""
    corner = density * np.einsum("eq,qI->eI", tables.weights, tables.shape)
    return np.bincount(tables.nodes.ravel(), weights=corner.ravel(), minlength=count), corner
