"""Work and precision: times to reach errors from runs whose answer is known, and a small study of a tiny bar."""

import csv
import json
import math
from dataclasses import replace

import pytest

from core_models.errors import OutputError, RunFailure, SceneError
from studies.command_line import main
from studies.work_precision.analysis import (
    EXTRAPOLATED,
    INTERPOLATED,
    MEASURED,
    NOT_REACHED,
    NOT_RESOLVABLE,
    joint_reference,
    order_of,
    pareto_front,
    reach,
    relative_error,
)
from studies.work_precision.measurement import Measurement, measure_run
from studies.work_precision.problem import Reference
from studies.work_precision.study import compare_work, find_problem, planned
from studies.work_precision.tables import reach_table
from studies.work_precision.verdict import limits_of, verdict_section
from tests.studies.work_samples import EXACT, RESOLUTIONS, sequence


def test_time_between_two_runs_is_interpolated_in_logarithms():
    """Errors 16, 4, 1, 0.25, 0.0625 % in 1, 8, 64 ms, ...: 2 % lies halfway between 8 and 64 in logarithms."""
    found = reach(sequence(), "u", EXACT, 0.02)
    assert found.how == INTERPOLATED
    assert found.seconds == pytest.approx(math.sqrt(8e-3 * 64e-3), rel=1e-9)


def test_an_error_that_the_coarsest_run_has_is_measured():
    """No time below the fastest run is made up."""
    found = reach(sequence(error=0.01), "u", EXACT, 0.05)
    assert (found.seconds, found.how) == (1e-3, MEASURED)


def test_an_error_below_the_finest_is_extrapolated_by_both_orders():
    """Error falls by h^2, time grows by h^-3: a quarter of the error takes 8 times as long; far off is not reached."""
    runs = sequence()
    finest = runs[-1]
    found = reach(runs, "u", EXACT, relative_error(finest, "u", EXACT) / 4.0)
    assert found.how == EXTRAPOLATED and found.seconds == pytest.approx(8.0 * finest.seconds, rel=1e-6)
    assert reach(runs, "u", EXACT, 1e-7).how == NOT_REACHED
    assert reach(sequence(order=0.0), "u", EXACT, 0.01).how == NOT_REACHED


def test_a_curve_that_crosses_the_reference_by_chance_gains_nothing():
    """An error counts as reached where all finer runs keep it."""
    runs = sequence(order=1.0)
    runs[1] = Measurement("fem-explicit", 8, {"u": 2.0}, 8e-3)
    assert reach(runs, "u", EXACT, 0.03).seconds > runs[2].seconds


def test_levels_below_the_references_own_uncertainty_are_not_resolvable():
    """Three times the uncertainty is the least."""
    doubtful = Reference(2.0, 0.01, "made")
    assert reach(sequence(), "u", doubtful, 0.0149).how == NOT_RESOLVABLE
    assert reach(sequence(), "u", doubtful, 0.0151).how == INTERPOLATED


def test_the_joint_reference_is_where_all_variants_tend_to():
    """Three variants with limits alike: the value is found; ones that disagree make it as uncertain as they differ."""
    alike = [*sequence("a"), *sequence("b", error=-0.1), *sequence("c", order=1.5)]
    found = joint_reference(alike, "u")
    assert found.value == pytest.approx(2.0, rel=1e-4) and found.uncertainty < 2e-3
    moved = [Measurement("d", run.resolution, {"u": run.values["u"] + 0.1}, 1.0) for run in sequence()]
    assert joint_reference([*sequence("a"), *moved], "u").uncertainty >= 0.04
    assert joint_reference(sequence()[:2], "u").value is None


def test_order_and_front():
    """The slope of the errors; runs that are beaten in both are not on the front."""
    runs = sequence()
    assert order_of(list(RESOLUTIONS), [relative_error(run, "u", EXACT) for run in runs]) == pytest.approx(
        2.0
    )
    slower = sequence("slow", seconds=2e-3, error=0.17)
    assert pareto_front([*runs, *slower], "u", EXACT) == runs


