"""Bodies of every kind of element, and the elements there are."""

import numpy as np
import pytest

from fem import ExplicitSolver
from fem.cures.choice import cures_of
from meshes.block import block
from meshes.elevate import elevate
from meshes.kinds import KINDS

REDUCIBLE = ("quad4", "quad8", "hex8", "hex20")
GEOMETRIES = {2: ("plane-strain", "axisymmetric"), 3: ("spatial",)}
INNER_RADIUS = 0.7  # m, of axisymmetric blocks, unless they reach the axis

ELEMENTS = [
    (geometry, kind, integration, cure)
    for kind in KINDS
    for geometry in GEOMETRIES[KINDS[kind].dimension]
    for integration in (("full", "reduced") if kind in REDUCIBLE else ("full",))
    for cure in cures_of(kind, integration)
]
"""Every element: geometry, kind, integration, cure."""


@pytest.fixture
def straight():
    """Make a block of edges 1 m in elements with straight edges, nodes inside moved at random by up to a part."""

    def make(kind, counts=None, distortion=0.25, lower=0.0, seed=0):
        dimension = KINDS[kind].dimension
        counts = counts or ([3, 3] if dimension == 2 else [2, 2, 2])
        low = np.array([lower] + [0.0] * (dimension - 1))
        return elevate(block(low, low + 1.0, counts, KINDS[kind].linear, distortion, seed), kind)

    return make


@pytest.fixture
def element(elastic, straight):
    """Make an elastic block of one of the ELEMENTS, displaced by a function of position, with further options."""

    def make(which, displacement=None, mesh=None, **options):
        geometry, kind, integration, cure = which
        if mesh is None:
            mesh = straight(kind, lower=INNER_RADIUS if geometry == "axisymmetric" else 0.0)
        return ExplicitSolver(
            mesh,
            options.pop("material", elastic),
            geometry=geometry,
            integration=integration,
            cure=cure,
            displacement=displacement,
            **options,
        )

    return make


@pytest.fixture(params=ELEMENTS, ids=lambda which: "-".join(which))
def which(request):
    """Every element in turn."""
    return request.param


@pytest.fixture
def inner_nodes():
    """Give the nodes of a mesh that lie on no boundary."""

    def find(mesh):
        rim = np.concatenate([facets.ravel() for facets in mesh.boundaries.values()])
        return np.setdiff1d(np.arange(len(mesh.points)), rim)

    return find
