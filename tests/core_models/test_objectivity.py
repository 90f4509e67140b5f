"""What an observer who turns sees: the stress turned, and nothing else changed."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core_models.driver import drive
from core_models.paths import rotations, simple_shear, turned

FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]
PLASTIC = ["hypo-linear", "hyper-linear", "hypo-jc-hot", "hyper-jc-hot", "hyper-mts-hot"]


def wild_path(steps, size, seed=1):
    """A path of random increments with a random strain and spin in each."""
    random = np.random.default_rng(seed)
    path = [np.eye(3)]
    for _ in range(steps):
        path.append((np.eye(3) + random.uniform(-size, size, (3, 3))) @ path[-1])
    return np.array(path)


def tensors(stress):
    """Stresses (k, 6) as (k, 3, 3)."""
    return stress[:, FULL]


@pytest.mark.parametrize("name", PLASTIC)
def test_a_turned_path_turns_the_stress_and_nothing_else(pool, name):
    """With an arbitrary large rotation on top of every step, stress is Q s Q^T and every scalar is the same."""
    path = wild_path(60, 0.05)
    spin = Rotation.random(len(path), rng=np.random.default_rng(2)).as_matrix()
    spin[0] = np.eye(3)
    still = drive(pool[name], path, 1e-6)
    moving = drive(pool[name], turned(path, spin), 1e-6)
    assert still.fields["equivalent_plastic_strain"][-1] > 0.5
    expected = spin @ tensors(still.stress) @ spin.transpose(0, 2, 1)
    assert tensors(moving.stress) == pytest.approx(expected, abs=1e-11 * np.abs(expected).max())
    for field in (
        "equivalent_plastic_strain",
        "temperature",
        "hardening_variable",
        "damage",
        "internal_energy",
    ):
        if field in still.fields:
            scale = np.abs(still.fields[field]).max()
            assert moving.fields[field] == pytest.approx(still.fields[field], abs=1e-11 * scale)
    assert moving.plastic == pytest.approx(still.plastic, rel=1e-11)
    assert moving.stress_work == pytest.approx(still.stress_work, abs=1e-11 * np.abs(still.stress_work).max())


@pytest.mark.parametrize("name", ["hypo-linear", "hyper-linear"])
@pytest.mark.parametrize("degrees", [7.3, 88.0, 151.0])
def test_a_thousand_turns_do_no_work(pool, name, degrees):
    """A stressed point that spins 1,000 times about a skew axis keeps its principal stresses; nothing yields."""
    sheared = simple_shear([0.0, 0.02, 0.019])
    steps = round(360_000 / degrees) if degrees > 80.0 else 5000
    spin = rotations([1.0, 2.0, -0.7], np.radians(degrees) * np.arange(1, steps + 1))
    path = np.vstack([sheared, spin @ sheared[-1]])
    history = drive(pool[name], path, 1e-6)
    before, after = (np.linalg.eigvalsh(tensors(history.stress)[row]) for row in (2, -1))
    assert after == pytest.approx(before, rel=1e-9, abs=1e-9 * np.abs(before).max())
    expected = spin[-1] @ tensors(history.stress)[2] @ spin[-1].T
    assert tensors(history.stress)[-1] == pytest.approx(expected, abs=1e-9 * np.abs(before).max())
    assert history.plastic[-1] == history.plastic[2]
    assert history.stress_work[-1] == pytest.approx(history.stress_work[2], rel=1e-7)


@pytest.mark.parametrize("name", PLASTIC)
def test_mirrored_and_permuted_axes_change_nothing(pool, name):
    """An isotropic material knows no axes: a path seen in permuted axes gives the stress in those axes."""
    path = wild_path(20, 0.05, seed=3)
    swap = np.eye(3)[[2, 0, 1]]
    still, permuted = (drive(pool[name], p, 1e-6) for p in (path, swap @ path @ swap.T))
    expected = swap @ tensors(still.stress) @ swap.T
    assert tensors(permuted.stress) == pytest.approx(expected, abs=1e-11 * np.abs(expected).max())
