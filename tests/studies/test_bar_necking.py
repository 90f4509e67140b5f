"""The bar necking study: closed forms, quantities of made curves, quasi-static refusals, scenes, and coarse runs."""

import inspect
import json
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from lxml import etree

import fem
import mpm
from core_models.equilibrium.stepping import QuasiStatic
from core_models.errors import CardError, NoEquilibrium, OutputError, RunFailure, SceneError
from core_models.ledger import EnergyLedger
from core_models.loads import Prescribed, Symmetry
from fem.cures.choice import CURES
from meshes.block import block
from mpm.implicit.splines import DEGREES
from mpm.interpolation.catalogue import INTERPOLATIONS
from studies.command_line import main
from studies.methods.quasi_static import KineticWatch, slow_enough
from studies.methods.solver_options import ELEMENTS, PARTICLES, SOLVER_OPTIONS
from studies.necking.bar_necking import (
    NeckingHistory,
    at_elongation,
    bridgman_factor,
    fall_to,
    first_failure,
    is_broken,
    neck_curvature,
    peak,
    uniform_peak,
)
from studies.necking.course import Course
from studies.necking.curves import read_curve
from studies.necking.kept_state import KeptState
from studies.necking.methods import make_run
from studies.necking.reader import CHECKS, necking_scenes, read_necking_scene
from studies.necking.record import perform_run
from studies.necking.run import NeckingRun
from studies.necking.scene import PlannedRun
from studies.necking.study import planned, study_necking
from studies.necking.verdicts import criteria_of
from studies.scenes.material_finder import with_update
from studies.sweep.job import FAILED, perform

LENGTH = 0.1
SIMO = read_necking_scene("necking-simo")


def history(elongation, force, **columns):
    """A history with these columns, the others 0."""
    columns |= {"elongation": elongation, "force": force}
    rows = np.zeros((len(elongation), len(NeckingHistory.COLUMNS)))
    for name, values in columns.items():
        rows[:, NeckingHistory.COLUMNS.index(name)] = values
    return NeckingHistory(rows.tolist())


def test_closed_forms_of_the_largest_uniform_force():
    """79.46 kN where the flow stress is the Kirchhoff stress, 79.58 kN where it is the Cauchy stress."""
    assert uniform_peak(SIMO.material, SIMO.radius) == pytest.approx(79.46e3, rel=1e-4)
    assert uniform_peak(with_update(SIMO.material, "hypoelastic"), SIMO.radius) == pytest.approx(
        79.58e3, rel=1e-4
    )


def test_peak_of_a_parabola_is_exact_between_its_points():
    """The largest force of a curve is found between increments."""
    u = np.linspace(0.0, 1.0, 8)
    assert peak(history(u, 5.0 - (u - 0.47) ** 2)) == pytest.approx((0.47, 5.0), rel=1e-12)


def test_values_beyond_the_end_of_a_run_are_not_made_up():
    """At an elongation that a run has not reached there is no value."""
    made = history([0.0, 1.0], [0.0, 2.0])
    assert at_elongation(made, "force", 0.25) == 0.5 and at_elongation(made, "force", 1.1) is None


def test_bridgman_factor_agrees_with_his_table():
    """a / R = 0.1, 0.25, 0.5, 1: 0.976, 0.943, 0.896, 0.822; 1 without a neck."""
    factors = [bridgman_factor(1.0, curvature) for curvature in (0.1, 0.25, 0.5, 1.0)]
    assert factors == pytest.approx([0.976, 0.943, 0.896, 0.822], abs=6e-4)
    assert bridgman_factor(1.0, 0.0) == 1.0


def test_curvature_of_a_round_notch_is_found():
    """A circle of radius 2 that touches r = 1 at z = 0."""
    z = np.linspace(0.0, 1.0, 41)
    side = np.column_stack([3.0 - np.sqrt(4.0 - z**2), z])
    assert neck_curvature(side) == pytest.approx(0.5, rel=0.02)


def test_mass_is_scaled_to_the_lowest_natural_mode():
    """A bar held at both ends has the period 2 L / c: loading then takes the periods asked for."""
    mesh = block([0.0, 0.0], [LENGTH / 20.0, LENGTH], [1, 20])
    loads = (Symmetry("bottom"), Prescribed("top", 1, 0.0))
    material = SIMO.material
    scaled = slow_enough(mesh, material, loads, 1.0, 50.0)
    bulk, shear = material.elasticity.bulk_modulus, material.elasticity.shear_modulus
    young = 9.0 * bulk * shear / (3.0 * bulk + shear)
    period = 2.0 * LENGTH / math.sqrt(young / scaled.density)
    assert 1.0 / period == pytest.approx(50.0, rel=5e-3)


