"""A porous bar that tears: with local porosity the mesh decides when, with nonlocal porosity the material does."""

import numpy as np
import pytest

from core_models.damage.gurson import VoidNucleation
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.flow.linear import LinearHardening
from core_models.loads import Prescribed, Symmetry
from core_models.material import Material
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.gurson import Gurson
from fem import ExplicitSolver
from meshes.block import block
from mpm import Solver

LENGTH = 20e-3  # m
SPEED, END = 20.0, 0.4e-4  # m/s, s
FLAW, HALF_WIDTH, VOIDS = 0.005, 2e-3, 0.005  # more porosity in the middle, over so much [m]; that elsewhere
RADIUS = 5e-3  # m
SOLVERS = {"fem": ExplicitSolver, "mpm": Solver}


def torn(method, elements, radius):
    """Pull the bar at both ends, held at its sides: its stretch when the axial stress has fallen to half its largest,
    and the plastic work per area [J/m^2].
    """
    material = Material(
        "porous", 7850.0, HypoelasticPlastic(), IsotropicElastic(150e9, 70e9), DefaultHypoelastic(150e9),
        LinearHardening(400e6, 400e6), Gurson(1.5, 1.0, 2.25, 4.0, 0.05),
        damage=VoidNucleation(VOIDS, 0.0, 0.3, 0.1), damage_radius=radius,
    )  # fmt: skip
    size = LENGTH / elements
    options = {
        "geometry": "plane-strain",
        "velocity": lambda x: np.column_stack([SPEED * (2.0 * x[:, 0] / LENGTH - 1.0), 0.0 * x[:, 0]]),
        "loads": (
            Prescribed("left", 0, -SPEED),
            Prescribed("right", 0, SPEED),
            Symmetry("bottom"),
            Symmetry("top"),
        ),
    }
    if method == "mpm":
        options |= {"cell_size": size, "configuration": "total"}
    solver = SOLVERS[method](block((0.0, 0.0), (LENGTH, size), (elements, 1), "quad4"), material, **options)
    away = (solver.reference_positions[:, 0] - 0.5 * LENGTH) / HALF_WIDTH
    solver.points.old.porosity[:] += FLAW * np.exp(-(away**2))
    history = []
    while solver.time < END:
        solver.advance(END)
        middle = np.abs(away) < 1.0
        history.append((2.0 * SPEED * solver.time / LENGTH, solver.points.old.stress[middle, 0].mean()))
    stretch, stress = np.array(history).T
    peak = stress.argmax()
    fallen = peak + np.argmax(stress[peak:] < 0.5 * stress[peak])
    return stretch[fallen], solver.ledger.plastic / size


@pytest.fixture(scope="module")
def outcome():
    """Stretch at the drop of the load and plastic work, by method, resolution and radius."""
    cases = [(method, n, radius) for method in SOLVERS for n in (20, 40) for radius in (RADIUS, None)]
    return {case: torn(*case) for case in cases}


@pytest.mark.parametrize("method", SOLVERS)
@pytest.mark.parametrize("number", [0, 1], ids=["stretch", "work"])
def test_when_a_porous_bar_tears_does_not_depend_on_the_mesh(outcome, method, number):
    """Halving the elements moves load drop and work by 9 % at most; with local porosity by three times as much."""
    nonlocal_gap, local_gap = (
        abs(outcome[method, 40, radius][number] / outcome[method, 20, radius][number] - 1.0)
        for radius in (RADIUS, None)
    )
    assert nonlocal_gap < 0.09 and local_gap > 0.18
    assert local_gap > 2.9 * nonlocal_gap


def test_both_methods_tear_the_porous_bar_alike(outcome):
    """Finite elements and particles agree on stretch and work with nonlocal porosity."""
    assert outcome["mpm", 40, RADIUS] == pytest.approx(outcome["fem", 40, RADIUS], rel=0.02)