def test_the_table_stars_the_fastest_of_each_level():
    """One star a column at most, at the variant that is twice as fast."""
    table = reach_table([*sequence("quick"), *sequence("slow", seconds=2e-3)], "u", EXACT)
    rows = {row[0]: row[1:] for row in table.rows}
    assert all(cell.endswith("*") for cell in rows["quick"][:-1] if cell != NOT_REACHED and "~" not in cell)
    assert not any(cell.endswith("*") for cell in rows["slow"][:-1])
    assert rows["quick"][-1] == rows["slow"][-1] == pytest.approx(2.0)


def test_what_goes_wrong_is_a_message_and_no_number():
    """The study goes on."""

    def refuse():
        raise RunFailure("step 3: not finite")

    run = measure_run("mpm", 4, refuse, lambda solver: {}, 1)
    assert run.message == "step 3: not finite" and not run.values


def test_a_small_study_leaves_tables_and_reports(tmp_path):
    """A bar of two periods by finite elements: errors fall with second order, CSV, Markdown and HTML say the same."""
    problem = find_problem("vibrating-bar")
    outcome = compare_work(
        problem,
        tmp_path / "out",
        variants=("fem-explicit",),
        resolutions=(1, 2, 3, 4, 5),
        repeats=1,
        threads=2,
    )
    assert all(run.values and run.seconds > 0.0 and run.memory_bytes > 1e6 for run in outcome.runs)
    rows = list(csv.reader((tmp_path / "out/errors-period.csv").open()))
    errors = [float(row[2]) for row in rows[1:]]
    assert errors == sorted(errors, reverse=True) and errors[-1] < 0.5
    record = json.loads((tmp_path / "out/results.json").read_text())
    assert [run["resolution"] for run in record["runs"]] == [1, 2, 3, 4, 5, 5]
    assert record["runs"][5]["threads"] == 2 and ",yes" in (tmp_path / "out/threads.csv").read_text()
    for name in ("report.html", "report.md"):
        assert "Time to reach an error of the period" in (tmp_path / "out" / name).read_text()


def test_a_study_that_was_stopped_measures_only_what_is_missing(tmp_path, monkeypatch):
    """What is kept comes out as it was; a study with other settings is refused."""
    made = {(run.variant, run.resolution): run for name in ("fem-explicit", "mpm") for run in sequence(name)}
    asked = []

    def measure(variant, resolution, build, finish, repeats, threads):
        asked.append((variant, resolution))
        if len(asked) == 7:
            raise KeyboardInterrupt
        return made[variant, resolution]

    monkeypatch.setattr("studies.work_precision.study.measure_run", measure)
    problem = replace(
        find_problem("vibrating-bar"),
        references={"u": EXACT},
        units={"u": "s"},
        variants=("fem-explicit", "mpm"),
        resolutions=dict.fromkeys(("fem-explicit", "mpm"), RESOLUTIONS),
    )
    with pytest.raises(KeyboardInterrupt):
        compare_work(problem, tmp_path / "out", repeats=1, threads=1)
    outcome = compare_work(problem, tmp_path / "out", repeats=1, threads=1, going_on=True)
    assert len(asked) == 11 and asked[6] == asked[7] == ("mpm", 8)
    assert outcome.runs == list(made.values())
    verdict = next(section for section in outcome.report.sections if section.name == "verdict")
    assert "agree within their uncertainty" in verdict.remarks[0]
    with pytest.raises(OutputError, match="repeats = 1, not 2"):
        compare_work(problem, tmp_path / "out", repeats=2, threads=1, going_on=True)
    with pytest.raises(OutputError, match="another plan, without fem-explicit 64 2; give"):
        compare_work(problem, tmp_path / "out", repeats=1, threads=2, going_on=True)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["vibrating-bra"], "vibrating-bar"),
        (["vibrating-bar", "--resolutions", "1,2"], "5 or more"),
        (["vibrating-bar", "--resolutions", "0,1,2,3,4"], "1 or more"),
        (["vibrating-bar", "--resolutions", "-4,6,8,12,16"], "list of whole numbers"),
        (["vibrating-bar", "--wall", "plane"], "has no wall"),
        (["necking-simo", "--methods", "mpm-lt"], "mpm-tl"),
        (["taylor-classic", "--methods", "fem-explicit:hex9"], "hex8"),
    ],
)
def test_bad_input_is_one_line(arguments, told, tmp_path, capsys):
    """Status 2, and no folder."""
    assert main(["study", "work-precision", *arguments, "--out", str(tmp_path / "out")]) == 2
    assert told in capsys.readouterr().err and not (tmp_path / "out").exists()


