"""Dynamic relaxation: both explicit methods come to rest in the static state."""

import math

import numpy as np
import pytest

from core_models.errors import RunFailure, SingularStiffness
from core_models.loads import BodyForce, Symmetry, gravity
from fem import ExplicitSolver
from meshes.block import block
from mpm import Solver
from studies.methods.dynamic_relaxation import relaxed
from studies.methods.quasi_static import KineticWatch
from studies.necking.reader import read_necking_scene

CELLS = 8
STEEL = read_necking_scene("necking-simo").material
MODULUS = STEEL.elasticity.bulk_modulus + 4.0 / 3.0 * STEEL.elasticity.shear_modulus
WEIGHT = 5e-4  # density times acceleration times length, over the modulus
MESH = block((0.0, 0.0), (1.0 / CELLS, 1.0), (1, CELLS))
LOADS = (
    Symmetry("bottom"),
    Symmetry("left"),
    Symmetry("right"),
    gravity([0.0, -WEIGHT * MODULUS / STEEL.density]),
)


def make(method, loads):
    """A column that stands on its foot between two smooth walls."""
    if method == "mpm":
        return Solver(MESH, STEEL, cell_size=1.0 / CELLS, geometry="plane-strain", loads=loads)
    return ExplicitSolver(MESH, STEEL, geometry="plane-strain", loads=loads)


@pytest.mark.parametrize("method", ["fem-explicit", "mpm"])
def test_column_rests_under_its_weight(method):
    """Top at - weight L / 2 M and stress - weight (1 - y / L), as in the closed form; loaded at once it moves on."""
    solver = relaxed(MESH, STEEL, LOADS, lambda loads: make(method, loads), "plane-strain")
    top = solver.boundary_positions("top")[:, 1].mean() - 1.0
    assert top == pytest.approx(-0.5 * WEIGHT, rel=0.01)
    places = solver.reference_positions[:, 1]
    mean = 0.5 / CELLS / math.sqrt(3.0)
    inside = np.abs(places - 0.5) < 0.4
    stress = solver.points.old.stress[inside, 1] / MODULUS
    assert stress == pytest.approx(-WEIGHT * (1.0 - places[inside]), abs=1.1 * WEIGHT * mean)
    periods = solver.time * math.sqrt(MODULUS / STEEL.density) / 4.0
    assert 1.0 < periods < 4.0


@pytest.mark.parametrize("method", ["fem-explicit", "mpm"])
def test_column_that_swings_is_not_called_quasi_static(method):
    """Without damping the ledger's share of kinetic energy is told, and refused."""
    solver = make(method, LOADS)
    watch = KineticWatch(1e-5)
    while solver.time < 2e-4:
        solver.advance(2e-4)
        watch.look(solver)
    assert watch.share > 0.1
    with pytest.raises(RunFailure, match="the run is not quasi-static"):
        watch.check()


def test_body_that_does_not_rest_is_told():
    """A load that comes and goes, and a body that nothing holds."""
    rate = 0.5 * math.pi * math.sqrt(MODULUS / STEEL.density)
    swinging = BodyForce(lambda x, t: [0.0, -WEIGHT * MODULUS / STEEL.density * math.sin(rate * t)])
    with pytest.raises(RunFailure, match="does not come to rest within 20 periods"):
        relaxed(
            MESH, STEEL, (*LOADS[:3], swinging), lambda loads: make("fem-explicit", loads), "plane-strain"
        )
    with pytest.raises(SingularStiffness, match="translation along y"):
        relaxed(MESH, STEEL, LOADS[1:], lambda loads: make("fem-explicit", loads), "plane-strain")
