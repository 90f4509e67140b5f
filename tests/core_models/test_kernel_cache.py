"""Compiled kernels on disk: an edited law never runs its old machine code; plain Python gives the same numbers.

Each run is a process of its own, on a copy of the package that the test may edit, with a cache folder of its own.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import core_models
from core_models.driver import drive
from core_models.paths import simple_shear

PROBE = '''
import numpy as np

from core_models.compilation import material_kernel
from core_models.laws import pressure


@material_kernel
def probe(law, out):
    """The pressure of a law: a kernel that compiles at once."""
    out[0] = pressure(law, 0.9, 0.0)[0]


def report(law):
    """Print the pressure, and how often the kernel was found and was not found on the disk."""
    out = np.zeros(1)
    probe(law, out)
    print(repr(float(out[0])), sum(probe.stats.cache_hits.values()), sum(probe.stats.cache_misses.values()))
'''
BUILT_IN = """
from core_models.eos.neo_hookean import NeoHookean
from core_models.probe import report
report(NeoHookean(136e9))
"""
OWN = """
import sys
from core_models import user_laws
law = user_laws.load(sys.argv[1]).OwnLaw(136e9)
from core_models.probe import report
report(law)
"""
OWN_AFTER = """
import sys
from core_models.probe import report
from core_models import user_laws
report(user_laws.load(sys.argv[1]).OwnLaw(136e9))
"""
LAW_FILE = '''
from typing import NamedTuple

from core_models.laws import is_beyond_eos, pressure


class OwnLaw(NamedTuple):
    """A pressure proportional to the change of volume."""

    bulk_modulus: float


@pressure.register(OwnLaw)
def _(eos, volume_ratio, energy):
    return 1.0 * eos.bulk_modulus * (volume_ratio - 1.0), eos.bulk_modulus, 0.0


@is_beyond_eos.register(OwnLaw)
def _(eos, volume_ratio):
    return False
'''


@pytest.fixture
def run(tmp_path):
    """Run a script against a copy of the package; returns the pressure, cache hits and misses of the probe."""
    shutil.copytree(
        Path(core_models.__file__).parent, tmp_path / "core_models", ignore=shutil.ignore_patterns("__pyc*")
    )
    (tmp_path / "core_models/probe.py").write_text(PROBE)

    def script(text, *arguments):
        environment = os.environ | {"PYTHONPATH": str(tmp_path), "NUMBA_CACHE_DIR": str(tmp_path / "cache")}
        command = [sys.executable, "-c", text, *arguments]
        done = subprocess.run(
            command, cwd=tmp_path, env=environment, check=True, capture_output=True, text=True
        )
        found, hits, misses = done.stdout.split()
        return float(found), int(hits), int(misses)

    return script


def edit(path, old, new):
    """Replace the one place where a text stands in a file."""
    text = path.read_text()
    assert text.count(old) == 1
    path.write_text(text.replace(old, new))


def test_an_edited_law_never_runs_its_old_machine_code(run, tmp_path):
    """After an edit of a built-in law the next process computes with it; unedited, it starts from the disk."""
    before, hits, misses = run(BUILT_IN)
    assert (hits, misses) == (0, 1)
    assert run(BUILT_IN) == (before, 1, 0)
    edit(tmp_path / "core_models/eos/neo_hookean.py", "= 0.5 * eos.bulk_modulus", "= 1.0 * eos.bulk_modulus")
    after, hits, misses = run(BUILT_IN)
    assert (hits, misses) == (0, 1)
    assert after == pytest.approx(2.0 * before, rel=1e-12)


@pytest.mark.parametrize("script", [OWN, OWN_AFTER], ids=["law first", "kernel first"])
def test_an_edited_law_of_the_users_own_file_never_runs_its_old_machine_code(run, tmp_path, script):
    """The same for a law in a file outside the package, loaded before the kernel's module or after it."""
    law = tmp_path / "own_law.py"
    law.write_text(LAW_FILE)
    before, hits, misses = run(script, str(law))
    assert before == pytest.approx(-13.6e9)
    assert (hits, misses) == (0, 1)
    assert run(script, str(law)) == (before, 1, 0)
    edit(law, "return 1.0 *", "return 2.0 *")
    after, hits, misses = run(script, str(law))
    assert (hits, misses) == (0, 1)
    assert after == pytest.approx(2.0 * before, rel=1e-12)


PLAIN = """
import importlib.util, sys
import numpy as np
from core_models.driver import drive
from core_models.paths import simple_shear
specification = importlib.util.spec_from_file_location("pool", sys.argv[1])
pool = importlib.util.module_from_spec(specification)
specification.loader.exec_module(pool)
for update, flow in (("hypo", "jc"), ("hyper", "mts")):
    material = pool.hot_copper.__wrapped__(pool.copper.__wrapped__())(update, flow)
    history = drive(material, simple_shear(np.linspace(0.0, 0.2, 21)), 1e-7)
    print(*(repr(float(x)) for x in [*history.stress[-1], history.plastic[-1], history.fields["temperature"][-1]]))
"""


def test_plain_python_gives_the_same_numbers(hot_copper):
    """The laws run without the compiler too, for debugging, and agree to round-off."""
    environment = os.environ | {"NUMBA_DISABLE_JIT": "1"}
    command = [sys.executable, "-c", PLAIN, str(Path(__file__).parent / "conftest.py")]
    root = Path(core_models.__file__).parent.parent
    done = subprocess.run(command, cwd=root, env=environment, check=True, capture_output=True, text=True)
    for line, (update, flow) in zip(
        done.stdout.splitlines(), (("hypo", "jc"), ("hyper", "mts")), strict=True
    ):
        history = drive(hot_copper(update, flow), simple_shear(np.linspace(0.0, 0.2, 21)), 1e-7)
        compiled = [*history.stress[-1], history.plastic[-1], history.fields["temperature"][-1]]
        scale = [np.abs(history.stress[-1]).max()] * 6 + compiled[6:]
        plain = [float(word) for word in line.split()]
        assert np.abs(np.subtract(plain, compiled) / scale).max() < 1e-13
