"""The watch for numerical fracture tells once, and a resumed run knows what had been told."""

import logging
from types import SimpleNamespace

from mpm.fracture import Fracture
from studies.observers.fracture_watch import EVERY, FractureWatch


def solver(step, fracture):
    """What the watch sees of a solver."""
    return SimpleNamespace(step_count=step, time=1e-6 * step, numerical_fracture=lambda: fracture)


def test_it_tells_once_with_time_number_place_and_stretch(caplog):
    """One line in the log, of the first finding; steps between looks cost nothing."""
    watch = FractureWatch()
    with caplog.at_level(logging.WARNING):
        watch.step(SimpleNamespace(step_count=1))
        watch.step(solver(EVERY, None))
        assert watch.found is None
        watch.step(solver(2 * EVERY, Fracture(3, (1e-3, 2e-3), 4.2)))
        watch.step(solver(3 * EVERY, Fracture(9, (5e-3, 2e-3), 7.0)))
    assert len(caplog.messages) == 1
    assert all(
        text in caplog.messages[0] for text in ("3 pairs", "1.0000e-04 s", "(0.001, 0.002) m", "4.2 times")
    )
    again = FractureWatch()
    again.resume(None, watch.checkpoint())
    assert again.found == watch.found
    again.resume(None, FractureWatch().checkpoint())


def test_solvers_that_cannot_tear_are_left_alone():
    """Finite elements have nothing to look at."""
    watch = FractureWatch()
    watch.finish(SimpleNamespace(step_count=EVERY))
    assert watch.found is None
