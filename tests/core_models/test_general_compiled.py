"""The general return compiled: what it gives is what plain Python gives."""

import numpy as np
import pytest

from core_models import points
from core_models.driver import drive
from core_models.kernels import advance_points
from core_models.kinematic_hardening.armstrong_frederick import ArmstrongFrederick
from tests.core_models.test_anisotropic_elasticity import COPPER
from tests.core_models.test_anisotropic_plasticity import crystal
from tests.core_models.test_kinematic_hardening import steel, wild_path


@pytest.mark.parametrize("kind", ["isotropic", "anisotropic"])
def test_compiled_and_plain_agree(monkeypatch, kind):
    """Every field along a random path in the plastic range, to round-off."""
    hardening, path = ArmstrongFrederick(40e9, 400.0), wild_path(30, 0.01)
    material = (
        steel("hypo", hardening) if kind == "isotropic" else crystal(COPPER, kinematic_hardening=hardening)
    )
    compiled = drive(material, path, 1e-3)
    monkeypatch.setattr(points, "advance_points", getattr(advance_points, "py_func", advance_points))
    plain = drive(material, path, 1e-3)
    assert plain.fields["equivalent_plastic_strain"][-1] > 0.1
    for name, field in plain.fields.items():
        assert compiled.fields[name] == pytest.approx(field, abs=1e-9 * max(np.abs(field).max(), 1e-3)), name