def test_scenes_know_what_to_be_held_against():
    """The plane wall has published values, the unilateral one is extrapolated; every problem has five resolutions."""
    published = find_problem("taylor-classic", "plane").references
    assert published["foot_radius"].value == 7.2256e-3 and published["foot_radius"].uncertainty < 1e-5
    assert find_problem("taylor-classic").references["foot_radius"].value is None
    for name in ("taylor-copper-jc", "vibrating-bar", "vortex"):
        problem = find_problem(name)
        assert len(planned(problem, None, None)) >= 5 * len(problem.variants)
    with pytest.raises(SceneError, match="5 or more"):
        planned(problem, None, (4, 8))


def test_a_bar_that_necks_is_a_problem_too():
    """Two elements across by implicit finite elements: the force near the codes' 77.3 kN, linear solves counted."""
    problem = find_problem("necking-simo")
    run = measure_run("fem-implicit", 2, lambda: problem.build("fem-implicit", 2, 1), problem.finish, 1)
    assert run.values["peak_force"] == pytest.approx(77.3e3, rel=2e-3)
    assert run.values["neck_radius_at_6_mm"] < run.values["neck_radius_at_5_mm"] < 4.7e-3
    assert run.steps < run.linear_solves and run.point_updates >= run.points * run.linear_solves
    corrections = run.point_updates // run.points
    assert (
        run.node_updates % corrections == 0 and run.node_updates // corrections % 3 == 0
    )  # three nodes a row


def test_the_two_methods_are_compared_once_by_their_first_variants():
    """Of three variants each, those that stand first."""
    names = ("fem-implicit", "fem-explicit", "mpm-implicit", "mpm")
    runs = [run for name in names for run in sequence(name)]
    runs.append(replace(runs[-1], resolution=2))
    problem = replace(find_problem("necking-simo"), references={"u": EXACT}, units={"u": "m"})
    sentence, _ = verdict_section(problem, runs).remarks
    assert "fem-implicit" in sentence and "mpm-implicit" in sentence and "agree" in sentence


def test_limits_stand_beside_a_reference_that_is_given():
    """By per cent and in both uncertainties together; an extrapolated reference, made of them, says nothing."""
    runs = [*sequence("fem-explicit"), *sequence("mpm")]
    limit = limits_of(runs, "u")["mpm"]
    given = Reference(2.02, 0.01, "a book")
    problem = replace(find_problem("vibrating-bar"), references={"u": given}, units={"u": "m"})
    found = verdict_section(problem, runs)
    off = (2.02 - limit.value) / math.hypot(0.01, limit.uncertainty)
    assert f", a book: fem-explicit is off by -0.99 %, {off:.1f} times both uncertainties" in found.remarks[1]
    assert found.tables[0].rows[1][2:4] == pytest.approx((-0.99, off), rel=1e-2)
    joint = verdict_section(replace(problem, references={"u": replace(given, value=None)}), runs)
    assert len(joint.remarks) == 1 and len(joint.tables[0].head) == len(found.tables[0].head) - 2


def test_resolutions_given_twice_are_refused_and_variants_merged():
    """By the number that is repeated; one resolution is one."""
    problem = find_problem("vibrating-bar")
    with pytest.raises(SceneError, match="3 is given more than once"):
        planned(problem, None, (3, 3, 3, 3, 3))
    with pytest.raises(SceneError, match="1 resolution shows no order"):
        planned(problem, None, (3,))
    assert planned(problem, ("mpm", "mpm"), RESOLUTIONS) == [("mpm", each) for each in RESOLUTIONS]
