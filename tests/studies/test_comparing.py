"""Comparisons: results.json, verdicts, report."""

import itertools
import json
import re
import shutil
from dataclasses import replace

import numpy as np
import pytest

from core_models.errors import OutputError
from studies.bar.quantity_names import QUANTITIES
from studies.checkpointing.interval import Interval
from studies.comparisons.comparing import compare
from studies.comparisons.convergence import Estimate
from studies.comparisons.differences import difference
from studies.report.comparison_report import report_of
from studies.report.markdown import markdown


@pytest.fixture
def results(fake_solvers, classic, tmp_path):
    """A comparison of three resolutions of both methods under the plane wall, and its folder."""
    comparison = compare(classic, resolutions=(8, 12, 16), wall="plane", out=tmp_path / "out")
    return comparison, tmp_path / "out"


def test_results_json_holds_every_run_with_the_required_entries(results):
    """A list `runs` with method, resolution, wall, status, quantities, cost, conservation, effects."""
    content = json.loads((results[1] / "results.json").read_text(), parse_constant=pytest.fail)
    labels = [(run["method"], run["resolution"]) for run in content["runs"]]
    assert labels == [(method, n) for method in ("fem-explicit", "mpm") for n in (8, 12, 16)]
    for run in content["runs"]:
        assert (run["status"], run["wall"]) == ("complete", "plane")
        assert tuple(run["quantities"]) == QUANTITIES
        assert all({"value", "unit"} <= set(quantity) for quantity in run["quantities"].values())
        assert {"cost", "conservation", "effects"} <= set(run)


def test_methods_that_close_on_one_limit_agree(results):
    """The pretended methods come from two sides to one limit: the verdict says so."""
    verdicts = {each.quantity: each for each in results[0].differences}
    assert verdicts["final_length"].agree
    assert "agree within their uncertainty" in verdicts["final_length"].verdict
    assert abs(verdicts["final_length"].finest) > abs(verdicts["final_length"].limit)


def test_values_apart_that_agree_by_their_uncertainty_alone_are_called_so(fake_solvers, classic):
    """3.9 % apart within 4.1 %: no tick, but the one that is uncertain named; the profiles' distance has no mark."""
    comparison = compare(classic, resolutions=(8, 12, 16), wall="plane")
    first, second = comparison.finest
    limits = {
        first.method: {"foot_radius": Estimate(14.46e-3, 0.08e-3, 1.0, 0.0, "made")},
        second.method: {"foot_radius": Estimate(15.02e-3, 0.62e-3, 1.0, 0.0, "made")},
    }
    found = difference("foot_radius", first, second, limits)
    assert found.agree and found.loosely
    assert (
        "agree within their uncertainty (apart by 0.560 mm, 3.9 %), but only because MPM is uncertain by 4.1 %."
        in found.verdict
    )
    closer = replace(limits[second.method]["foot_radius"], value=14.5e-3)
    near = difference("foot_radius", first, second, limits | {second.method: {"foot_radius": closer}})
    assert near.loosely and near.verdict.endswith(", 0.28 %), but MPM is uncertain by 4.3 %.")
    sure = Estimate(14.46e-3, 0.05e-3, 1.0, 0.0, "made")
    alike = difference("foot_radius", first, second, dict.fromkeys(limits, {"foot_radius": sure}))
    assert alike.agree and not alike.loosely and alike.verdict.endswith("(apart by 0 mm, 0 %).")
    comparison.differences = [found]
    text = markdown(report_of(comparison, moving=False))
    assert f"* – {found.verdict}" in text and "\n* Profiles: " in text


def test_references_are_held_against_their_wall_only(results, fake_solvers, classic):
    """The published values hold for the plane wall; under the other wall they are not used."""
    assert {check.reference.quantity for check in results[0].references} == {"final_length", "foot_radius"}
    assert compare(classic, resolutions=(8,), wall="unilateral").references == []


def test_a_run_that_goes_wrong_does_not_stop_the_others(fake_solvers, classic, tmp_path):
    """It is recorded with status and message, and the rest is compared."""
    comparison = compare(classic, resolutions=(8, 13, 16), out=tmp_path / "out")
    content = json.loads((tmp_path / "out/results.json").read_text())
    failed = [run for run in content["runs"] if run["status"] == "failed"]
    assert [run["resolution"] for run in failed] == [13, 13]
    assert all("point 1" in run["message"] for run in failed)
    assert len(comparison.differences) > 0
    assert "point 1" in (tmp_path / "out/report.html").read_text()


def test_a_comparison_of_failures_only_still_reports(fake_solvers, classic, tmp_path):
    """With no completed run there is a results.json and a report that says why."""
    comparison = compare(classic, resolutions=(13,), out=tmp_path / "out")
    assert len(comparison.failed) == 2
    assert (tmp_path / "out/report.html").exists()


