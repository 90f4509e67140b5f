"""Stability checks with every yield condition: closed forms of Hill, Prager, and Rudnicki and Rice."""

import numpy as np
import pytest

from core_models import points as points_module
from core_models.elasticity.cubic import CubicElastic
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.flow.linear import LinearHardening
from core_models.flow.voce import Voce
from core_models.kinematic_hardening.prager import Prager
from core_models.material import Material
from core_models.points import MaterialPoints
from core_models.updates.continuing_tangent import continuing_tangents
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises
from studies.laws.sample_laws import SAMPLES
from tests.core_models.test_stability import BULK, LAWS, NU, PURE_SHEAR, SHEAR, TENSION, YIELD

ELASTIC = IsotropicElastic(BULK, SHEAR)


def flowing(strength, modulus):
    """A flow law of this strength and slope at the start [Pa]."""
    rate = 2.0 * abs(modulus) / strength
    return Voce(strength, (1.5 if modulus >= 0.0 else 0.5) * strength, rate, 0.0)


def body(condition, flow, law, **slots):
    """Copper with a yield condition."""
    laws = {"elasticity": ELASTIC, "eos": DefaultHypoelastic(BULK), "stability": LAWS[law]} | slots
    return Material("body", 8930.0, HypoelasticPlastic(), flow=flow, yield_condition=condition, **laws)


def loaded(material, stress):
    """A point of the material under a stress, elastic up to there."""
    points = MaterialPoints(material, np.ones(1))
    points.old.stress[0] = stress
    pressure = stress[:3].mean()
    points.old_deformation_gradient[0] *= np.exp(pressure / (3.0 * BULK))
    return points


def measure(condition, stress, strength, modulus, law, **slots):
    """Stability of a point that lies on the surface under a stress, with a hardening modulus [Pa]."""
    return loaded(body(condition, flowing(strength, modulus), law, **slots), stress).stability()[0]


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("stress", [TENSION, PURE_SHEAR])
@pytest.mark.parametrize("law", LAWS)
def test_a_surface_that_hardly_moves_is_the_radial_one(stress, law):
    """Von Mises with next to no back stress, and with an anisotropic law of isotropic constants."""
    lame = BULK - 2.0 / 3.0 * SHEAR
    crystal = CubicElastic(lame + 2.0 * SHEAR, lame, SHEAR, (1.0, 2.0, -2.0), (3.0, 0.0, 1.0))
    for modulus in (5e9, -5e9):
        radial = measure(VonMises(), stress, YIELD, modulus, law)
        moving = measure(VonMises(), stress, YIELD, modulus, law, kinematic_hardening=Prager(1e-3))
        assert moving == pytest.approx(radial, rel=1e-4, abs=1e-7)
        turned = measure(VonMises(), stress, YIELD, modulus, law, elasticity=crystal, eos=None)
        assert turned == pytest.approx(radial, abs=2e-2)


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("law", LAWS)
def test_heat_of_flow_softens_a_cone_as_it_does_the_cylinder(law):
    """Johnson-Cook with heat at a rate of its own: von Mises and a cone without friction are the same."""
    found = []
    for condition in (VonMises(), DruckerPrager(0.0, 0.0, 1.0 / np.sqrt(3.0))):
        slots = {slot: SAMPLES[slot][0] for slot in ("heating", "specific_heat", "melting")}
        points = loaded(body(condition, SAMPLES["flow"][6], law, **slots), 2.0 * PURE_SHEAR)
        points.old.temperature[0], points.old.equivalent_plastic_strain[0] = 600.0, 0.2
        found.append(points.stability()[0])
    assert found[1] == pytest.approx(found[0], rel=1e-5, abs=1e-8)


