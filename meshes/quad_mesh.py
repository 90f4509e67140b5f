"""The mesh that both solvers are built from: quads in the (r, z) plane with four named boundaries."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from core_models.errors import MeshError
from meshes.boundary import order_boundaries
from meshes.geometry import scaled_jacobians

if TYPE_CHECKING:
    import skfem

FLAT_ANGLE = 1e-9
"""Scaled Jacobian at or below which a quad counts as inverted or collapsed."""

ON_AXIS = 1e-9
"""Distance from r = 0, as a part of the largest radius, within which a node lies on the axis."""


@dataclass(frozen=True, eq=False)
class QuadMesh:
    """An axisymmetric body cut into quads; checked, and its boundaries put in order, when it is made.

    Parameters: points (n, 2), r and z of the nodes [m], r >= 0; quads (m, 4), node numbers counter-clockwise;
    boundaries: node pairs (k, 2) of 'foot', 'side', 'rear' and 'axis', which become ordered round the body
    (foot from axis to rim, side from foot to rear, rear from rim to axis, axis from rear to foot);
    source: what error messages call the mesh. Nodes of the axis get r = 0 exactly.
    Raises MeshError: points that are not finite or have r < 0, quads that are inverted, clockwise or
    collapsed, nodes that no quad uses, boundaries that are missing, misplaced or incomplete.
    """

    points: np.ndarray
    quads: np.ndarray
    boundaries: dict[str, np.ndarray]
    source: str = "mesh"

    def __post_init__(self) -> None:
        """Check everything and put it in its final form."""
        points = np.array(self.points, dtype=np.float64)
        quads = np.array(self.quads, dtype=np.int64)
        try:
            _check_points(points)
            _check_axes(points, self.boundaries.get("axis"))
            _check_quads(points, quads)
            boundaries = order_boundaries(points, quads, self.boundaries)
            _put_axis_at_zero(points, boundaries["axis"])
        except MeshError as error:
            raise MeshError(f"{self.source}: {error}") from None
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "quads", quads)
        object.__setattr__(self, "boundaries", boundaries)

    def corners(self) -> np.ndarray:
        """Corner coordinates (m, 4, 2) [m] of the quads."""
        return self.points[self.quads]

    def to_skfem(self) -> skfem.MeshQuad:
        """The same mesh for scikit-fem: same node and element numbers, boundaries by the same names."""
        import skfem

        mesh = skfem.MeshQuad(np.ascontiguousarray(self.points.T), np.ascontiguousarray(self.quads.T))
        numbers = _edge_keys(mesh.facets.T)
        by_key = numbers.argsort()
        facets = {
            name: by_key[np.searchsorted(numbers, _edge_keys(pairs), sorter=by_key)]
            for name, pairs in self.boundaries.items()
        }
        return mesh.with_boundaries(facets)


def _edge_keys(pairs: np.ndarray) -> np.ndarray:
    """One number per node pair (k, 2), the same in both directions."""
    low, high = np.sort(pairs.astype(np.int64), axis=1).T
    return low << 32 | high


def _check_points(points: np.ndarray) -> None:
    """Raise MeshError unless the points are finite pairs (r, z) with r >= 0."""
    if points.ndim != 2 or points.shape[1] != 2:
        raise MeshError(f"points have the shape {points.shape}, not (n, 2); give r and z of each node")
    finite = np.isfinite(points).all(axis=1)
    if not finite.all():
        node = int(finite.argmin())
        raise MeshError(f"node {node} has the coordinates {points[node].tolist()}; give finite numbers")
    node = int(points[:, 0].argmin()) if len(points) else 0
    if len(points) and points[node, 0] < -ON_AXIS * points[:, 0].max():
        raise MeshError(
            f"node {node} has r = {points[node, 0]:g} m; move the body to r >= 0 (r is x, z is y)"
        )


def _check_axes(points: np.ndarray, axis: np.ndarray | None) -> None:
    """Raise MeshError when the axis lies where z = 0: before anything else that swapped axes get wrong."""
    if axis is None or len(axis) == 0 or np.max(axis) >= len(points) or np.min(axis) < 0:
        return
    r, z = np.abs(points[np.asarray(axis).ravel()]).T
    near = ON_AXIS * np.abs(points).max()
    if z.max() <= near < r.max():
        raise MeshError("'axis' lies on z = 0, not on r = 0: swap the coordinates (r is x, z is y)")


def _check_quads(points: np.ndarray, quads: np.ndarray) -> None:
    """Raise MeshError unless the quads use every node, and each is counter-clockwise and not collapsed."""
    if quads.ndim != 2 or quads.shape[1] != 4 or len(quads) == 0:
        raise MeshError(
            f"quads have the shape {quads.shape}, not (m, 4) with m > 0; give four nodes per element"
        )
    if quads.min() < 0 or quads.max() >= len(points):
        element = int(((quads < 0) | (quads >= len(points))).any(axis=1).argmax())
        raise MeshError(f"element {element} uses a node that is not there (nodes are 0 to {len(points) - 1})")
    uses = np.bincount(quads.ravel(), minlength=len(points))
    if uses.min() == 0:
        raise MeshError(f"node {int(uses.argmin())} belongs to no element; remove it")
    jacobians = scaled_jacobians(points[quads])
    bad = (jacobians <= FLAT_ANGLE).any(axis=1)
    if bad.any():
        raise MeshError(_describe_inverted(points, quads, jacobians, int(bad.argmax()), int(bad.sum())))


def _describe_inverted(
    points: np.ndarray, quads: np.ndarray, jacobians: np.ndarray, element: int, count: int
) -> str:
    """Say which element is inverted, where it is, how many there are and what to do."""
    r, z = points[quads[element]].mean(axis=0)
    total = "the only one" if count == 1 else f"the first of {count}"
    clockwise = bool((jacobians[element] < -FLAT_ANGLE).all())
    state = "numbered clockwise" if clockwise else "inverted or collapsed"
    remedy = (
        "reverse its nodes (gmsh: Reverse Surface, or Mesh.reverse)"
        if clockwise
        else "move or remesh its nodes"
    )
    return (
        f"element {element} (counted from 0; {total}) near r = {r:.4g} m, z = {z:.4g} m is {state}; {remedy}"
    )


def _put_axis_at_zero(points: np.ndarray, axis: np.ndarray) -> None:
    """Set r = 0 on the axis; raise MeshError unless its nodes are the nodes near r = 0, and no others."""
    on_axis = np.zeros(len(points), dtype=bool)
    on_axis[axis.ravel()] = True
    near = np.abs(points[:, 0]) <= ON_AXIS * points[:, 0].max()
    wrong = on_axis != near
    if wrong.any():
        node = int(wrong.argmax())
        claim = "belongs to" if on_axis[node] else "does not belong to"
        raise MeshError(
            f"the node at r = {points[node, 0]:.4g} m, z = {points[node, 1]:.4g} m {claim} 'axis'; "
            "the axis is exactly the edges on r = 0 (r is x, z is y)"
        )
    points[on_axis, 0] = 0.0
