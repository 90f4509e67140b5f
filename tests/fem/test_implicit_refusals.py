"""What implicit finite elements refuse, and how runs end that cannot go on."""

from dataclasses import replace

import numpy as np
import pytest

from core_models.errors import NoEquilibrium, OutputError, SceneError, SingularStiffness, UnsupportedError
from core_models.loads import Damping, Fixed, Prescribed, Pressure, Symmetry, Traction
from fem import ImplicitSolver
from meshes.block import block
from meshes.join import join
from meshes.necking_bar import necking_bar
from tests.fem.implicit_bodies import LENGTH, RADIUS, bar, steel


def test_load_that_cannot_be_carried_ends_with_the_last_converged_state():
    """A traction beyond the plastic limit is cut down to the smallest increment, then refused; the state stays."""
    mesh = necking_bar(RADIUS, LENGTH, 1, 2, 1.0)
    loads = (Symmetry("neck"), Traction("end", lambda X, t: np.tile([0.0, 1e9 * t], (len(X), 1))))
    solver = ImplicitSolver(mesh, steel(), loads=loads, increment=0.2, smallest=0.01)
    with pytest.raises(NoEquilibrium, match=r"cut below 1.000e-02 s.*last converged state is kept") as caught:
        while solver.time < 1.0:
            solver.advance(1.0)
    assert caught.value.exit_status == 3 and "\n" not in str(caught.value)
    assert 0.55 < solver.time < 0.615 and solver.log.cuts
    assert solver.points.old.stress[:, 1].max() == pytest.approx(1e9 * solver.time, rel=0.3)


@pytest.mark.parametrize(
    ("mesh", "geometry", "loads", "told"),
    [
        (block([0, 0], [1, 1], [2, 2]), "plane-strain", (), "translation along x, translation along y, rotation"),
        (block([0, 0], [1, 1], [2, 2]), "plane-strain", (Symmetry("bottom"),), "translation along x:"),
        (block([0, 0], [1, 1], [2, 2]), "axisymmetric", (Pressure("right", 1.0),), "translation along z"),
        (block([0] * 3, [1] * 3, [1] * 3, "hex8"), None, (Symmetry("left"), Symmetry("bottom")), "along y:"),
    ],
)  # fmt: skip
def test_missing_support_is_told_by_its_motion(mesh, geometry, loads, told):
    """A singular stiffness is an error with status 3 that names the free motion."""
    solver = ImplicitSolver(mesh, steel(), geometry=geometry, loads=loads, increment=1.0)
    with pytest.raises(SingularStiffness, match=told) as caught:
        solver.advance()
    assert caught.value.exit_status == 3


def test_several_bodies_are_refused():
    """They would pass through each other: the message says what has contact."""
    two = join([block([0, 0], [1, 1], [1, 1]), replace(block([2, 0], [3, 1], [1, 1]), boundaries={})])
    with pytest.raises(UnsupportedError, match="2 bodies, between which fem.ImplicitSolver has no contact"):
        ImplicitSolver(two, steel(), geometry="plane-strain", loads=(Fixed("left"),), increment=1.0)


def test_element_that_inverts_is_named():
    """A body squeezed through itself is cut and refused with the number of the element."""
    mesh = block([0.0, 0.0], [1.0, 1.0], [1, 2])
    loads = (Symmetry("bottom"), Symmetry("left"), Prescribed("top", 1, -2.0))
    solver = ImplicitSolver(
        mesh, steel(), geometry="plane-strain", loads=loads, increment=1.0, smallest=0.6, cure="none"
    )
    with pytest.raises(NoEquilibrium, match=r"at point \d+ \(element \d\)"):
        solver.advance()


def test_tangents_that_are_not_finite_are_refused(monkeypatch):
    """Stress or tangent that turns to NaN ends the run and does not pass for equilibrium."""
    solver = bar(1, 1, 1.0, 1.0, smallest=0.9)
    linearise = solver.points.linearise

    def spoilt(dt, stresses, tangents):
        work = linearise(dt, stresses, tangents)
        tangents[0, 4, 4] = np.nan
        return work

    monkeypatch.setattr(solver.points, "linearise", spoilt)
    with pytest.raises(NoEquilibrium, match="the tangent is not finite"):
        solver.advance()
    assert solver.time == 0.0 and (solver.positions == solver.mesh.points).all()


@pytest.mark.parametrize(
    ("options", "error", "told"),
    [
        ({"increment": 0.0}, SceneError, "increment = 0 s is out of range"),
        ({"smallest": 2.0}, SceneError, "smallest = 2 s is out of range"),
        ({"tolerance": 0.1}, SceneError, "tolerance"),
        ({"iterations": 0}, SceneError, "iterations = 0 is out of range"),
        ({"log": "no/such/folder/log.jsonl"}, OutputError, "the log cannot be written"),
        ({"linear_solver": "scipi"}, SceneError, "scipy"),
        ({"own_share": 1.5}, SceneError, "own_share"),
        (
            {"own_share": 0.1, "cure": "none"},
            SceneError,
            "own_share is void: the cure 'none' projects nothing",
        ),
        ({"integration": "reduced"}, UnsupportedError, "one-point quad4 has no implicit hourglass control"),
        ({"loads": (Damping(1.0),)}, SceneError, "Damping does nothing without motion"),
    ],
)
def test_senseless_options_are_refused(options, error, told):
    """Options out of range, and what has no tangent, are refused before anything is solved."""
    mesh = block([0.0, 0.0], [1.0, 1.0], [1, 1])
    with pytest.raises(error, match=told):
        ImplicitSolver(mesh, steel(), **({"increment": 1.0} | options))


def test_nodal_averages_have_no_tangent():
    """Linear triangles with their cure are refused; the message says what to use."""
    with pytest.raises(UnsupportedError, match="use tri6 elements, or cure='none'"):
        ImplicitSolver(block([0, 0], [1, 1], [1, 1], "tri3"), steel(), increment=1.0)
