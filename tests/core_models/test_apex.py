"""The apex of pressure-dependent surfaces: what its flow of volume counts as plastic strain."""

import numpy as np
import pytest

from core_models.driver import drive, drive_program
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.flow.johnson_cook import JohnsonCook
from core_models.kinematic_hardening.prager import Prager
from core_models.laws import flow_stress
from core_models.loading_paths import volumetric
from core_models.material import Material
from core_models.points import MaterialPoints
from core_models.yield_condition.apex import BY_SHEAR, BY_VOLUME, CUT_OFF
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.drucker_prager_return import apex_of as cone_apex
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.mohr_coulomb_return import apex_of as pyramid_apex
from tests.core_models.test_general_tangent import mismatch, soil
from tests.core_models.test_pressure_dependent_yield import BULK, COHESION, SHEAR, UPDATES, measured
from tests.core_models.test_pressure_dependent_yield import soil as soil_of

RATE = JohnsonCook(1e6, 5e6, 0.1, 1.0, 1.0, 1.0, 294.0, 1356.0)
CONDITIONS = [DruckerPrager.from_friction(30, 0), DruckerPrager.from_friction(30, 30), MohrCoulomb(30, 0)]
each_condition = pytest.mark.parametrize("condition", CONDITIONS, ids=["cone-0", "cone-30", "pyramid-0"])
each_update = pytest.mark.parametrize("update", UPDATES)

pytestmark = pytest.mark.usefixtures("interpreted")


def apex(condition):
    """Friction and growth of the apex."""
    return (pyramid_apex if isinstance(condition, MohrCoulomb) else cone_apex)(condition)


def viscous(condition):
    """A soil whose cohesion grows with the rate."""
    elastic, eos = IsotropicElastic(BULK, SHEAR), soil_of("hypo", condition).eos
    return Material("soil", 2000.0, UPDATES["hypo"], elastic, eos, RATE, condition)


@each_update
@each_condition
def test_pulled_equally_plastic_strain_is_the_growth_of_the_volume(update, condition):
    """dp = dv / (3 sqrt(3) alpha), that of the matched cone for the pyramid; K (ln J - dv) = sigma_y(dp) / f."""
    modulus = 20e6
    history = drive_program(soil_of(update, condition, modulus), volumetric(0.02, 1.0, steps=3))
    friction, growth, _cutoff = apex(condition)
    assert growth == pytest.approx(3.0 * np.sqrt(3.0) * CONDITIONS[1].alpha)
    assert COHESION / friction == pytest.approx(COHESION * np.sqrt(3.0))  # c cot(30 degrees)
    strain, volume = (history.fields[name][-1] for name in ("equivalent_plastic_strain", "plastic_volume"))
    assert volume > 0.01 and strain == pytest.approx(volume / growth, rel=1e-9)
    stress = measured(history, update)[-1, 0]
    assert stress == pytest.approx((COHESION + modulus * strain) / friction, rel=1e-8)
    if update == "hypo":
        expected = (BULK * 0.02 - COHESION / friction) / (BULK * growth + modulus / friction)
        assert strain == pytest.approx(expected, rel=1e-8)


@each_condition
def test_the_mean_stress_at_the_apex_grows_with_the_rate(condition):
    """sigma_y(dp, dp / dt) / f, a decade of the rate adding 10 % ln(10)."""
    friction, growth, _cutoff = apex(condition)
    for rate in (1e2, 1e4):
        history = drive_program(viscous(condition), volumetric(0.02, rate, steps=4))
        strain = history.fields["equivalent_plastic_strain"]
        assert strain[-1] == pytest.approx(history.fields["plastic_volume"][-1] / growth, rel=1e-9)
        now = flow_stress(RATE, 0.0, strain[-1], np.diff(strain)[-1] / (0.005 / rate), 294.0)[0]
        assert history.stress[-1, 0] == pytest.approx(now / friction, rel=1e-8)
        assert np.diff(history.plastic).min() >= 0.0


