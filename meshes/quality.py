"""Quality figures of a mesh: how far its elements are from even squares, and how large they are."""

from typing import NamedTuple

from meshes.geometry import areas, edge_lengths, scaled_jacobians, volumes_of_revolution
from meshes.mesh import Mesh


class Quality(NamedTuple):
    """Figures of a whole mesh; the scaled Jacobian is the sine of a corner's angle, 1 in a rectangle."""

    elements: int
    nodes: int
    min_scaled_jacobian: float
    max_scaled_jacobian: float
    min_aspect_ratio: float
    max_aspect_ratio: float
    min_edge: float
    max_edge: float
    min_area: float
    max_area: float
    area: float
    volume: float


def quality(mesh: Mesh) -> Quality:
    """Quality figures of a mesh.

    The scaled Jacobian of an element is its worst corner's; its aspect ratio is its longest edge by its
    shortest, >= 1. Edges in m, areas in the (r, z) plane in m^2, volume of the full turn in m^3.
    """
    corners = mesh.corners()
    jacobians = scaled_jacobians(corners).min(axis=1)
    edges = edge_lengths(corners)
    aspect_ratios = edges.max(axis=1) / edges.min(axis=1)
    element_areas = areas(corners)
    return Quality(
        elements=len(mesh.cells),
        nodes=len(mesh.points),
        min_scaled_jacobian=float(jacobians.min()),
        max_scaled_jacobian=float(jacobians.max()),
        min_aspect_ratio=float(aspect_ratios.min()),
        max_aspect_ratio=float(aspect_ratios.max()),
        min_edge=float(edges.min()),
        max_edge=float(edges.max()),
        min_area=float(element_areas.min()),
        max_area=float(element_areas.max()),
        area=float(element_areas.sum()),
        volume=float(volumes_of_revolution(corners).sum()),
    )
