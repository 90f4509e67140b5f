"""Seams: facets that lie on each other although their cells share no nodes there."""

import logging

import numpy as np
from scipy.spatial import cKDTree

from core_models.errors import MeshError
from meshes.bodies import bodies_of_nodes
from meshes.facets import find_facets, place
from meshes.mesh import Mesh

TOGETHER = 1e-9
"""Distance below which two facets lie in the same place, as a part of the mesh's size."""

logger = logging.getLogger(__name__)


def check_seams(mesh: Mesh) -> None:
    """Refuse nodes within a body that coincide without being one, MeshError; a warning where two bodies touch so."""
    facets = find_facets(mesh.kind, mesh.points, mesh.cells)
    rim = facets.nodes[facets.rim()]
    middles = mesh.points[rim[:, : facets.corners]].mean(axis=1)
    pairs = cKDTree(middles).query_pairs(TOGETHER * np.ptp(mesh.points, axis=0).max(), output_type="ndarray")
    if len(pairs) == 0:
        return
    body = bodies_of_nodes(mesh.cells, len(mesh.points))
    torn = body[rim[pairs[:, 0], 0]] == body[rim[pairs[:, 1], 0]]
    first = int(torn.argmax())
    where = place(mesh.points[rim[pairs[first, 0], : facets.corners]])
    remedy = "merge nodes that coincide (gmsh: Coherence Mesh;)"
    if torn.any():
        raise MeshError(f"{mesh.source}: two facets lie on each other {where} and share no nodes; {remedy}")
    logger.warning(
        "%s: two bodies touch %s (in all at %d facets) and share no nodes; if they are one, %s",
        mesh.source,
        where,
        len(pairs),
        remedy,
    )
