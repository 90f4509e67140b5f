"""The bar necking study: closed forms, quantities of made curves, quasi-static refusals, and a coarse run."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from core_models.errors import RunFailure
from core_models.ledger import EnergyLedger
from core_models.loads import Prescribed, Symmetry
from meshes.block import block
from studies.bar_necking import (
    HYPOELASTIC,
    NECKING_SIMO,
    NeckingHistory,
    at_elongation,
    bridgman_factor,
    neck_curvature,
    peak,
    simo_steel,
    uniform_peak,
)
from studies.necking_methods import NeckingMesh, implicit_run
from studies.quasi_static import KineticWatch, slow_enough
from studies.verification.problems.necking_simo import PEERS, _quantity_table, measured, read_peers
from studies.verification.study import find_problem

LENGTH = 0.1


def history(elongation, force):
    """A history with these columns, the others 0."""
    made = object.__new__(NeckingHistory)
    rest = (0.0,) * (len(NeckingHistory.COLUMNS) - 2)
    made.rows = [(u, f, *rest) for u, f in zip(elongation, force, strict=True)]
    return made


def test_closed_forms_of_the_largest_uniform_force():
    """79.46 kN where the flow stress is the Kirchhoff stress, 79.58 kN where it is the Cauchy stress."""
    assert uniform_peak(NECKING_SIMO.material, NECKING_SIMO.radius) == pytest.approx(79.46e3, rel=1e-4)
    assert uniform_peak(simo_steel(HYPOELASTIC), NECKING_SIMO.radius) == pytest.approx(79.58e3, rel=1e-4)


def test_peak_of_a_parabola_is_exact_between_its_points():
    """The largest force of a curve is found between increments."""
    u = np.linspace(0.0, 1.0, 8)
    assert peak(history(u, 5.0 - (u - 0.47) ** 2)) == pytest.approx((0.47, 5.0), rel=1e-12)


def test_values_beyond_the_end_of_a_run_are_not_made_up():
    """At an elongation that a run has not reached there is no value."""
    made = history([0.0, 1.0], [0.0, 2.0])
    assert at_elongation(made, "force", 0.25) == 0.5 and at_elongation(made, "force", 1.1) is None


def test_bridgman_factor_agrees_with_his_table():
    """a / R = 0.1, 0.25, 0.5, 1: 0.976, 0.943, 0.896, 0.822; 1 without a neck."""
    factors = [bridgman_factor(1.0, curvature) for curvature in (0.1, 0.25, 0.5, 1.0)]
    assert factors == pytest.approx([0.976, 0.943, 0.896, 0.822], abs=6e-4)
    assert bridgman_factor(1.0, 0.0) == 1.0


def test_curvature_of_a_round_notch_is_found():
    """A circle of radius 2 that touches r = 1 at z = 0."""
    z = np.linspace(0.0, 1.0, 41)
    side = np.column_stack([3.0 - np.sqrt(4.0 - z**2), z])
    assert neck_curvature(side) == pytest.approx(0.5, rel=0.02)


def test_mass_is_scaled_to_the_lowest_natural_mode():
    """A bar held at both ends has the period 2 L / c: loading then takes the periods asked for."""
    mesh = block([0.0, 0.0], [LENGTH / 20.0, LENGTH], [1, 20])
    loads = (Symmetry("bottom"), Prescribed("top", 1, 0.0))
    material = simo_steel()
    scaled = slow_enough(mesh, material, loads, 1.0, 50.0)
    bulk, shear = material.elasticity.bulk_modulus, material.elasticity.shear_modulus
    young = 9.0 * bulk * shear / (3.0 * bulk + shear)
    period = 2.0 * LENGTH / math.sqrt(young / scaled.density)
    assert 1.0 / period == pytest.approx(50.0, rel=5e-3)


def test_a_run_that_moves_is_not_called_quasi_static():
    """More kinetic energy than 0.2 % of what the body took up is refused with the share; the start does not count."""
    watch = KineticWatch(0.1)
    for time, kinetic in ((0.05, 5.0), (0.2, 0.0015), (0.3, 0.001)):
        watch.look(SimpleNamespace(time=time, ledger=EnergyLedger(0.0, kinetic, 0.4, 0.6)))
    watch.check()
    assert watch.share == pytest.approx(0.0015)
    watch.look(SimpleNamespace(time=0.4, ledger=EnergyLedger(0.0, 0.03, 0.4, 0.6)))
    with pytest.raises(RunFailure, match=r"up to 3 % .* not quasi-static; load over more periods"):
        watch.check()


def test_coarse_bar_necks_near_the_other_codes():
    """4 x 12 elements in 50 increments: peak 77.3 kN within 0.3 %, no cut; Bridgman within 5 % at 4 mm."""
    run = implicit_run(NECKING_SIMO, NeckingMesh(4, 12, 0.25), 50)
    found = measured(run)
    assert found["peak force"] == pytest.approx(77.3, rel=3e-3)
    assert found["elongation at peak"] == pytest.approx(2.83, abs=0.05)
    assert found["force at 4 mm"] == pytest.approx(71.2, rel=0.015)
    assert run.cuts == 0 and run.kinetic_share == 0.0
    estimate, true = (at_elongation(run.history, name, 4e-3) for name in ("bridgman", "flow_stress"))
    assert estimate == pytest.approx(true, rel=0.05)
    centre, surface = (at_elongation(run.history, f"{at}_triaxiality", 4e-3) for at in ("centre", "surface"))
    assert centre > 0.45 > surface > 0.2
    head, first = _quantity_table([run]).head, _quantity_table([run]).rows[0]
    assert len(first) == len(head) and first[1] == found["peak force"]


def test_curves_of_other_codes_are_whole():
    """Both curves go to 7 mm in SI units, with their largest force near 77.3 kN."""
    table = read_peers(PEERS)
    assert table["elongation"][-1] == 7e-3
    for name in ("calculix", "fedoo"):
        assert table[f"{name}_force"].max() == pytest.approx(77.3e3, rel=2e-3)
        assert (np.diff(table[f"{name}_neck_radius"]) < 0.0).all()


def test_the_necking_study_has_its_problem():
    """`matpoint study necking` finds it by name."""
    assert find_problem("necking-simo").name == "necking-simo"