def test_a_run_that_moves_is_not_called_quasi_static():
    """More kinetic energy than 0.2 % of what the body took up is refused with the share; the start does not count."""
    watch = KineticWatch(0.1)
    for time, kinetic in ((0.05, 5.0), (0.2, 0.0015), (0.3, 0.001)):
        watch.look(SimpleNamespace(time=time, ledger=EnergyLedger(0.0, kinetic, 0.4, 0.6)))
    watch.check()
    assert watch.share == pytest.approx(0.0015)
    watch.look(SimpleNamespace(time=0.4, ledger=EnergyLedger(0.0, 0.03, 0.4, 0.6)))
    with pytest.raises(RunFailure, match=r"up to 3 % .* not quasi-static; load over more periods"):
        watch.check()


def test_fracture_and_first_failure_are_read_from_the_curve():
    """Broken where a tenth of the largest force is left; failed where the first point has; nothing made up without."""
    made = history(
        [0.0, 1.0, 2.0, 3.0],
        [0.0, 10.0, 6.0, 0.0],
        failed=[0.0, 0.0, 0.1, 0.2],
        failed_place=[0.0, 0.0, 0.25, 0.25],
    )
    assert fall_to(made, 0.1) == pytest.approx(2.0 + 5.0 / 6.0)
    assert first_failure(made) == (2.0, 0.25)
    whole = history([0.0, 1.0], [0.0, 2.0])
    assert fall_to(whole, 0.1) is None and first_failure(whole) == (None, None)


def test_a_run_ends_when_the_body_is_broken():
    """With less than a hundredth of the largest force; a start from nothing and a bar that holds are not broken."""
    assert not is_broken(NeckingHistory()) and not is_broken(history([0.0, 1.0], [0.0, 2.0]))
    assert not is_broken(history([0.0, 1.0, 2.0], [1.0, 10.0, 0.2]))
    assert is_broken(history([0.0, 1.0, 2.0], [1.0, 10.0, 0.05]))


def test_coarse_bar_necks_near_the_other_codes():
    """4 x 12 elements in 50 increments: peak 77.3 kN within 0.3 %, no cut; Bridgman within 5 and 10 %."""
    run = make_run(SIMO, PlannedRun("coarse", "fem-implicit", 4, 12, 0.25, increments=50))
    at, force = peak(run.history)
    assert force == pytest.approx(77.3e3, rel=3e-3) and at == pytest.approx(2.83e-3, abs=0.05e-3)
    assert at_elongation(run.history, "force", 4e-3) == pytest.approx(71.2e3, rel=0.015)
    assert run.cuts == 0 and run.kinetic_share == 0.0
    for estimate, true, off in (
        ("bridgman_flow", "flow_stress", 0.05),
        ("bridgman_axial", "axial_stress", 0.1),
    ):
        values = [at_elongation(run.history, name, 4e-3) for name in (estimate, true)]
        assert values[0] == pytest.approx(values[1], rel=off)
    centre, surface = (at_elongation(run.history, f"{at}_triaxiality", 4e-3) for at in ("centre", "surface"))
    assert centre > 0.45 > surface > 0.2


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


def test_checks_are_of_runs_that_were_made():
    """A run that is twice another breaks their agreement; checks of runs that are missing say nothing."""
    u = np.linspace(0.0, 7e-3, 30)
    force, radius = 77.3e3 - 3e9 * (u - 2.83e-3) ** 2, np.linspace(6.3e-3, 2e-3, 30)
    made = [
        NeckingRun(history(u, factor * force, neck_radius=radius), np.zeros((1, 4, 2)), np.zeros(1), 1.0, 30)
        for factor in (1.0, 2.0)
    ]
    runs = dict(zip(("fem-implicit", "fem-explicit"), made, strict=True))
    found = {each.what: each for each in criteria_of(SIMO, runs)}
    agreements = [each for what, each in found.items() if "against fem-implicit" in what]
    assert [each.met for each in agreements] == [False, True, True]
    assert agreements[0].value == pytest.approx(100.0)
    assert not any("mpm" in what for what in found)