def test_one_method_alone_can_be_compared_with_references(fake_solvers, classic, tmp_path):
    """Without a second method there are no differences, but limits and references."""
    comparison = compare(classic, ("mpm",), (8, 12, 16), wall="plane", out=tmp_path / "out")
    assert comparison.differences == []
    assert comparison.limits["mpm"]["final_length"].uncertainty > 0.0
    assert (tmp_path / "out/report.html").exists()


def test_the_report_needs_nothing_from_outside(results):
    """One page that fetches nothing; every figure states its wall."""
    page = (results[1] / "report.html").read_text()
    outside = re.findall(r'(?:src|href)="(?!data:|#)[^"]*"', page)
    assert outside == []
    assert "@import" not in page and "fetch(" not in page and "XMLHttpRequest" not in page
    figures = re.findall(r"<figure>.*?</figure>", page, flags=re.S)
    assert len(figures) >= 5
    assert all("plane" in figure for figure in figures)


def test_without_matplotlib_there_are_results_and_a_notice(fake_solvers, classic, tmp_path, monkeypatch):
    """The report extra is optional: results.json is written and one line says what to install."""
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    comparison = compare(classic, resolutions=(8,), out=tmp_path / "out")
    assert "matpoint[report]" in comparison.notice
    assert (tmp_path / "out/results.json").exists()
    assert not (tmp_path / "out/report.html").exists()


def test_repeated_methods_and_resolutions_run_once(fake_solvers, classic):
    """Each run has its own folder, so each is made once, coarse to fine."""
    comparison = compare(classic, ("mpm", "mpm"), (12, 8, 12))
    assert [run.label for run in comparison.runs] == ["mpm 8", "mpm 12"]


def test_a_comparison_that_was_stopped_goes_on(fake_solvers, classic, tmp_path, monkeypatch):
    """Complete runs are read back bit by bit, missing ones made; another comparison in the folder is refused."""
    whole = compare(classic, resolutions=(8, 12), out=tmp_path / "whole")
    with monkeypatch.context() as patch:
        patch.setattr("studies.comparisons.comparing.conclude", stopped)
        with pytest.raises(KeyboardInterrupt):
            compare(classic, resolutions=(8, 12), out=tmp_path / "out")
    shutil.rmtree(tmp_path / "out/mpm-12")
    again = compare(classic, resolutions=(8, 12), out=tmp_path / "out", going_on=True)
    for name in ("limits", "differences", "profiles"):
        assert getattr(again, name) == getattr(whole, name)
    for before, after in zip(whole.runs, again.runs, strict=True):
        assert before.quantities == after.quantities and before.ended == after.ended
        np.testing.assert_array_equal(before.history.column("length"), after.history.column("length"))
        np.testing.assert_array_equal(before.final.domains, after.final.domains)
    with pytest.raises(OutputError, match="threads = 1, not 2"):
        compare(classic, resolutions=(8, 12), threads=2, out=tmp_path / "out", going_on=True)


def stopped(*_):
    """Ends a comparison after its runs."""
    raise KeyboardInterrupt


def test_a_run_of_a_comparison_goes_on_from_its_checkpoint(classic, tmp_path, monkeypatch):
    """A run that was killed on its way makes only the steps that are left, and ends bitwise the same."""
    whole = compare(classic, ("fem-explicit",), (4,), wall="plane", out=tmp_path / "whole")
    with monkeypatch.context() as patch:
        patch.setattr("studies.runs.running.USUAL", Interval(steps=25))
        steps = itertools.count()
        patch.setattr(
            "studies.observers.contact_watch.ContactWatch.step", lambda *_: next(steps) < 60 or stopped()
        )
        with pytest.raises(KeyboardInterrupt):
            compare(classic, ("fem-explicit",), (4,), wall="plane", out=tmp_path / "out")
    assert (tmp_path / "out/fem-explicit-4/checkpoint.npz").exists()
    again = compare(classic, ("fem-explicit",), (4,), wall="plane", out=tmp_path / "out", going_on=True)
    assert again.runs[0].resumed == 1
    assert again.runs[0].quantities == whole.runs[0].quantities


def test_a_comparison_on_a_full_disk_goes_on(fake_solvers, classic, tmp_path, full_disk):
    """The runs that found no space are recorded as failed."""
    compare(classic, resolutions=(8,), out=tmp_path / "out")
    content = json.loads((tmp_path / "out/results.json").read_text())
    assert [run["status"] for run in content["runs"]] == ["failed", "failed"]
    assert "free space" in content["runs"][1]["message"]
