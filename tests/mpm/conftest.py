"""Bodies and grids that the tests of the material point method share."""

import numpy as np
import pytest

from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.loads import Symmetry
from meshes.block import block
from mpm import Solver
from mpm.grid import FORCE, MASS, RECORD, block_nodes

CELL = 0.4e-3  # m
GEOMETRIES = {"axisymmetric": Axisymmetric(), "plane-strain": PlaneStrain(), "spatial": Spatial()}


class Nodes:
    """What the grid of a solver held in its last step; nodes beyond symmetry planes hold no mass."""

    def __init__(self, solver):
        background = solver._background
        count = background.blocks * block_nodes(background.geometry)
        records = background.grid.nodes.reshape(-1, RECORD)[:count]
        d = solver.positions.shape[1]
        self.mass, self.before = records[:, MASS], records[:, :d]
        self.force = records[:, FORCE : FORCE + d]
        self.after = background.grid.after.reshape(-1, 4)[:count, :d]


@pytest.fixture
def nodes():
    """Read the nodes of a solver."""
    return Nodes


@pytest.fixture
def body(elastic):
    """Make a solver for a block of elastic material of some cells, with its corner at `corner` cells."""

    def make(
        geometry="plane-strain",
        counts=None,
        corner=None,
        kind=None,
        symmetries=(),
        material=elastic,
        **options,
    ):
        d = 3 if geometry == "spatial" else 2
        counts = counts or (5, 6, 4)[:d]
        lower = CELL * np.array(corner or (0.0,) * d)
        mesh = block(lower, lower + CELL * np.array(counts), counts, kind or ("quad4" if d == 2 else "hex8"))
        loads = (*(Symmetry(name) for name in symmetries), *options.pop("loads", ()))
        return Solver(mesh, material, geometry=geometry, loads=loads, **({"cell_size": CELL} | options))

    return make


def stir(solver, seed=0, speed=10.0):
    """Random velocities of the particles, affine ones too."""
    random = np.random.default_rng(seed)
    solver.velocities[:] = random.normal(scale=speed, size=solver.velocities.shape)
    if solver.affine is not None:
        solver.affine[:] = random.normal(scale=speed / CELL, size=solver.affine.shape)
