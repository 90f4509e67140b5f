"""Flow stress, shear modulus and melting feel the density, the pressure and the temperature before the step.

In plain Python: no law here is compiled.
"""

from dataclasses import replace

import numpy as np
import pytest

from core_models.cards import read_material, shipped_materials
from core_models.driver import drive
from core_models.laws import flow_stress, melting_temperature, pressure, shear_modulus, under_pressure
from core_models.paths import simple_shear, uniaxial_strain
from core_models.points import MaterialPoints
from core_models.shear_modulus.nadal_le_poac import NadalLePoac
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic

pytestmark = pytest.mark.usefixtures("interpreted")
RATE = 1e5  # 1/s
STRETCHES = np.linspace(1.0, 0.85, 41)
METALS = {
    "steinberg": "copper_ofhc_steinberg_cochran_guinan",
    "preston": "copper_ofhc_preston_tonks_wallace",
    "tantalum": "tantalum_steinberg_cochran_guinan",
}


def metal(name):
    """A shipped metal whose laws feel the pressure."""
    return read_material(shipped_materials()[METALS[name]]).material


def compressed(material):
    """Uniaxial compression to 0.85 at 1e5 /s, some 30 GPa."""
    return drive(material, uniaxial_strain(STRETCHES), (STRETCHES[0] - STRETCHES[1]) / RATE)


def state_before(history, step):
    """Density ratio, pressure and temperature at the beginning of a step."""
    temperature = history.fields["temperature"][step - 1]
    return 1.0 / STRETCHES[step - 1], history.pressure[step - 1], temperature


@pytest.mark.parametrize("hyper", [False, True], ids=["hypo", "hyper"])
@pytest.mark.parametrize("name", METALS)
def test_strength_is_that_of_the_pressure_before_the_step(name, hyper):
    """The stress lies on the yield surface of density, pressure and melting temperature before the step."""
    material = metal(name)
    material = replace(material, update=HyperelasticPlastic()) if hyper else material
    history = compressed(material)
    assert history.pressure[-1] > 20e9
    for step in range(20, len(STRETCHES)):
        density_ratio, p, temperature = state_before(history, step)
        melting = melting_temperature(material.melting, density_ratio, p)
        flow = under_pressure(material.flow, density_ratio, p, melting)
        strains = history.fields["equivalent_plastic_strain"]
        rate = (strains[step] - strains[step - 1]) / (history.times[step] - history.times[step - 1])
        strength = flow_stress(flow, 0.0, strains[step], rate, temperature)[0]
        to_measure = STRETCHES[step] if hyper else 1.0
        assert history.mises[step] * to_measure == pytest.approx(strength, rel=1e-9)
        assert strength > 1.2 * flow_stress(material.flow, 0.0, strains[step], rate, temperature)[0]


def test_elastic_stiffness_is_that_of_the_shear_modulus_before_the_step():
    """An elastic step in shear under 30 GPa: ds = 2 G dev(d) with the modulus there, and its wave speed."""
    material = metal("steinberg")
    points = MaterialPoints(replace(material, flow=None, yield_condition=None, heating=None), np.ones(1))
    points.deformation_gradient[0] = 0.93 * np.eye(3)
    points.advance(1e-6)
    points.accept()
    density_ratio, p = 0.93**-3, -points.old.stress[0, 0]
    melting = melting_temperature(material.melting, density_ratio, p)
    shear = shear_modulus(material.shear_modulus, density_ratio, points.old.temperature[0], p, melting)[0]
    assert shear > 1.5 * material.elasticity.shear_modulus
    gamma = 1e-6
    points.deformation_gradient[0] = 0.93 * simple_shear([gamma])[0]
    points.advance(1e-6)
    assert points.new.stress[0, 3] == pytest.approx(shear * gamma, rel=1e-6)
    slope, by_energy = pressure(material.eos, 0.93**3, points.old.internal_energy[0])[1:]
    bulk = 0.93**3 * (slope - by_energy * p)
    speed = np.sqrt((bulk + 4.0 / 3.0 * shear) / (material.density * density_ratio))
    assert points.wave_speed[0] == pytest.approx(speed, rel=1e-6)


def test_a_point_melts_at_the_temperature_of_its_density():
    """Compressed it keeps its strength at a temperature where it has none at rest."""
    material = replace(metal("steinberg"), heating=None)
    hot = 1.05 * melting_temperature(material.melting)
    at_rest = drive(material, uniaxial_strain(np.array([1.0, 0.999, 0.998])), 1e-8, temperature=hot)
    assert at_rest.mises[-1] == 0.0
    squeezed = drive(material, uniaxial_strain(np.linspace(1.0, 0.9, 41)), 1e-8, temperature=hot)
    assert melting_temperature(material.melting, 1.0 / 0.9, 0.0) > 1.1 * hot
    assert squeezed.mises[-1] > 0.1e9


def test_nadal_le_poac_gives_the_elastic_modulus():
    """A law that needs melting temperature and density, at room temperature within 3 % of the measured modulus."""
    law = NadalLePoac(50.7e9, 0.04, 28e-12, 0.057, 63.55, 8930.0)
    material = replace(metal("preston"), shear_modulus=law)
    assert material.shear_at_rest(300.0) == shear_modulus(law, 1.0, 300.0, 0.0, 1356.0)[0]
    assert material.shear_at_rest(300.0) == pytest.approx(47.0e9, rel=0.03)