def small(name):
    """The shipped bar with one coarse run and one check that it does not meet."""
    root = etree.parse(necking_scenes()["necking-simo"]).getroot()
    for tag in ("run", "curve", *CHECKS):
        for element in root.findall(tag):
            root.remove(element)
    root.set("name", name)
    run = {
        "name": "one",
        "method": "fem-implicit",
        "across": "2",
        "along": "4",
        "increments": "3",
        "quick": "yes",
    }
    etree.SubElement(root, "run", run)
    etree.SubElement(root, "expect", run="one", quantity="peak_force", low="1", high="2")
    return etree.tostring(root, encoding="unicode")


def test_a_study_is_kept_and_gone_on_with(tmp_path):
    """Runs that a folder holds are not made again; another scene's folder is refused; the report is whole."""
    scene, out = tmp_path / "small.xml", tmp_path / "out"
    scene.write_text(small("small"), encoding="utf-8")
    told = []
    outcome = study_necking(scene, out, workers=1, tell=lambda *each: told.append(each))
    assert len(told) == 1 and not outcome.criteria[0].met
    kept = json.loads((out / "runs" / "one.json").read_text())
    assert len(kept["rows"]) >= 3 and len(kept["strains"]) == 32
    study_necking(scene, out, going_on=True, workers=1, tell=lambda *each: told.append(each))
    assert len(told) == 1
    assert "peak force, one, 2 × 4" in (out / "report.html").read_text(encoding="utf-8")
    scene.write_text(small("other"), encoding="utf-8")
    with pytest.raises(OutputError, match="scene = small, not other"):
        study_necking(scene, out, going_on=True)
    scene.write_text(small("small").replace('length="26.667e-3"', 'length="25e-3"'), encoding="utf-8")
    with pytest.raises(OutputError, match="started with fingerprint"):
        study_necking(scene, out, going_on=True)


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


class Killed(BaseException):
    """Ends a run at once, like a kill or Ctrl-C."""


def stop_at(monkeypatch, row, reason):
    """Let every run be ended by `reason` instead of taking its row of this number, once."""
    take, left = Course.row, [row]

    def stopping(self, force):
        left[0] -= 1
        if left[0] == 0:
            raise reason
        take(self, force)

    monkeypatch.setattr(Course, "row", stopping)


@pytest.mark.parametrize(
    "plan",
    [
        PlannedRun("implicit", "fem-implicit", 2, 6, 0.5, increments=6),
        PlannedRun("explicit", "fem-explicit", 2, 6, 0.5, periods=20.0),
    ],
)
@pytest.mark.parametrize("reason", [Killed(), NoEquilibrium("no equilibrium")])
def test_a_run_goes_on_from_the_state_that_was_kept(plan, reason, tmp_path, monkeypatch):
    """After a kill and after a typed failure: its history, shape and counts are bitwise those of one left alone."""
    scene, state = replace(SIMO, pull=1e-3), KeptState(tmp_path / "state.npz")
    whole = make_run(scene, plan)
    with monkeypatch.context() as patch:
        stop_at(patch, 4, reason)
        if isinstance(reason, Killed):
            with pytest.raises(Killed):
                make_run(scene, plan, state)
        else:
            assert make_run(scene, plan, state).history.rows == whole.history.rows[:3]
    assert int(state.read()["solver.step_count"]) < whole.steps
    again = make_run(scene, plan, state)
    assert again.history.rows == whole.history.rows and again.steps == whole.steps
    assert (again.shape == whole.shape).all() and again.kinetic_share == whole.kinetic_share


