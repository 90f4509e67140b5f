"""Solvers of sparse linear systems: each gives the same answer, alone and on several processes."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

from core_models.equilibrium import linear_solvers
from core_models.equilibrium.linear_solvers import LINEAR_SOLVERS, make_linear_solver
from core_models.equilibrium.pattern import Pattern
from core_models.errors import UnsupportedError
from core_models.threads import Threads

MODULES = {"pardiso": "pypardiso", "petsc": "petsc4py"}

ON_EVERY_PROCESS = """
import petsc4py
petsc4py.init()
from petsc4py import PETSc
import numpy as np
from core_models.equilibrium.linear_solvers import make_linear_solver
from core_models.equilibrium.pattern import Pattern
from core_models.threads import Threads
blocks = np.array([[2.0, -1.0], [-1.5, 3.0]]) * np.arange(1.0, 10.0)[:, None, None]
nodes = np.column_stack([np.arange(9), np.arange(1, 10)])
pattern = Pattern([nodes], np.arange(10) > 0, Threads(1))
solver = make_linear_solver("petsc", pattern)
found = solver.solve(pattern.assemble([blocks]), np.arange(9.0))
PETSc.Sys.syncPrint(PETSc.COMM_WORLD.size, *[each.hex() for each in found])
PETSc.Sys.syncFlush()
"""


def chain(count=10, seed=0):
    """A pattern of blocks in a row, blocks whose numbers are not symmetric, and the dense matrix of the free ones."""
    rng = np.random.default_rng(seed)
    nodes = np.column_stack([np.arange(count - 1), np.arange(1, count)])
    free = np.ones(count, dtype=bool)
    free[0] = False
    blocks = rng.uniform(-1.0, 1.0, (count - 1, 2, 2)) + 4.0 * np.eye(2)
    dense = np.zeros((count, count))
    for pair, block in zip(nodes, blocks, strict=True):
        dense[np.ix_(pair, pair)] += block
    return Pattern([nodes], free, Threads(1)), blocks, dense[1:, 1:]


@pytest.mark.parametrize("name", LINEAR_SOLVERS)
def test_solvers_agree_with_dense_elimination(name):
    """For one right-hand side and for several, and for other numbers in the same pattern."""
    if name in MODULES:
        pytest.importorskip(MODULES[name])
    pattern, blocks, dense = chain()
    solver = make_linear_solver(name, pattern)
    right = np.random.default_rng(1).normal(size=(9, 2))
    for factor in (1.0, -3.0):
        values = pattern.assemble([factor * blocks])
        expected = np.linalg.solve(factor * dense, right)
        assert solver.solve(values, right) == pytest.approx(expected, rel=1e-12, abs=1e-14)
        assert solver.solve(values, right[:, 0]) == pytest.approx(expected[:, 0], rel=1e-12, abs=1e-14)


@pytest.mark.parametrize(("name", "extra"), [("pardiso", "'solvers'"), ("petsc", "'hpc'")])
def test_what_is_not_installed_is_refused_with_the_extra_to_install(monkeypatch, name, extra):
    """The message names the extra, and what works without it."""
    monkeypatch.setattr(linear_solvers, "find_spec", lambda module: None)
    with pytest.raises(UnsupportedError, match=rf"extra {extra}.*or use linear_solver='scipy'"):
        make_linear_solver(name, chain()[0])


def test_processes_share_a_system_and_all_have_its_solution():
    """Under mpirun two processes with half of the rows each get what one gets, the same to the last bit."""
    pytest.importorskip("petsc4py")
    if shutil.which("mpirun") is None:
        pytest.skip("mpirun is not installed")
    allow = ("--allow-run-as-root", "--oversubscribe")
    command = ["mpirun", *allow, "-n", "2", sys.executable, "-c", ON_EVERY_PROCESS]
    # Without what MPI may have put into this process's own environment.
    ended = subprocess.run(command, capture_output=True, text=True, timeout=120, env=dict(os.environ))
    assert ended.returncode == 0, ended.stderr
    # What mpirun makes of a terminal's colours may stand in front of a line.
    lines = [line.split() for line in re.findall(r"2((?: -?0x[0-9a-fp.+-]+){9})", ended.stdout)]
    assert len(lines) == 2 and lines[0] == lines[1]
    dense = np.zeros((10, 10))
    for i in range(9):
        dense[i : i + 2, i : i + 2] += (i + 1.0) * np.array([[2.0, -1.0], [-1.5, 3.0]])
    expected = np.linalg.solve(dense[1:, 1:], np.arange(9.0))
    assert np.array([float.fromhex(each) for each in lines[0]]) == pytest.approx(expected, rel=1e-12)
