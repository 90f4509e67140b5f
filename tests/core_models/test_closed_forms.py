"""The stress updates against closed-form solutions of prescribed deformations."""

import numpy as np
import pytest

from core_models.driver import drive
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.linear import LinearHardening
from core_models.paths import principal_stretches, simple_shear, uniaxial_strain

SHEAR = 45.45e9
GREEN_NAGHDI = {  # gamma: stress 12 and 11 over the shear modulus
    0.5: (0.48051, 0.11886),
    1.0: (0.86978, 0.41590),
    2.0: (1.38629, 1.14159),
    4.0: (2.31794, 2.27420),
    6.0: (3.56616, 3.08185),
    10.0: (6.66598, 4.28172),
}


@pytest.fixture
def metal(copper):
    """Make a metal with linear hardening from its moduli and its strength [Pa]."""

    def make(update, bulk, shear, strength, modulus=0.0):
        return copper(
            update,
            LinearHardening(strength, modulus),
            elasticity=IsotropicElastic(bulk, shear),
            eos=DefaultHypoelastic(bulk) if update == "hypo" else NeoHookean(bulk),
        )

    return make


def dienes(gamma):
    """Stress 12 and 11 over the shear modulus in simple shear, Green-Naghdi rate."""
    b = np.arctan(gamma / 2)
    c2, s2, logarithm = np.cos(2 * b), np.sin(2 * b), np.log(np.cos(b))
    shear = 2 * c2 * (2 * b - 2 * np.tan(2 * b) * logarithm - np.tan(b))
    return shear, 4 * (c2 * logarithm + b * s2 - np.sin(b) ** 2)


def shear_error(material, gamma, steps):
    """Largest error of the stress at the end of a shear in even steps, over the shear modulus."""
    end = drive(material, simple_shear(np.linspace(0.0, gamma, steps + 1)), 1e-6).stress[-1] / SHEAR
    shear, normal = dienes(gamma)
    return np.abs(end - [normal, -normal, 0.0, shear, 0.0, 0.0]).max()


@pytest.mark.parametrize(("gamma", "printed"), GREEN_NAGHDI.items())
def test_large_simple_shear_follows_green_naghdi(pool, gamma, printed):
    """The hypoelastic update gives the Green-Naghdi stresses, which do not oscillate, up to gamma = 10."""
    end = drive(pool["hypo-elastic"], simple_shear(np.linspace(0.0, gamma, 2001)), 1e-6).stress[-1] / SHEAR
    assert end == pytest.approx([printed[1], -printed[1], 0.0, printed[0], 0.0, 0.0], abs=2e-5)


def test_simple_shear_converges_with_second_order(pool):
    """Halving the step in a shear to gamma = 4 divides the error by four."""
    errors = [shear_error(pool["hypo-elastic"], 4.0, steps) for steps in (50, 100, 200, 400)]
    assert np.all(np.diff(np.log2(errors)) < -1.95)
    assert errors[-1] < 2e-5


@pytest.mark.parametrize("name", ["hypo-elastic", "hyper-elastic", "hypo-linear", "hyper-linear"])
@pytest.mark.parametrize("gamma", [1e-7, -1e-5])
def test_shear_stress_is_shear_modulus_times_angle(pool, name, gamma):
    """In small shear the stress is G gamma, in one step and in ten: not twice that."""
    for steps in (1, 10):
        end = drive(pool[name], simple_shear(np.linspace(0.0, gamma, steps + 1)), 1e-6).stress[-1]
        assert end[3] == pytest.approx(SHEAR * gamma, rel=1e-8)
        assert np.abs(end[[0, 1, 2, 4, 5]]).max() <= 1.1 * SHEAR * gamma**2


@pytest.mark.parametrize(
    ("bulk", "shear", "strength", "printed"),
    [
        (136.35e9, 45.45e9, 89.6e6, 194.13),
        (130e9, 130e9 / 3, 400e6, 866.7),
        (66.4e9, 26e9, 324e6, 629.7),
        (173.33e9, 80e9, 792e6, 1386.0),
    ],
)
def test_elastic_limit_in_uniaxial_strain(metal, bulk, shear, strength, printed):
    """Under uniaxial compression yield begins at Y (K / 2G + 2/3), the Hugoniot elastic limit, in one elastic step."""
    material = metal("hypo", bulk, shear, strength)
    strain = -strength / (2.0 * shear)
    history = drive(material, uniaxial_strain(np.exp([0.0, strain, 2.0 * strain])), 1e-6)
    assert history.stress[1, 0] == pytest.approx(-printed * 1e6, rel=3e-4)
    assert history.fields["equivalent_plastic_strain"][1] == pytest.approx(0.0, abs=1e-8)
    assert history.fields["equivalent_plastic_strain"][2] > 1e-4
    assert history.stress[2, 0] - history.stress[2, 1] == pytest.approx(-strength, rel=1e-9)


