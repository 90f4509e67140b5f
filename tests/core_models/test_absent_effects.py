"""An effect that is off costs nothing: no state, no code."""

import re
from collections import Counter

import numba
import numpy as np
import pytest

from core_models import points as points_module
from core_models.bulk_viscosity import BulkViscosity
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.kernels import advance_points
from core_models.melting.constant import ConstantMelting
from core_models.points import MaterialPoints
from core_models.specific_heat.constant import ConstantSpecificHeat

ALWAYS = {"deformation_gradient", "stress"}
FUNCTIONS = re.compile(r"call [^\n]*@(?:llvm\.)?(exp|expm1|log|pow|tanh)(?:\.f64)?\(")


@pytest.fixture
def machine_code(monkeypatch):
    """Compile the kernel of a material anew, outside the cache, and return its optimised code."""

    def compiled(material, viscosity=None):
        kernel = numba.njit(nogil=True, error_model="numpy", boundscheck=False)(advance_points.py_func)
        monkeypatch.setattr(points_module, "advance_points", kernel)
        MaterialPoints(material, np.ones(1), viscosity=viscosity).advance(1e-6)
        return kernel.inspect_llvm(kernel.signatures[0])

    return compiled


def functions_called(code):
    """Transcendental functions that the code calls, and how often."""
    return Counter(FUNCTIONS.findall(code))


@pytest.mark.parametrize(
    ("name", "fields"),
    [
        ("hypo-elastic", {"rotation"}),
        ("hyper-elastic", {"elastic_left_cauchy_green"}),
        ("hypo-linear", {"rotation", "equivalent_plastic_strain"}),
        ("hyper-voce", {"elastic_left_cauchy_green", "equivalent_plastic_strain"}),
        (
            "hyper-mts-hot",
            {
                "elastic_left_cauchy_green",
                "equivalent_plastic_strain",
                "hardening_variable",
                "temperature",
                "damage",
                "internal_energy",
            },
        ),
    ],
)
def test_points_carry_only_the_state_that_an_effect_needs(pool, name, fields):
    """No array for a temperature, damage, energy or history that nothing uses."""
    points = MaterialPoints(pool[name], np.ones(3))
    assert set(points.fields()) == ALWAYS | fields
    for state in (points.old, points.new):
        assert {field for field, array in state._asdict().items() if array is not None} == fields | {"stress"}


def test_every_single_effect_adds_its_own_state(copper, hot_copper):
    """Melting or a law that feels heat brings a temperature, damage a damage variable, viscosity its pressure."""
    plain = set(MaterialPoints(copper("hypo", "linear"), np.ones(1)).fields())

    def added(material, viscosity=None):
        return set(MaterialPoints(material, np.ones(1), viscosity=viscosity).fields()) - plain

    heated = {"heating": TaylorQuinney(0.9), "specific_heat": ConstantSpecificHeat(383.0)}
    assert added(copper("hypo", "jc")) == {"temperature"}
    assert added(copper("hypo", "linear", melting=ConstantMelting(1356.0))) == {"temperature"}
    assert added(copper("hypo", "linear", **heated)) == {"temperature"}
    assert added(copper("hypo", "mts")) == {"temperature", "hardening_variable"}
    assert added(copper("hypo", "linear", eos=hot_copper("hypo", "jc").eos)) == {"internal_energy"}
    assert added(copper("hypo", "linear", damage=hot_copper("hypo", "jc").damage)) == {
        "damage",
        "temperature",
    }
    assert added(copper("hypo", "linear"), BulkViscosity()) == {"viscous_pressure"}


def test_absent_effects_leave_no_code(copper, hot_copper, machine_code):
    """The optimised kernel calls no function without plasticity, and Johnson-Cook's law brings none of the C library.

    Without viscosity and without plasticity the code is shorter.
    """
    eos = hot_copper("hypo", "jc").eos
    elastic = machine_code(copper("hypo", eos=eos))
    viscous = machine_code(copper("hypo", eos=eos), BulkViscosity())
    softening = machine_code(copper("hypo", "jc", eos=eos))
    assert functions_called(elastic) == {}
    assert functions_called(softening).keys() <= {"exp"}
    assert len(elastic) < len(viscous)
    assert len(elastic) < len(softening)
