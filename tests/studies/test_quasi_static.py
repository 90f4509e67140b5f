"""Explicit dynamics as quasi-statics: mass scaled to the loading time, and what moves too much is refused."""

import math
from types import SimpleNamespace

import pytest

from core_models.errors import RunFailure
from core_models.ledger import EnergyLedger
from core_models.loads import Prescribed, Symmetry
from meshes.block import block
from studies.methods.quasi_static import KineticWatch, slow_enough
from tests.studies.necking_samples import SIMO

LENGTH = 0.1


def test_mass_is_scaled_to_the_lowest_natural_mode():
    """A bar held at both ends has the period 2 L / c: loading then takes the periods asked for."""
    mesh = block([0.0, 0.0], [LENGTH / 20.0, LENGTH], [1, 20])
    loads = (Symmetry("bottom"), Prescribed("top", 1, 0.0))
    material = SIMO.material
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
