"""Viscoplasticity after Perzyna with Voce hardening, as a law of a user's own, against another code's curve.

`neml2_voce.csv`: axial strain, lateral strain, axial stress [MPa] every 5 s, from NEML2's verification suite (Argonne
National Laboratory, MIT licence). Its overstress is that of the norm of the deviator, |s| - sqrt(2/3) (sigma_y + k),
and so is its rate: dep/dt = sqrt(2/3) [sqrt(2/3) (q - sigma_y - k) / 500 MPa]^5.
"""

from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from core_models.driver import drive
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.laws import flow_stress
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises

CURVE = Path(__file__).parent / "neml2_voce.csv"
SMALLEST_RATE = 1e-12  # 1/s
VISCOSITY = 500e6 * 1.5**0.6  # Pa s^(1/5), of the equivalent stress and strain


class ViscousVoce(NamedTuple):
    """sigma_y = 10 MPa + 100 MPa [1 - exp(-1.1 ep)] + viscosity (dep/dt)^(1/5)."""

    viscosity: float


@pytest.fixture
def viscous():
    """The law, known for the length of a test."""

    @flow_stress.register(ViscousVoce)
    def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
        rate = max(plastic_rate, SMALLEST_RATE)
        gap = 100e6 * np.exp(-1.1 * plastic_strain)
        drag = flow.viscosity * rate**0.2
        return 110e6 - gap + drag, 0.0, 1.1 * gap, 0.2 * drag / rate, 0.0

    yield ViscousVoce(VISCOSITY)
    del flow_stress.implementations[ViscousVoce]


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", [HypoelasticPlastic(), HyperelasticPlastic()])
def test_curve_of_another_code_is_met(update, viscous):
    """Axial stress within 1 % at every point of a tension test at 1e-4 /s, whose strains are given, in both updates."""
    axial, lateral, stress = np.loadtxt(CURVE, delimiter=",").T
    elastic = IsotropicElastic.from_young(124e9, 0.32)
    bulk = elastic.bulk_modulus
    eos = DefaultHypoelastic(bulk) if isinstance(update, HypoelasticPlastic) else NeoHookean(bulk)
    material = Material("neml2", 1e3, update, elastic, eos, viscous, VonMises())
    path = np.zeros((len(axial), 3, 3))
    for row, column in ((0, axial), (1, lateral), (2, lateral)):
        path[:, row, row] = np.exp(column)
    history = drive(material, path, 5.0)
    mean = history.stress[:, :3].mean(axis=1)
    found = 1.5 * (history.stress[:, 0] - mean)
    assert found[1:] == pytest.approx(1e6 * stress[1:], rel=0.01)
