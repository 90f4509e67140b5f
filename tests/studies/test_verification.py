"""The verification study's own parts: verdicts, orders, report, command."""

import json
import math
import os
import time

import numpy as np
import pytest

from core_models.errors import SceneError, UnsupportedError
from core_models.threads import Threads
from studies.command_line import main
from studies.report.document import page as html_page
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.report.study_text import shown
from studies.verification import study
from studies.verification.convergence import ErrorRow
from studies.verification.convergence_report import convergence_outcome
from studies.verification.orders import error_at, fitted_order, sizes_before_floor
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.problems.friction_block import CASES, END, FRICTION, RAMP, G, exact_way
from studies.verification.report import report_of
from studies.verification.study import PROBLEMS, find_problem, verify
from studies.verification.text import criterion_text
from studies.verification.thread_clock import ThreadClock
from studies.verification.variant import Refused, Variant, attempt

SIZES = (0.1, 0.05, 0.025, 0.0125)


def rows(order, factor=1.0):
    """Runs whose error falls with a known order, 8 times as long at half the size."""
    return [ErrorRow(h, 10, factor * h**order, 2.0 * factor * h**order, 5, 0.01 / h**3) for h in SIZES]


def made(*criteria):
    """A problem that gives these criteria and one of everything else."""
    table = Table(
        "Numbers", ("name", "value", "none"), (("first", 1.5, None), ("second", 1234, 2e-9)), "A note."
    )
    curve = Curve("FEM quad4", (1.0, 2.0), (1.0, 4.0), FEM)
    plot = Plot(
        "Square", "x", "y", (curve, Curve("exact", (1.0, 2.0), (1.0, 4.0), "exact")), logarithmic=True
    )
    return Problem(
        "made",
        "A made problem",
        "For <tests>.",
        "nobody",
        lambda quick: Outcome([*criteria], [table], [plot], ["So."]),
    )


@pytest.mark.parametrize(
    ("value", "low", "high", "met"),
    [
        (1.0, 0.5, 2.0, True),
        (0.5, 0.5, 2.0, True),
        (2.1, 0.5, 2.0, False),
        (5.0, 1.9, math.inf, True),
        (math.nan, -math.inf, math.inf, False),
        (None, -math.inf, math.inf, False),
    ],
)
def test_a_criterion_is_met_only_by_a_number_in_its_range(value, low, high, met):
    """What was not measured, or is not a number, is not met."""
    assert Criterion("thing", value, low, high).met is met


def test_order_of_a_power_is_its_exponent():
    """Least squares in logarithms; an error of 0 or NaN has no order."""
    assert fitted_order(SIZES, [3.0 * h**1.7 for h in SIZES]) == pytest.approx(1.7)
    assert math.isnan(fitted_order(SIZES, [1.0, 0.1, 0.0, 0.1]))
    assert math.isnan(fitted_order(SIZES, [1.0, 0.1, math.nan, 0.1]))


def test_sizes_before_a_floor_are_those_where_the_error_still_falls():
    """The first flat interval ends the count, a least number of sizes stays in any case."""
    assert sizes_before_floor(SIZES, [1.0, 0.25, 0.06, 0.05], 1.4, least=2) == 3
    assert sizes_before_floor(SIZES, [1.0, 0.25, 0.06, 0.015], 1.4, least=2) == 4
    assert sizes_before_floor(SIZES, [1.0, 0.9, 0.8, 0.9], 1.4, least=3) == 3


def test_error_at_a_time_is_interpolated_and_never_extrapolated():
    """On a straight line in logarithms; outside the runs' times there is none."""
    assert error_at(10.0, [1.0, 100.0], [1e-2, 1e-4]) == pytest.approx(1e-3)
    assert error_at(0.5, [1.0, 100.0], [1e-2, 1e-4]) is None


def test_convergence_outcome_asks_for_orders_and_for_a_worse_control():
    """Right orders are met, a low one is not, what was refused is not met and says why."""
    variants = {
        "good": Variant("good", FEM, "quad4", {}, 1.9),
        "low": Variant("low", MPM, "quad4", {}, 1.9),
        "control": Variant("control", MPM, "quad4"),
        "absent": Variant("absent", MPM, "quad4", {}, 1.5),
    }
    done = {"good": rows(2.0), "low": rows(1.4), "control": rows(0.5)}
    outcome = convergence_outcome(done, [Refused(variants["absent"], "not offered")], variants, "control")
    verdicts = {criterion.what.split(",")[0]: criterion.met for criterion in outcome.criteria}
    assert verdicts == {
        "order of good": True, "order of low": False, "order of absent": False, "order of control": True,
    }  # fmt: skip
    assert any("not offered" in criterion.reason for criterion in outcome.criteria)
    ranking = outcome.tables[1]
    assert [row[0] for row in ranking.rows] == ["good", "low", "control"]
    assert ranking.rows[0][2] == pytest.approx(1.0)
    spoilt = convergence_outcome(done | {"control": rows(2.0)}, [], variants, "control")
    assert not spoilt.criteria[-1].met


def test_what_the_program_refuses_is_listed_and_what_crashes_is_not_hidden():
    """Typed errors become refusals; any other error goes on."""
    variants = [Variant("one", FEM, "quad4"), Variant("two", MPM, "quad4")]

    def work(variant):
        if variant.label == "two":
            raise UnsupportedError("not here")
        return 1

    done, refused = attempt(variants, work)
    assert done == {"one": 1} and refused == [Refused(variants[1], "not here")]
    with pytest.raises(ZeroDivisionError):
        attempt(variants, lambda variant: 1 / 0)