def test_slopes_in_uniaxial_strain(metal):
    """E = 117 GPa, nu = 0.35, Y = 400 MPa, H = 100 MPa: slopes 187.778 and 130.0444 GPa, yield at 0.0046154."""
    material = metal("hypo", 130e9, 130e9 / 3, 400e6, 100e6)
    strain = np.linspace(0.0, 0.0092308, 401)
    history = drive(material, uniaxial_strain(np.exp(strain)), 1e-6)
    slopes = np.diff(history.stress[:, 0]) / np.diff(strain)
    assert slopes[:199] == pytest.approx(187.778e9, rel=1e-5)
    assert slopes[201:] == pytest.approx(130.0444e9, rel=1e-5)


STRETCHES = [1.0, 1.002043428, 1.006142645, 1.002043256, 0.997960739, 1.0]
STIFF_STRETCHES = [1.0, 1.001810424, 1.002252533, 1.00044131, 0.998192848, 1.0]


@pytest.mark.parametrize(
    ("bulk", "shear", "stretches", "axial", "lateral"),
    [
        (79e9, 70e9, STRETCHES, [351.79, 674.31, -29.27, -351.79, 0.0], [66.00, 388.52, 256.52, -66.00, 0.0]),
        (
            10e9,
            79e9,
            STIFF_STRETCHES,
            [208.61, 213.03, 4.41, -208.61, 0.0],
            [-77.18, -72.76, 4.41, 77.18, 0.0],
        ),
    ],
)
def test_loading_cycle_in_uniaxial_strain(metal, bulk, shear, stretches, axial, lateral):
    """Perfect plasticity (165 MPa in shear) through load, unload and reverse load, one step each: exact."""
    material = metal("hypo", bulk, shear, np.sqrt(3.0) * 165e6)
    stress = drive(material, uniaxial_strain(stretches), 1.0).stress[1:] / 1e6
    assert stress[:, 0] == pytest.approx(axial, abs=0.02)
    assert stress[:, 1] == pytest.approx(lateral, abs=0.02)


@pytest.mark.parametrize(("update", "tolerance"), [("hypo", 0.01), ("hyper", 0.1)])
def test_rotating_stress_path_at_constant_volume(metal, update, tolerance):
    """Krieg's exact solution [MPa] for perfect plasticity under a strain rate that does not follow the stress.

    It is one for logarithmic elastic strain; the neo-Hookean differs by the size of that strain, 1e-3.
    """
    material = metal(update, 100e9, 79e9, np.sqrt(3.0) * 165e6)
    first = np.outer(np.linspace(0.0, 1.0, 1001), [-0.003, -0.003, 0.006])
    second = first[-1] + np.outer(np.linspace(0.0, 1.0, 1001)[1:], [-0.0073923, 0.003, 0.0043923])
    path = principal_stretches(*np.exp(np.vstack([first, second])).T)
    stress = drive(material, path, 1e-3).stress[:, :3] / 1e6
    assert stress[1000] == pytest.approx([-95.263, -95.263, 190.526], abs=tolerance)
    assert stress[2000] == pytest.approx([-189.365, 76.496, 112.869], abs=tolerance)


@pytest.mark.parametrize("update", ["hypo", "hyper"])
@pytest.mark.parametrize(
    ("modulus", "printed"),
    [(0.0, [5, 5, 5, 5, 5, 5, 3.915, 5]), (62.5e9, [5, 5.862, 5.482, 6.361, 6.635, 7.313, 4.189, 5.623])],
)
def test_nafems_plane_strain_path(metal, update, modulus, printed):
    """Equivalent stress [MPa] at the corners of NAFEMS' plasticity benchmark NL1, with 1000 substeps a segment."""
    material = metal(update, 250e9 / 1.5, 100e9, 5e6, modulus)
    corners = np.array([(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1), (0, 0)])
    strains = [np.interp(np.arange(8001), np.arange(0, 8001, 1000), 0.25e-4 * corner) for corner in corners.T]
    stress = drive(material, principal_stretches(*np.exp(strains), np.ones(8001)), 1e-3).stress[1000::1000]
    deviator = stress[:, :3] - stress[:, :3].mean(axis=1, keepdims=True)
    assert np.sqrt(1.5 * (deviator**2).sum(axis=1)) / 1e6 == pytest.approx(printed, abs=2e-3)
