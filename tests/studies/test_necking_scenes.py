"""Necking scenes: the shipped ones are whole, what makes no sense is refused, runs are chosen by name."""

import inspect
from dataclasses import replace

import numpy as np
import pytest

import fem
import mpm
from core_models.errors import CardError, SceneError
from fem.cures.choice import CURES
from mpm.implicit.splines import DEGREES
from mpm.interpolation.catalogue import INTERPOLATIONS
from studies.methods.solver_options import ELEMENTS, PARTICLES, SOLVER_OPTIONS
from studies.necking.curves import read_curve
from studies.necking.reader import necking_scenes, read_necking_scene
from studies.necking.scene import PlannedRun
from studies.necking.study import planned
from tests.studies.necking_samples import SIMO, small


def test_curves_of_other_codes_are_whole():
    """Both curves go to 7 mm in SI units, with their largest force near 77.3 kN."""
    for curve in SIMO.curves:
        u, force = read_curve(curve, "force")
        assert u[-1] == 7e-3 and force.max() == pytest.approx(77.3e3, rel=2e-3)
        assert (np.diff(read_curve(curve, "neck_radius")[1]) < 0.0).all()


@pytest.mark.parametrize("name", necking_scenes())
def test_shipped_scenes_are_whole(name):
    """Each has runs, checks of runs that it has, and its quick runs."""
    scene = read_necking_scene(name)
    assert scene.name == name and scene.title and scene.description and scene.source and scene.checks
    assert planned(scene, None, quick=True) and planned(scene, None, quick=False)
    for curve in scene.curves:
        assert all(len(read_curve(curve, column)[0]) > 5 for column in curve.columns)


def test_what_a_scene_does_not_have_is_named():
    """Unknown scenes, methods and quantities get the nearest name."""
    with pytest.raises(SceneError, match="'necking-simo'"):
        read_necking_scene("necking-sim")
    with pytest.raises(SceneError, match="fem-implicit"):
        planned(SIMO, ["fem-implict"], quick=False)
    with pytest.raises(SceneError, match="quick run by mpm-tl; there are runs by fem-implicit"):
        planned(SIMO, ["mpm-tl"], quick=True)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('radius="6.413e-3"', 'radius="-6e-3"', "write a number above 0"),
        ('distance="7e-3"', 'distance="0"', "write a number above 0"),
        ('distance="7e-3"', 'distance="7e-3" duration="0"', "write a number above 0"),
        (' increments="3"', "", 'lacks increments; add increments="..."'),
        (
            'increments="3"',
            'increments="3" transfer="flip"',
            "has no option transfer; it has integration, cure",
        ),
        ('increments="3"', 'increments="3" integration="redced"', "did you mean 'reduced'"),
        ('increments="3"', 'increments="3" periods="-2"', "write a number from 0"),
        (
            '<run name="one"',
            '<run name="a:b" method="mpm" across="1" along="1"/><run name="a-b"',
            "called 'a:b'",
        ),
        ('quantity="peak_force"', 'quantity="peak_forc"', "did you mean 'peak_force'"),
        ("<pull ", "<pul ", "did you mean 'pull'"),
    ],
)
def test_scenes_that_make_no_sense_are_refused(old, new, told, tmp_path):
    """Before anything is run, with file, line and remedy."""
    scene = tmp_path / "own.xml"
    assert old in small("own")
    scene.write_text(small("own").replace(old, new), encoding="utf-8")
    with pytest.raises((CardError, SceneError), match=told):
        read_necking_scene(scene)


def test_options_of_runs_are_those_of_the_solvers():
    """Each that a scene may give is an argument of the method's solver, and takes the words that the solver knows."""
    solvers = {
        "fem-implicit": fem.ImplicitSolver, "fem-explicit": fem.ExplicitSolver, "mpm-tl": mpm.Solver,
        "mpm-implicit": mpm.ImplicitSolver, "mpm": mpm.Solver,
    }  # fmt: skip
    for method, options in SOLVER_OPTIONS.items():
        assert set(options) <= set(inspect.signature(solvers[method]).parameters)
    assert ELEMENTS["cure"] == CURES
    assert set(PARTICLES["interpolation"]) == set(INTERPOLATIONS)
    assert set(SOLVER_OPTIONS["mpm-implicit"]["interpolation"]) == set(DEGREES)


@pytest.mark.parametrize(
    ("body", "kind", "told"),
    [
        ("strip", "hex8", "a strip is not made of hex8"),
        ("square_bar", "quad4", "a square-bar is not made of quad4"),
    ],
)
def test_elements_that_a_body_cannot_be_made_of_are_refused(body, kind, told, tmp_path):
    """With the kinds that it can be made of."""
    scene, text = tmp_path / "own.xml", small("own").replace("round_bar", body)
    scene.write_text(text.replace('name="one"', f'name="one" kind="{kind}"'), encoding="utf-8")
    with pytest.raises(SceneError, match=told):
        read_necking_scene(scene)


def test_extra_runs_are_made_when_asked_for_by_name():
    """Not by default, nor by their method."""
    scene = replace(SIMO, runs=(*SIMO.runs, PlannedRun("costly", "fem-implicit", 1, 1, extra=True)))
    assert "costly" not in [plan.name for plan in planned(scene, None, quick=False)]
    assert "costly" not in [plan.name for plan in planned(scene, ["fem-implicit"], quick=False)]
    assert [plan.name for plan in planned(scene, ["costly"], quick=False)] == ["costly"]
