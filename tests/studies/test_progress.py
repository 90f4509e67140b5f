"""The progress bar."""

import io
from types import SimpleNamespace

import pytest

from studies.observers import progress
from studies.runs import remaining
from studies.runs.remaining import Remaining


def set_clock(monkeypatch):
    """A clock at 0 s that stands until it is set."""
    clock = {"now": 0.0}
    for module in (progress, remaining):
        monkeypatch.setattr(module.time, "monotonic", lambda: clock["now"])
    return clock


def test_the_bar_shows_share_and_time_left_and_wipes_itself(monkeypatch):
    """Half way after 10 s there are 10 s left; at the end the line is empty."""
    clock = set_clock(monkeypatch)
    stream = io.StringIO()
    ending = SimpleNamespace(expected=lambda solver: 80e-6)
    bar = progress.Progress("mpm 8", ending, Remaining([("mpm", 8)]), stream)
    bar.start(SimpleNamespace(time=0.0))
    clock["now"] = 10.0
    bar.step(SimpleNamespace(time=40e-6))
    assert " 50%" in stream.getvalue() and "0:10 left" in stream.getvalue()
    bar.finish(SimpleNamespace(time=80e-6))
    assert stream.getvalue().endswith("\r\x1b[K")


def test_a_terminal_that_cannot_rewrite_gets_no_bar(monkeypatch):
    """TERM=dumb means no escape codes."""
    terminal = SimpleNamespace(isatty=lambda: True)
    monkeypatch.setenv("TERM", "dumb")
    assert not progress.can_show(terminal)
    monkeypatch.setenv("TERM", "xterm")
    assert progress.can_show(terminal)


def test_the_bar_fits_the_terminal(monkeypatch):
    """A line that wraps could not be rewritten."""
    monkeypatch.setattr(progress, "columns", lambda stream: 20)
    stream = io.StringIO()
    one = Remaining([("mpm", 8)])
    progress.Progress("a-rather-long-method-name 8", None, one, stream).start(SimpleNamespace(time=0.0))
    assert len(stream.getvalue().removeprefix("\r\x1b[K")) == 19


def test_a_comparison_shows_what_all_its_runs_still_take(monkeypatch):
    """Work goes with the cube of the resolution, at the pace of the method, or of the other while it has none."""
    clock = set_clock(monkeypatch)
    plan = Remaining([("fem-explicit", 8), ("fem-explicit", 16), ("mpm", 8), ("mpm:spatial", 8)])
    stream = io.StringIO()
    bar = progress.Progress("fem-explicit 8", SimpleNamespace(expected=lambda solver: 80e-6), plan, stream)
    bar.start(SimpleNamespace(time=0.0))
    clock["now"] = 5.0
    bar.step(SimpleNamespace(time=40e-6))
    assert "1/4 fem-explicit 8" in stream.getvalue() and "0:05 left, all 2:55" in stream.getvalue()
    clock["now"] = 10.0
    plan.end(made=True)
    plan.begin()
    clock["now"] = 50.0
    assert plan.left(0.5) == pytest.approx((40.0, 40.0 + 10.0 + 80.0))
    plan.end(made=False)
    plan.begin()
    clock["now"] = 52.0
    assert plan.place == "3/4" and plan.left(1.0) == pytest.approx((0.0, 8.0 * 0.5 * (10.0 + 2.0)))
