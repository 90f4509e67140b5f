"""Results in a notebook."""

import pytest

from studies.comparisons.comparing import compare
from studies.runs.running import simulate
from tests.studies.browser import open_page
from tests.studies.test_report_page import small_report

pytest.importorskip("matplotlib")


def test_results_show_themselves_richly_and_leave_the_notebook_alone(fake_solvers, classic, tmp_path):
    """Runs, comparisons and reports give tables and figures; their style stays inside, and nothing is a script."""
    run = simulate(classic, "mpm", 8, wall="plane")._repr_html_()
    comparison = compare(classic, resolutions=(8,), wall="plane")._repr_html_()
    for text, told in ((run, "mpm 8"), (comparison, "In short"), (small_report()._repr_html_(), "Second")):
        assert told in text and "<table>" in text and "<script" not in text
    assert "final length" in run and run.count("<svg") >= 4
    page = f"<!doctype html><head></head><body><p id='own'>mine</p>{run}{comparison}</body>"
    check = "const s = getComputedStyle(document.body); return [s.backgroundColor, s.padding];"
    seen = open_page(page, tmp_path, check)
    assert seen["found"] == ["rgba(0, 0, 0, 0)", "0px"] and seen["errors"] == [] and seen["log"] == []


def test_a_run_that_went_wrong_says_so(fake_solvers, classic):
    """The message is shown, without quantities."""
    assert "point 1" in simulate(classic, "mpm", 13)._repr_html_()


def test_without_matplotlib_a_hint_is_shown(fake_solvers, classic, monkeypatch):
    """What to install."""
    run = simulate(classic, "mpm", 8)
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    assert "matpoint[report]" in run._repr_html_()