@pytest.mark.usefixtures("interpreted")
def test_pragers_modulus_hardens_as_the_flow_law_does():
    """Drucker's measure is (H + C) / (3 G + H + C)."""
    for modulus, prager in ((5e9, 2e9), (-5e9, 2e9), (-1e9, 8e9)):
        total = modulus + prager
        found = measure(VonMises(), TENSION, YIELD, modulus, "drucker", kinematic_hardening=Prager(prager))
        assert found == pytest.approx(total / (3.0 * SHEAR + total), abs=2.0 * YIELD / SHEAR)


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize(("stress", "middle"), [(PURE_SHEAR, 0.0), (TENSION, -1.0 / np.sqrt(3.0))])
@pytest.mark.parametrize(("alpha", "beta"), [(0.2, 0.2), (0.2, 0.05)])
def test_bands_in_a_frictional_body_form_at_the_modulus_of_rudnicki_and_rice(stress, middle, alpha, beta):
    """h / G = (1 + nu) / (9 (1 - nu)) (b - m)^2 - (1 + nu) / 2 [N + (b + m) / 3]^2, m = 3 alpha, b = 3 beta."""
    m, b = 3.0 * alpha, 3.0 * beta
    critical = (1.0 + NU) / (9.0 * (1.0 - NU)) * (b - m) ** 2 - 0.5 * (1.0 + NU) * (
        middle + (b + m) / 3.0
    ) ** 2
    tau = np.sqrt(
        1.5 * ((stress[:3] - stress[:3].mean()) ** 2).sum() + 3.0 * (stress[3:] ** 2).sum()
    ) / np.sqrt(3.0)
    strength = tau + alpha * stress[:3].sum()
    for margin in (0.02, -0.02):
        # h is the slope by dgamma = sqrt(3) d ep.
        modulus = (critical + margin) * SHEAR * np.sqrt(3.0)
        found = measure(DruckerPrager(alpha, beta), stress, strength, modulus, "acoustic")
        assert np.sign(found) == np.sign(margin)
        assert abs(found) > 1e-4


@pytest.mark.usefixtures("interpreted")
def test_flow_that_is_not_associated_lets_second_order_work_turn_negative():
    """Drucker's measure is 0 for associated perfect plasticity, below it with less dilation than friction."""
    sine = np.sin(np.radians(30.0))
    strength = 0.5 * YIELD * (1.0 + sine) / np.cos(np.radians(30.0))
    for associated, other in (
        (measure(DruckerPrager(0.2, 0.2), TENSION, YIELD / np.sqrt(3.0) + 0.2 * YIELD, 0.0, "drucker"),
         measure(DruckerPrager(0.2, 0.0), TENSION, YIELD / np.sqrt(3.0) + 0.2 * YIELD, 0.0, "drucker")),
        (measure(MohrCoulomb(30, 30), TENSION, strength, 0.0, "drucker"),
         measure(MohrCoulomb(30, 0), TENSION, strength, 0.0, "drucker")),
    ):  # fmt: skip
        assert associated == pytest.approx(0.0, abs=2.0 * YIELD / SHEAR)
        assert other < -0.01


@pytest.mark.usefixtures("interpreted")
def test_a_point_inside_is_as_stable_as_at_rest_and_one_at_the_cut_off_is_not():
    """The surface is where the point lies, cut-offs included."""
    for condition in (DruckerPrager(0.2, 0.1, 1.0, 0.3e9), MohrCoulomb(30, 10, 0.3e9)):
        material = body(condition, LinearHardening(3e9, 0.0), "drucker")
        inside = loaded(material, np.array([0.299e9] * 3 + [0.0] * 3))
        assert inside.stability()[0] == pytest.approx(1.0, abs=0.02)
        assert loaded(material, np.array([0.3e9] * 3 + [0.0] * 3)).stability()[0] == pytest.approx(
            0.0, abs=0.02
        )


@pytest.mark.usefixtures("interpreted")
def test_voids_take_stability_away():
    """In a porous body under triaxial tension the measures fall with the porosity."""
    stress = TENSION + np.array([2.0 * YIELD] * 3 + [0.0] * 3)
    found = []
    for porosity in (1e-4, 0.02, 0.1):
        damage = SAMPLES["damage"][3]._replace(initial_porosity=porosity, f_n=0.0)
        condition = Gurson(1.5, 1.0, 2.25, 1.0, 0.5)
        points = loaded(body(condition, flowing(1e6, 0.0), "drucker", damage=damage), stress)
        found.append(points.stability()[0])
    assert 0.0 > found[0] > found[1] > found[2]


def test_the_compiled_tangent_is_that_of_plain_python(monkeypatch):
    """Of a cone at different shears."""
    material = body(DruckerPrager(0.2, 0.1), LinearHardening(YIELD, 1e9), "drucker")
    points = MaterialPoints(material, np.ones(30))
    points.deformation_gradient[:, 0, 1] = np.linspace(0.0, 0.1, points.n)
    points.advance(1.0)
    points.accept()
    compiled = points.stability()
    kernel = getattr(continuing_tangents, "py_func", continuing_tangents)
    monkeypatch.setattr(points_module, "continuing_tangents", kernel)
    assert points.stability() == pytest.approx(compiled, rel=1e-9)
    assert compiled[0] == pytest.approx(1.0) and compiled[-1] < 0.2
