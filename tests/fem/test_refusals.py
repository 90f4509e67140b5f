"""What cannot be is refused with what to do."""

import numpy as np
import pytest

from core_models.errors import MeshError, SceneError, UnsupportedError
from core_models.loads import Fixed, Prescribed, Traction
from fem import ExplicitSolver
from meshes.block import block
from meshes.join import join

PLANE = {"geometry": "plane-strain"}


@pytest.fixture
def refused(elastic):
    """Assert that a solver of a block is refused with a message."""

    def check(message, kind="quad4", error=SceneError, lower=0.0, **options):
        d = 3 if kind.startswith(("hex", "tet")) else 2
        mesh = block([lower] + [0.0] * (d - 1), [1.0] * d, [2] * d, kind)
        with pytest.raises(error, match=message) as failure:
            ExplicitSolver(mesh, elastic, **options)
        assert "\n" not in str(failure.value)

    return check


def test_geometries_that_do_not_fit_the_mesh_are_refused(refused):
    """Unknown, of another dimension, or a body of revolution across the axis."""
    refused("did you mean 'plane-strain'", geometry="plane-strian")
    refused("needs a mesh of dimension 3", geometry="spatial")
    refused("needs a mesh of dimension 2", kind="hex8", **PLANE)
    refused("r >= 0", lower=-0.5, error=MeshError)


def test_elements_that_do_not_exist_are_refused(refused):
    """Integrations and cures that are unknown, or void for the element."""
    refused("did you mean 'reduced'", integration="reduce", **PLANE)
    refused("tri3 has no reduced integration", kind="tri3", integration="reduced", **PLANE)
    refused("did you mean 'mean-dilatation'", cure="mean-dilation", **PLANE)
    refused("one point.*nodal-average or none", kind="tri3", cure="mean-dilatation", **PLANE)
    refused("too few points to lock; use none", integration="reduced", cure="mean-dilatation", **PLANE)
    refused("other cures; use mean-dilatation or none", cure="nodal-average", **PLANE)


def test_numbers_out_of_range_are_refused(refused):
    """Safety, hourglass coefficient, temperature, velocity and displacement."""
    refused("safety", safety=1.5, **PLANE)
    refused("hourglass", hourglass=0.0, **PLANE)
    refused("temperature", temperature=-3.0, **PLANE)
    refused("velocity has the shape", velocity=[1.0, 2.0, 3.0], **PLANE)
    refused("velocity is not finite", velocity=np.inf, **PLANE)
    refused("displacement has the shape", displacement=lambda x: x[:, 0], **PLANE)


def test_a_displacement_that_inverts_elements_is_refused(refused):
    """A body that is turned inside out has no stress to start from."""
    refused("inverted.*smaller", displacement=lambda x: x * [-2.0, 0.0], **PLANE)


def test_loads_that_contradict_are_refused(refused):
    """A node that is to move in two ways, an unknown boundary, a traction on the axis."""
    refused("contradictory supports", loads=(Fixed("left"), Prescribed("bottom", 0, 1.0)), **PLANE)
    refused("did you mean 'left'", loads=(Fixed("lift"),), **PLANE)
    refused("axis r = 0", loads=(Traction("left", [1.0, 0.0]),))


def test_reading_what_is_not_there_is_refused(elastic):
    """Unknown boundaries, reactions without supports, an outline in 3-D."""
    solver = ExplicitSolver(block([0.0] * 3, [1.0] * 3, [1, 1, 1], "hex8"), elastic, loads=(Fixed("left"),))
    with pytest.raises(SceneError, match="did you mean 'left'"):
        solver.boundary_positions("letf")
    with pytest.raises(SceneError, match="no support holds 'right'"):
        solver.boundary_force("right")
    with pytest.raises(UnsupportedError, match="boundary_positions"):
        solver.outline()


def test_several_bodies_are_refused(elastic):
    """Without contact they would pass through each other."""
    two = join([block([0.0, 0.0], [1.0, 1.0], [1, 1]), block([2.0, 0.0], [3.0, 1.0], [1, 1])])
    with pytest.raises(
        UnsupportedError, match="2 bodies, between which fem.ExplicitSolver has no contact.*use mpm"
    ):
        ExplicitSolver(two, elastic, **PLANE)
