"""Numerical fracture: reported where it can happen, when it happens, and only there."""

import numpy as np
import pytest

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.linear import LinearHardening
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from meshes.block import block
from meshes.kinds import KINDS
from mpm.fracture import neighbours
from mpm.particles import domain_corners
from tests.mpm.conftest import CELL

RATE, END = 1e5, 4.2  # 1/s, and the stretch at the end
GAUSS = np.sqrt(1.0 / 3.0)  # cells between two particles of a cell


@pytest.fixture
def drawn(body):
    """Draw a bar of soft material, which offers no resistance, until it tears or is `END` times as long."""
    laws = IsotropicElastic(10.0, 5.0), NeoHookean(10.0), LinearHardening(4.0, 1.0), VonMises()
    jelly = Material("jelly", 1000.0, HyperelasticPlastic(), *laws)

    def draw(**options):
        solver = body(material=jelly, velocity=lambda x: RATE * x * [1.0, 0.0], cfl=0.05, **options)
        while RATE * solver.time < END - 1.0:
            solver.advance()
            fracture = solver.numerical_fracture()
            if fracture is not None:
                return solver, fracture
        return solver, None

    return draw


@pytest.mark.parametrize(("interpolation", "support"), [("quadratic", 1.5), ("gimp", 1.25)])
def test_a_drawn_bar_tears_when_neighbours_share_no_node(drawn, interpolation, support):
    """Told with number, place and stretch, about the bar's; no earlier than nodes may lack, no later than they must."""
    solver, fracture = drawn(interpolation=interpolation)
    elongation = np.ptp(solver.positions[:, 0]) / np.ptp(solver.reference_positions[:, 0])
    assert fracture.stretch == pytest.approx(elongation, rel=0.1)
    assert 2.0 * support - 1.0 < GAUSS * fracture.stretch < 2.0 * support
    assert 0 < fracture.pairs < len(neighbours(domain_corners(solver.mesh)))
    low, high = solver.positions.min(axis=0), solver.positions.max(axis=0)
    assert (low <= fracture.position).all()
    assert (fracture.position <= high).all()


@pytest.mark.parametrize(
    "options", [{"configuration": "total"}, {"interpolation": "cpdi"}], ids=["total", "cpdi"]
)
def test_nothing_is_told_where_the_body_holds_together(drawn, options):
    """Neither of the reference body's grid nor of convected domains, at the same length and more."""
    solver, fracture = drawn(**options)
    assert fracture is None
    assert np.ptp(solver.positions[:, 0]) > 0.99 * END * np.ptp(solver.reference_positions[:, 0])


def test_failed_particles_may_part(drawn):
    """Pairs of which one has failed are no longer expected to hold together."""
    solver, fracture = drawn()
    solver.points.old = solver.points.old._replace(damage=np.ones(solver.points.n))
    assert solver.numerical_fracture() is None


@pytest.mark.parametrize("kind", ["quad4", "quad8", "hex8", "tri3"])
def test_neighbours_are_those_with_a_face_in_common(kind):
    """As many pairs as inner faces of the domains, on a distorted mesh too."""
    d = KINDS[kind].dimension
    counts = np.array([5, 4, 3])[:d]
    mesh = block([0.0] * d, CELL * counts, counts, kind, distortion=0.1)
    corners = domain_corners(mesh)
    pairs = neighbours(corners)
    assert len(np.unique(np.sort(pairs, axis=1), axis=0)) == len(pairs)
    if kind in ("quad4", "hex8"):
        along = 2 * counts
        assert len(pairs) == sum((along[axis] - 1) * along.prod() // along[axis] for axis in range(d))
    middles = corners.mean(axis=1)
    assert np.linalg.norm(np.diff(middles[pairs], axis=1)[:, 0], axis=1).max() < 1.5 * CELL
