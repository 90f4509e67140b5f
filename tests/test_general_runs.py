"""Frictional, moving and anisotropic plasticity in runs of both methods, and deleted points."""

import numpy as np
import pytest

from core_models import points as points_module
from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.driver import drive
from core_models.elasticity.cubic import CubicElastic
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.erosion.delete import DeletePoint
from core_models.flow.linear import LinearHardening
from core_models.kernels import advance_points
from core_models.kinematic_hardening.armstrong_frederick import ArmstrongFrederick
from core_models.loads import Prescribed, Symmetry
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises
from fem import ExplicitSolver
from meshes.block import block
from mpm import Solver

BULK, SHEAR, DENSITY, STRENGTH = 1e9, 0.6e9, 2000.0, 1e6
CRYSTAL = CubicElastic(1.6e9, 0.8e9, 0.8e9, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
MOVING = ArmstrongFrederick(1e8, 50.0)
KINDS = {"cone": (DruckerPrager.from_friction(30, 10), None), "pyramid": (MohrCoulomb(30, 10), None),
         "moving cylinder": (VonMises(), MOVING), "moving cone": (DruckerPrager.from_friction(30, 10), MOVING),
         "crystal": (VonMises(), None)}  # fmt: skip
# Velocity gradients [1/s]: a triaxial compression, in plane strain, about an axis and in space.
RATES = {"plane-strain": (0.6, -1.0), "axisymmetric": (0.4, -1.0), "spatial": (0.5, 0.3, -1.0)}
SYMMETRIES, MOVED = ("left", "front", "bottom"), ("right", "back", "top")
END = 0.009  # s
METHODS = ("fem", "mpm")


@pytest.fixture(autouse=True)
def plain(monkeypatch):
    """Let points advance in plain Python, which needs no compilation of each material."""
    monkeypatch.setattr(points_module, "advance_points", getattr(advance_points, "py_func", advance_points))


def soft(kind, update="hypo", **slots):
    """A soft body of one kind of plasticity."""
    condition, kinematic = KINDS[kind]
    laws = {
        "flow": LinearHardening(STRENGTH, 2e6),
        "yield_condition": condition,
        "kinematic_hardening": kinematic,
    }
    if kind == "crystal":
        return Material(kind, DENSITY, HypoelasticPlastic(), CRYSTAL, **(laws | slots))
    kinematics = HypoelasticPlastic() if update == "hypo" else HyperelasticPlastic()
    eos = DefaultHypoelastic(BULK) if update == "hypo" else NeoHookean(BULK)
    return Material(kind, DENSITY, kinematics, IsotropicElastic(BULK, SHEAR), eos, **(laws | slots))


def strained(method, geometry, material, rates, **options):
    """A block of edges 1 m between three symmetry planes and three that move, which begins with their motion."""
    d = len(rates)
    mesh = block([0.0] * d, [1.0] * d, [4 - d] * d, "quad4" if d == 2 else "hex8")
    fixed, moved = (("left", "bottom"), ("right", "top")) if d == 2 else (SYMMETRIES, MOVED)
    loads = [Symmetry(name) for name in fixed if not (geometry == "axisymmetric" and name == "left")]
    loads += [Prescribed(name, i, rate) for i, (name, rate) in enumerate(zip(moved, rates, strict=True))]
    if method == "mpm":
        options["cell_size"] = 1.0 / (4 - d)
    solver = ExplicitSolver if method == "fem" else Solver
    return solver(mesh, material, geometry=geometry, velocity=lambda x: x * rates, loads=loads, **options)


def advanced(solver, end):
    """The solver at a time [s]."""
    while solver.time < end:
        solver.advance(end)
    return solver


@pytest.mark.parametrize("geometry", RATES)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", KINDS)
def test_a_strained_block_is_the_point_of_the_driver(method, geometry, kind):
    """Stress and plastic strain of all its points, far in the plastic range, are those of the material point."""
    rates = RATES[geometry]
    update = "hyper" if geometry == "spatial" else "hypo"
    solver = advanced(strained(method, geometry, soft(kind, update), rates), END)
    third = {"plane-strain": 0.0, "axisymmetric": rates[0], "spatial": rates[-1]}[geometry]
    steps = np.linspace(0.0, END, 41)
    path = np.eye(3) + steps[:, None, None] * np.diag([*rates[:2], third])
    history = drive(soft(kind, update), path, END / 40)
    fields, expected = solver.points.fields(), history.fields
    scale = np.abs(history.stress[-1]).max()
    assert expected["equivalent_plastic_strain"][-1] > 0.003
    assert fields["stress"].array == pytest.approx(
        np.tile(history.stress[-1], (solver.points.n, 1)), abs=0.01 * scale
    )
    assert fields["equivalent_plastic_strain"].array == pytest.approx(
        expected["equivalent_plastic_strain"][-1], rel=0.01
    )


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", ["moving cylinder", "cone", "crystal"])
def test_deleted_points_leave_a_run_that_goes_on(method, kind):
    """Pulled beyond its failure strain the block lets go: no stress, no limit of the time step, work and mass kept."""
    slots = {"damage": HancockMackenzieDamage(0.0, 0.01), "erosion": DeletePoint()}
    material = soft(kind, **(slots | {"flow": LinearHardening(3e6, 0.0)}))
    solver = strained(method, "plane-strain", material, (-0.2, 2.0))
    mass, sound = solver.mass, solver.points.wave_speed.max()
    advanced(solver, 0.02)
    damage = solver.points.fields()["damage"].array
    assert (damage >= 1.0).all()
    assert np.abs(solver.points.fields()["stress"].array).max() == 0.0
    assert solver.points.wave_speed.max() < 1e-2 * sound and np.isfinite(solver.time_step)
    assert solver.mass == mass and solver.ledger.plastic > 0.0
