"""Progress of studies of many runs."""

import io

from studies.output import tally


def test_each_run_is_counted_with_the_time_left(monkeypatch):
    """One of four runs after 10 s leaves 30 s; long messages are cut."""
    clock = iter([0.0, 10.0, 20.0])
    monkeypatch.setattr(tally.time, "monotonic", lambda: next(clock))
    stream = io.StringIO()
    counted = tally.Tally(4, stream)
    counted.tell("mpm 8: 1.2 s")
    counted.tell("x" * 200)
    first, second = stream.getvalue().splitlines()
    assert first == "[1/4, 0:30 left] mpm 8: 1.2 s"
    assert second.startswith("[2/4, 0:20 left] xxx") and second.endswith("x…") and len(second) < 140