def test_states_of_other_sources_and_damaged_ones_are_not_gone_on_from(tmp_path, monkeypatch):
    """The run then begins anew."""
    state = KeptState(tmp_path / "state.npz")
    assert state.read() is None
    state.write({"x": np.ones(2)})
    assert (state.read()["x"] == 1.0).all()
    whole = state.path.read_bytes()
    state.path.write_bytes(whole[: len(whole) // 2])
    assert state.read() is None
    state.path.write_bytes(whole)
    monkeypatch.setattr("studies.necking.kept_state.source_hash", lambda: "other")
    assert state.read() is None


def in_this_process(jobs, folder, workers, tell):
    """Results of jobs, without processes of their own."""
    results = [perform(job) for job in jobs]
    for result in results:
        tell(result, 1, 1)
    return results


def test_a_run_that_stops_keeps_its_curves_and_goes_on(tmp_path, monkeypatch, capsys):
    """Exit status 3, the reason and what to try; rows up to there prove nothing; with other increments it goes on."""

    def advance(self, limit):
        if self.step_count == 2 and self.time_step > 0.2:
            raise NoEquilibrium("increment 3: no equilibrium")
        QuasiStatic.advance(self, limit)

    monkeypatch.setattr(fem.ImplicitSolver, "advance", advance, raising=False)
    monkeypatch.setattr("studies.necking.study.run_sweep", in_this_process)
    scene, out = tmp_path / "small.xml", tmp_path / "out"
    scene.write_text(small("small"), encoding="utf-8")
    assert main(["study", "necking", str(scene), "--out", str(out)]) == 3
    told = capsys.readouterr().out
    assert "increment 3: no equilibrium. The state at 4.667 mm is kept: --resume goes on" in told
    (criterion,) = json.loads((out / "results.json").read_text(encoding="utf-8"))["criteria"]
    assert criterion["what"] == "one runs to the end"
    assert "one (stopped)" in (out / "report.html").read_text(encoding="utf-8")
    record = perform_run(scene, "one")
    assert (record["status"], record["exit_status"], len(record["rows"])) == (FAILED, 3, 2)
    scene.write_text(small("small").replace('increments="3"', 'increments="6"'), encoding="utf-8")
    assert main(["study", "necking", str(scene), "--resume", str(out)]) == 1
    assert (out / "runs").is_dir() and not list((out / "runs").glob("*.npz"))
    assert "force at end" in (out / "report.html").read_text(encoding="utf-8")


def test_a_finished_run_is_made_again_for_other_increments(tmp_path, monkeypatch):
    """What is kept of the study is of the increments that the scene asks for; nothing else is made again."""
    scene, out = tmp_path / "small.xml", tmp_path / "out"
    scene.write_text(small("small"), encoding="utf-8")
    told = []
    monkeypatch.setattr("studies.sweep.sweep._results", lambda jobs, *_: map(perform, jobs))
    monkeypatch.setattr("studies.necking.study.write_report", lambda report, folder: "")
    for increments, made in (("3", 1), ("3", 1), ("4", 2)):
        text = small("small").replace('increments="3"', f'increments="{increments}"')
        scene.write_text(text, encoding="utf-8")
        study_necking(scene, out, going_on=out.exists(), tell=lambda *each: told.append(each))
        assert len(told) == made
        assert json.loads((out / "runs" / "one.json").read_text())["asked"] == [int(increments), None]


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


def test_an_eighth_of_a_bar_in_three_dimensions_necks_like_the_body_of_revolution():
    """Hex8 of the size of the quads: peak over the section of 16 corners within 0.3 %, neck at 4 mm within 1 %."""
    scene = replace(SIMO, pull=4e-3)
    plans = [
        PlannedRun("one", "fem-implicit", 4, 8, 0.25, kind=kind, increments=12) for kind in ("quad4", "hex8")
    ]
    plane, solid = (make_run(scene, plan) for plan in plans)
    section = 16.0 / (2.0 * math.pi) * math.sin(math.pi / 8.0)
    assert peak(solid.history)[1] == pytest.approx(section * peak(plane.history)[1], rel=3e-3)
    for name, within in (("neck_radius", 0.01), ("axial_stress", 0.05), ("bridgman_axial", 0.05)):
        ours, theirs = (at_elongation(run.history, name, 4e-3) for run in (solid, plane))
        assert ours == pytest.approx(theirs, rel=within)
    assert area(solid.shape) == pytest.approx(area(plane.shape), rel=0.01)


def test_a_square_bar_that_stays_straight_has_the_closed_form_of_the_largest_force():
    """A run of its own section, as large as the round one, in three dimensions: within 0.1 %."""
    half = 0.5 * math.sqrt(math.pi) * SIMO.radius
    plan = PlannedRun(
        "square", "fem-implicit", 1, 2, kind="hex8", increments=14, body="square-bar", radius=half, taper=1.0
    )
    run = make_run(replace(SIMO, pull=4.2e-3), plan)
    assert peak(run.history)[1] == pytest.approx(uniform_peak(SIMO.material, SIMO.radius), rel=1e-3)
    assert run.history.column("bridgman_flow").max() == 0.0


def area(shape):
    """Area of quads (n, 4, 2) [m^2]."""
    x, y = shape[..., 0], shape[..., 1]
    return 0.5 * float(np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum()))


def test_extra_runs_are_made_when_asked_for_by_name():
    """Not by default, nor by their method."""
    scene = replace(SIMO, runs=(*SIMO.runs, PlannedRun("costly", "fem-implicit", 1, 1, extra=True)))
    assert "costly" not in [plan.name for plan in planned(scene, None, quick=False)]
    assert "costly" not in [plan.name for plan in planned(scene, ["fem-implicit"], quick=False)]
    assert [plan.name for plan in planned(scene, ["costly"], quick=False)] == ["costly"]