def test_numbers_are_shown_to_four_digits():
    """Small and large ones with exponents; words stay; nothing is a dash."""
    assert [shown(x) for x in (1.23456, 1234567, 1.23e-7, "word", None, 0.0)] == [
        "1.235", "1,234,567", "1.23e-07", "word", "–", "0",
    ]  # fmt: skip
    assert criterion_text(Criterion("order", 1.5, low=1.9)) == "order: 1.5 (wanted at least 1.9)"
    assert "not measured: because" in criterion_text(Criterion("order", None, low=1.9, reason="because"))


def test_report_shows_failures_as_failures():
    """The page has every verdict, the table and the figure, escapes words, and needs no other file."""
    pytest.importorskip("matplotlib")
    problem = made(Criterion("good", 1.0, 0.0, 2.0), Criterion("bad", 3.0, 0.0, 2.0))
    page = html_page(report_of([(problem, problem.run(True))], quick=True))
    assert "1 of 2 criteria met" in page and "1 not met" in page
    assert 'class="apart">bad: 3 (wanted 0 to 2)' in page and 'class="agree">good' in page
    assert "For &lt;tests&gt;." in page and "1,234" in page and "<svg" in page and "So." in page
    assert "http" not in page.replace("http://www.w3.org", "")


def test_study_writes_report_and_results(tmp_path, monkeypatch):
    """results.json holds criteria with verdicts, infinite bounds as null; every problem is told as it ends."""
    pytest.importorskip("matplotlib")
    problem = made(Criterion("good", 1.0, low=0.0), Criterion("nothing", math.nan, high=np.float64(1.0)))
    monkeypatch.setattr(study, "find_problem", lambda name, study="verification": problem)
    told = []
    verify(["made"], True, tmp_path / "out", tell=lambda problem, outcome: told.append(problem.name))
    content = json.loads((tmp_path / "out" / "results.json").read_text())
    assert told == ["made"] and (tmp_path / "out" / "report.html").exists()
    criteria = content["problems"][0]["criteria"]
    assert [(each["met"], each["value"], each["high"]) for each in criteria] == [
        (True, 1.0, None),
        (False, None, 1.0),
    ]


@pytest.mark.parametrize("name", PROBLEMS)
def test_every_problem_is_found_under_its_name_and_explains_itself(name):
    """Names of the command line, titles, descriptions and sources."""
    problem = find_problem(name)
    assert problem.name == name and problem.title and problem.description.endswith(".") and problem.source


def test_unknown_problem_has_the_nearest_one_named():
    """As any other wrong name."""
    with pytest.raises(SceneError, match="did you mean 'mms-vortex'"):
        find_problem("mms-vortx")


@pytest.mark.parametrize(("met", "status"), [(True, 0), (False, 1)])
def test_command_tells_by_its_status_whether_all_is_met(met, status, tmp_path, monkeypatch, capsys):
    """0 when every criterion is met, 1 when some is not; the unmet ones are printed."""
    problem = made(Criterion("thing", 1.0 if met else 3.0, 0.0, 2.0))
    monkeypatch.setattr(study, "find_problem", lambda name, study="verification": problem)
    assert main(["study", "verification", "--only", "made", "--out", str(tmp_path / "out")]) == status
    out = capsys.readouterr().out
    assert f"{int(met)} of 1 criteria met" in out and ("not met: thing" in out) is not met


@pytest.mark.parametrize(
    ("arguments", "told"),
    [(["verifikation"], "verification"), (["verification", "--only", "mms-vortx"], "mms-vortex")],
)
def test_command_refuses_unknown_studies_and_problems(arguments, told, capsys, tmp_path, monkeypatch):
    """One line, status 2, nothing written."""
    monkeypatch.chdir(tmp_path)
    assert main(["study", *arguments]) == 2
    captured = capsys.readouterr()
    assert captured.err.count("\n") == 1 and told in captured.err and list(tmp_path.iterdir()) == []


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one processor")
def test_clock_of_a_team_counts_the_thread_that_computes_longest():
    """However few processors are free: its time and not the sum, and the time outside shared work."""

    def burn(seconds):
        began = time.thread_time()
        while time.thread_time() - began < seconds:
            pass

    threads = Threads(2)
    clock = ThreadClock(threads)
    began = clock.read()
    burn(0.01)
    threads.run(lambda first, last: burn(0.01 if first == 0 else 0.03), 4)
    assert 0.04 <= clock.read() - began < 0.05


def test_way_of_a_rigid_block_is_the_integral_of_coulombs_law():
    """Sliding, sticking and coming to rest, against small steps in time."""
    steps = 20_000
    for tangent, speed in CASES.values():
        slope, v, x = np.arctan(tangent), speed, 0.0
        for i in range(steps):
            weight = G * min((i + 0.5) / steps * END / RAMP, 1.0)
            v += (np.sin(slope) - FRICTION * np.cos(slope)) * weight * END / steps
            v = max(v, 0.0)
            x += v * END / steps
        assert exact_way(tangent, speed) == pytest.approx(x, rel=1e-3)
