"""A bar that softens: with local damage the mesh decides what it dissipates, with nonlocal damage the material does."""

import numpy as np
import pytest

from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.flow.johnson_cook import JohnsonCook
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.loads import Prescribed
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from fem import ExplicitSolver
from meshes.block import block
from mpm import Solver

LENGTH, WIDTH = 20e-3, 2e-3  # m
SPEED, END = 20.0, 1.6e-5  # m/s, s
WEAK, FLAW = 1e-3, 0.1  # half length of the flawed middle [m], its damage at the start
RADIUS = 4e-3  # m


def dissipated(method, elements, radius):
    """Plastic work [J] of the bar, pulled at both ends until it has failed in the middle."""
    material = Material(
        "softening",
        8930.0,
        HypoelasticPlastic(),
        IsotropicElastic(136.35e9, 45.45e9),
        MieGruneisen(8930.0, 3940.0, 2.02, 1.489),
        JohnsonCook(400e6, 0.0, 0.0, 1.0, 1.0, 1.0, 294.0, 1356.0),
        VonMises(),
        damage=JohnsonCookDamage(0.2, 0.0, 0.0, 0.0, 0.0, 294.0, 1356.0, coupling=0.9),
        melting=ConstantMelting(1356.0),
        specific_heat=ConstantSpecificHeat(383.0),
        heating=TaylorQuinney(0.9),
        damage_radius=radius,
    )
    mesh = block((0.0, 0.0), (LENGTH, WIDTH), (elements, elements // 10), "quad4")
    options = {
        "geometry": "plane-strain",
        "velocity": lambda x: np.column_stack([SPEED * (2.0 * x[:, 0] / LENGTH - 1.0), 0.0 * x[:, 0]]),
        "loads": (Prescribed("left", 0, -SPEED), Prescribed("right", 0, SPEED)),
    }
    if method == "mpm":
        options |= {"cell_size": LENGTH / elements, "configuration": "total"}
    solver = (Solver if method == "mpm" else ExplicitSolver)(mesh, material, **options)
    is_weak = np.abs(solver.reference_positions[:, 0] - 0.5 * LENGTH) < WEAK
    solver.points.old.damage[is_weak] = FLAW
    while solver.time < END:
        solver.advance(END)
    return solver.ledger.plastic


@pytest.fixture(scope="module")
def work():
    """Plastic work by method, resolution and radius."""
    cases = [(method, n, radius) for method in ("fem", "mpm") for n in (20, 40) for radius in (RADIUS, None)]
    return {case: dissipated(*case) for case in cases}


@pytest.mark.parametrize("method", ["fem", "mpm"])
def test_the_work_of_nonlocal_damage_does_not_depend_on_the_mesh(work, method):
    """Halving the elements changes it by a few per cent; with local damage by more than three times as much."""
    nonlocal_gap = abs(work[method, 40, RADIUS] / work[method, 20, RADIUS] - 1.0)
    local_gap = abs(work[method, 40, None] / work[method, 20, None] - 1.0)
    assert nonlocal_gap < 0.06 and local_gap > 0.14
    assert local_gap > 3.0 * nonlocal_gap


def test_both_methods_find_the_same_work(work):
    """Finite elements and particles differ by less with nonlocal damage than with local damage."""
    assert work["mpm", 40, RADIUS] == pytest.approx(work["fem", 40, RADIUS], rel=0.03)
    assert abs(work["mpm", 40, None] / work["fem", 40, None] - 1.0) > 0.06
