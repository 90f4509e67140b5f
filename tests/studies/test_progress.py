"""The progress bar."""

import io
from types import SimpleNamespace

from studies import progress


def test_the_bar_shows_share_and_time_left_and_wipes_itself(monkeypatch):
    """Half way after 10 s there are 10 s left; at the end the line is empty."""
    clock = iter([0.0, 10.0])
    monkeypatch.setattr(progress.time, "monotonic", lambda: next(clock))
    stream = io.StringIO()
    bar = progress.Progress("mpm 8", SimpleNamespace(expected=lambda solver: 80e-6), stream)
    bar.start(SimpleNamespace(time=0.0))
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
    progress.Progress("a-rather-long-method-name 8", None, stream).start(SimpleNamespace(time=0.0))
    assert len(stream.getvalue().removeprefix("\r\x1b[K")) == 19
