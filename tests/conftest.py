"""Materials, small bars and solvers that the tests of both methods share."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import settings

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from fem import ExplicitSolver
from meshes.mesh import Mesh
from meshes.taylor_bar import taylor_bar
from mpm import Solver

settings.register_profile("same every time", derandomize=True)
settings.load_profile("same every time")

DENSITY, BULK, SHEAR = 8930.0, 130e9, 43.333e9
CELL = 0.4e-3  # m, size of the square elements and of the cells of every test bar

make_bar = cache(taylor_bar)


@pytest.fixture(autouse=True)
def all_work_is_shared(monkeypatch):
    """Threads share every call, however small: what they give must not depend on it."""
    monkeypatch.setattr("core_models.threads.LEAST_WORK", 0.0)


def hyperelastic(yield_stress: float) -> Material:
    """Copper of the classic benchmark with another yield stress."""
    return Material(
        "copper",
        DENSITY,
        HyperelasticPlastic(),
        IsotropicElastic(BULK, SHEAR),
        NeoHookean(BULK),
        LinearHardening(yield_stress, 0.1e9),
        VonMises(),
    )


@pytest.fixture
def j2():
    """Copper of the classic benchmark: hyperelastic, linear hardening."""
    return hyperelastic(0.4e9)


@pytest.fixture
def elastic():
    """The same laws with a yield stress that is never reached, so that they need no compilation of their own."""
    return hyperelastic(0.95 * SHEAR)


@pytest.fixture
def johnson_cook():
    """Hypoelastic copper with Johnson-Cook flow, Mie-Grueneisen equation of state, heating and melting."""
    return Material(
        "copper-jc",
        DENSITY,
        HypoelasticPlastic(),
        IsotropicElastic(136.35e9, 45.45e9),
        MieGruneisen(DENSITY, 3940.0, 2.02, 1.489),
        JohnsonCook(89.6e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0),
        VonMises(),
        melting=ConstantMelting(1356.0),
        specific_heat=ConstantSpecificHeat(383.0),
        heating=TaylorQuinney(0.9),
    )


@pytest.fixture
def bar():
    """Make a bar of square elements of size CELL: elements across and along, cells between foot and wall."""

    def make(across: int, along: int, gap: float = 0.0) -> Mesh:
        return make_bar(across * CELL, along * CELL, across, along, foot_height=gap * CELL)

    return make


@pytest.fixture
def distorted():
    """Move the nodes of a mesh at random, by up to a part of CELL each way; those on the axis stay on it."""

    def move(mesh: Mesh, part: float, seed: int = 0) -> Mesh:
        shift = np.random.default_rng(seed).uniform(-part, part, mesh.points.shape) * CELL
        shift[mesh.points[:, 0] == 0.0, 0] = 0.0
        return replace(mesh, points=mesh.points + shift)

    return move


@pytest.fixture
def build():
    """Make the solver of a method by name; MPM gets cells of the size of the elements."""

    def make(method: str, mesh: Mesh, material: Material, **options) -> ExplicitSolver | Solver:
        options = {"velocity": 0.0, "wall": "unilateral"} | options
        if method == "mpm":
            return Solver(mesh, material, **({"cell_size": CELL} | options))
        return ExplicitSolver(mesh, material, **options)

    return make
