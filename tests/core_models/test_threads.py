"""Threads change nothing but the time."""

import os
import time

import numpy as np
import pytest

from core_models.errors import SceneError
from core_models.points import MaterialPoints
from core_models.threads import Threads


def advanced(material, count):
    """Points after ten wild steps on some threads, and the work of each step."""
    random = np.random.default_rng(4)
    points = MaterialPoints(material, random.uniform(0.5, 2.0, 2345), threads=Threads(count))
    works = []
    for _ in range(10):
        shape = (points.n, 3, 3)
        points.deformation_gradient[:] = (
            np.eye(3) + random.uniform(-0.02, 0.02, shape)
        ) @ points.old_deformation_gradient
        works.append(points.advance(1e-6))
        points.accept()
    return points, works


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="needs two processors")
@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-mts-hot"])
def test_two_threads_give_the_same_bits(pool, name):
    """States, wave speeds and the sums over all points are bitwise equal with one and two threads."""
    (one, works), (two, works_of_two) = advanced(pool[name], 1), advanced(pool[name], 2)
    assert works == works_of_two
    assert np.array_equal(one.wave_speed, two.wave_speed)
    for name, field in one.fields().items():
        assert np.array_equal(field.array, two.fields()[name].array), name


def test_two_runs_give_the_same_bits(pool):
    """Nothing depends on the run."""
    (one, works), (two, works_of_two) = (advanced(pool["hypo-jc-hot"], 1) for _ in range(2))
    assert works == works_of_two
    assert all(np.array_equal(field.array, two.fields()[name].array) for name, field in one.fields().items())


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="needs two processors")
@pytest.mark.parametrize("seconds, shares", [(1e-4, 1), (1e-2, 2)])
def test_only_work_that_takes_long_enough_is_shared(seconds, shares, monkeypatch):
    """The first call may compile and tells nothing; afterwards short calls stay on one thread, long ones are split."""
    monkeypatch.setattr("core_models.threads.LEAST_WORK", 2e-3)
    seen = []

    def kernel(first, last):
        seen.append((first, last))
        time.sleep(0.02 if len(seen) == 1 else seconds * (last - first) / 8)

    threads = Threads(2)
    for _ in range(4):
        threads.run(kernel, 8)
    assert seen[:2] == [(0, 8), (0, 8)]
    assert sorted(seen[2:]) == ([(0, 8)] * 2 if shares == 1 else [(0, 4), (0, 4), (4, 8), (4, 8)])


@pytest.mark.parametrize("count", [0, -1, 10**6])
def test_impossible_thread_counts_are_refused(count):
    """The error names what this machine has."""
    with pytest.raises(SceneError, match="give a number from 1 to"):
        Threads(count)