@each_condition
@pytest.mark.parametrize("shear", [0.0, 1e-16, 1e-12])
def test_a_viscous_apex_holds_its_stress_for_a_moment(condition, shear):
    """In 1e-9 s after a step at 1e3 /s the mean stress stays to 1e-3, whatever round-off leaves of the shear stress."""
    points = MaterialPoints(viscous(condition), np.ones(1))
    points.deformation_gradient[0] *= 1.01
    points.advance(3e-5)
    points.accept()
    points.deformation_gradient[0] = points.old_deformation_gradient[0] + shear * np.diag([1.0, -1.0, 0.0])
    points.advance(1e-9)
    assert points.new.stress[0, :3] == pytest.approx(points.old.stress[0, :3], rel=1e-3)


@each_condition
def test_plastic_strain_is_continuous_from_the_rest_of_the_surface_to_the_apex(condition):
    """Over trial states from pure shear to pure tension no step of it is larger than those of the strain."""
    angles = np.linspace(0.0, 0.5 * np.pi, 120)
    found = []
    for angle in angles:
        strain = 0.02 * (np.sin(angle) * np.eye(3) / np.sqrt(3.0) + np.cos(angle) * np.diag([0.7, 0.1, -0.8]))
        path = np.array([np.eye(3), np.eye(3) + strain])
        history = drive(soil_of("hypo", condition, 2e6), path, 1.0)
        found.append(history.fields["equivalent_plastic_strain"][-1])
    assert np.abs(np.diff(found)).max() <= 3.0 * 0.02 * angles[1]


KINDS = {
    "shear": (DruckerPrager.from_friction(30, 10), [0.015, 0.003, -0.01], BY_SHEAR),
    "volume": (DruckerPrager.from_friction(30, 10), [0.02, 0.02, 0.02], BY_VOLUME),
    "cut-off": (DruckerPrager.from_friction(30, 10, tension_cutoff=1.8e6), [0.02, 0.011, 0.015], CUT_OFF),
    "volume of the pyramid": (MohrCoulomb(30, 10), [0.02, 0.02, 0.02], BY_VOLUME),
    "cut-off of the pyramid": (MohrCoulomb(30, 10, 1.8e6), [0.02, 0.011, 0.015], CUT_OFF),
}
MOVING = [(kind, Prager(1e8)) for kind in ("shear", "volume", "cut-off")]


@pytest.mark.parametrize(("kind", "kinematic"), [(kind, None) for kind in KINDS] + MOVING)
@each_update
def test_the_tangent_is_the_derivative_of_every_kind_of_flow_at_the_apex(kind, kinematic, update):
    """To 1e-6 against central differences, also where no shear stress is there to be taken away."""
    condition, strains, _expected = KINDS[kind]
    material = soil(type(UPDATES[update]), condition, kinematic)
    assert mismatch(material, np.diag(strains), before=0.0) <= 1e-6


@pytest.mark.parametrize("kind", KINDS)
def test_plastic_strain_at_the_apex_is_of_the_kind_meant(kind):
    """More than dv / g where shear gives it or less where the cut-off does, dv / g itself where the volume does."""
    condition, strains, expected = KINDS[kind]
    path = np.array([np.eye(3), np.eye(3) + np.diag(strains)])
    history = drive(soil(type(UPDATES["hypo"]), condition), path, 1e-4)
    strain, volume = (history.fields[name][-1] for name in ("equivalent_plastic_strain", "plastic_volume"))
    share = strain * apex(condition).growth / volume
    assert history.stress[-1] == pytest.approx([history.stress[-1, 0]] * 3 + [0.0] * 3, abs=1.0)
    assert np.sign(np.round(share - 1.0, 9)) == {BY_SHEAR: 1.0, BY_VOLUME: 0.0, CUT_OFF: -1.0}[expected]
