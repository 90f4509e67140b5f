"""From linear to quadratic elements."""

import numpy as np
import pytest

from core_models.errors import MeshError
from meshes.annulus import annulus
from meshes.block import block
from meshes.elevate import elevate
from meshes.kinds import KINDS
from meshes.measure import measures
from meshes.taylor_quarter import taylor_quarter

QUADRATIC = [name for name, kind in KINDS.items() if kind.degree == 2]


def onto_unit_cylinder(points):
    """The nearest points at distance 1 from the axis x = y = 0."""
    return np.column_stack([points[:, :2] / np.linalg.norm(points[:, :2], axis=1)[:, None], points[:, 2:]])


@pytest.mark.parametrize("kind", QUADRATIC)
def test_elevated_block_is_the_block_of_that_kind(kind):
    """Corners keep their numbers, nodes are shared by neighbours, and names stay with facets."""
    size = ([0.0] * KINDS[kind].dimension, [1.0] * KINDS[kind].dimension, [2] * KINDS[kind].dimension)
    linear, wanted = block(*size, KINDS[kind].linear, distortion=0.1), block(*size, kind)
    mesh = elevate(linear, kind)
    assert np.array_equal(mesh.cells, wanted.cells) and len(mesh.points) == len(wanted.points)
    assert np.array_equal(mesh.points[: len(linear.points)], linear.points)
    assert all(np.array_equal(mesh.boundaries[name], wanted.boundaries[name]) for name in wanted.boundaries)
    assert measures(mesh).sum() == pytest.approx(1.0, rel=1e-13)


@pytest.mark.parametrize("kind", ["quad8", "quad9", "tri6"])
def test_nodes_of_curved_boundaries_are_put_on_them(kind):
    """Middle nodes of a named boundary go where its function says, within the element they follow."""
    straight = annulus(1.0, 2.0, [2, 12], KINDS[kind].linear)
    mesh = elevate(straight, kind, {"inner": onto_unit_cylinder})
    radius = np.linalg.norm(mesh.points[mesh.boundaries["inner"]], axis=-1)
    assert np.ptp(radius) < 1e-15
    assert measures(elevate(straight, kind)).sum() - measures(mesh).sum() == pytest.approx(
        np.pi - 6.0 * np.sin(np.pi / 6.0), rel=1e-2
    )


@pytest.mark.parametrize("kind", ["hex20", "hex27", "tet10"])
def test_curved_facets_of_solids_lie_on_the_cylinder(kind):
    """All nodes of the side, those in the middle of facets too, lie on the cylinder."""
    straight = taylor_quarter(1.0, 1.0, 3, kind=KINDS[kind].linear)
    mesh = elevate(straight, kind, {"side": onto_unit_cylinder})
    side = mesh.points[np.unique(mesh.boundaries["side"])]
    assert np.allclose(np.hypot(side[:, 0], side[:, 1]), 1.0, rtol=1e-15)


def test_a_kind_of_another_shape_is_refused():
    """Quads do not become triangles, and quadratic elements no other quadratic ones."""
    mesh = block([0, 0], [1, 1], [2, 2])
    assert elevate(mesh, "quad4") is mesh
    with pytest.raises(MeshError, match="quad4 elements cannot become tri6; give a mesh of tri3"):
        elevate(mesh, "tri6")
    with pytest.raises(MeshError, match="quad8 elements cannot become quad9"):
        elevate(elevate(mesh, "quad8"), "quad9")
    with pytest.raises(MeshError, match="'botom' is missing; did you mean 'bottom'"):
        elevate(mesh, "quad8", {"botom": lambda points: points})
