"""Drucker-Prager and Mohr-Coulomb: strengths, apex, cut-off, dilation, and what every plastic law must keep."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core_models.driver import drive, drive_program
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.errors import MaterialError
from core_models.flow.linear import LinearHardening
from core_models.kinematic_hardening.prager import Prager
from core_models.loading_paths import plane_strain, uniaxial_stress, volumetric
from core_models.material import Material
from core_models.paths import turned
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.mohr_coulomb import MohrCoulomb

COHESION = 1e6
BULK, SHEAR = 1e9, 0.6e9
SIN, COS = 0.5, math.sqrt(0.75)  # of 30 degrees
UPDATES = {"hypo": HypoelasticPlastic(), "hyper": HyperelasticPlastic()}
CONDITIONS = {
    "cone": DruckerPrager.from_friction(30, 10),
    "cone-cut": DruckerPrager.from_friction(30, 30, "extension", 0.3e6),
    "pyramid": MohrCoulomb(30, 10),
    "pyramid-cut": MohrCoulomb(30, 0, 0.5e6),
    "tresca": MohrCoulomb(0, 0),
}
FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]

pytestmark = pytest.mark.usefixtures("interpreted")


def soil(update, condition, modulus=0.0):
    """A soil of cohesion COHESION that hardens with a modulus [Pa]."""
    eos = DefaultHypoelastic(BULK) if update == "hypo" else NeoHookean(BULK)
    flow = LinearHardening(COHESION, modulus)
    condition = CONDITIONS.get(condition, condition)
    return Material("soil", 2000.0, UPDATES[update], IsotropicElastic(BULK, SHEAR), eos, flow, condition)


def measured(history, update):
    """Stress of the history in the update's measure: Cauchy or Kirchhoff [Pa]."""
    j = np.linalg.det(history.deformation_gradient)
    return history.stress * (1.0 if update == "hypo" else j[:, None])


def excess(condition, stress, cohesion):
    """How far stresses (k, 6) lie beyond a surface, worked out here once more [Pa]."""
    ordered = np.linalg.eigvalsh(stress[:, FULL])
    if isinstance(condition, MohrCoulomb):
        sine, cosine = (f(math.radians(condition.friction_angle)) for f in (math.sin, math.cos))
        low, high = ordered[:, 0], ordered[:, 2]
        beyond = high - low + (high + low) * sine - 2.0 * cohesion * cosine
        return np.maximum(beyond, high - condition.tension_cutoff)
    mean = ordered.mean(axis=1)
    root = np.sqrt(0.5 * ((ordered - mean[:, None]) ** 2).sum(axis=1))
    beyond = root + 3.0 * condition.alpha * mean - condition.cohesion_factor * cohesion
    return np.maximum(beyond, mean - condition.tension_cutoff)


def wild_path(steps, size, seed):
    """Random increments, each with a random strain and spin and a tendency to grow or shrink."""
    random = np.random.default_rng(seed)
    path = [np.eye(3)]
    for _ in range(steps):
        change = random.uniform(-size, size, (3, 3)) + random.uniform(-size, size) * np.eye(3)
        path.append((np.eye(3) + change) @ path[-1])
    return np.array(path)


@pytest.mark.parametrize(
    ("fit", "alpha", "k"),
    [("compression", 0.230940, 1.2), ("extension", 0.164957, 0.857143), ("plane-strain", 0.160128, 0.832050)],
)
def test_the_cone_is_matched_to_the_pyramid(fit, alpha, k):
    """The constants for 30 degrees and unit cohesion, to the digits of the table."""
    cone = DruckerPrager.from_friction(30.0, 30.0, fit)
    assert cone.alpha == pytest.approx(alpha, abs=5e-7) and cone.beta == cone.alpha
    assert cone.cohesion_factor == pytest.approx(k, abs=5e-7)


@pytest.mark.parametrize("update", UPDATES)
def test_strengths_in_compression_and_tension_are_the_closed_forms(update):
    """2 c cos / (1 - sin) in compression, 2 c cos / (1 + sin) in tension; each cone meets the pyramid where it must."""
    compression, tension = 2.0 * COHESION * COS / (1.0 - SIN), 2.0 * COHESION * COS / (1.0 + SIN)
    assert compression == pytest.approx(3.4641 * COHESION, rel=1e-5)
    for condition, strain, strength in (
        (MohrCoulomb(30, 10), -0.01, -compression),
        (MohrCoulomb(30, 10), 0.01, tension),
        (DruckerPrager.from_friction(30, 10), -0.01, -compression),
        (DruckerPrager.from_friction(30, 10, "extension"), 0.01, tension),
    ):
        history = drive_program(soil(update, condition), uniaxial_stress(strain, 1.0, steps=5))
        assert measured(history, update)[-1, 0] == pytest.approx(strength, rel=1e-8)


@pytest.mark.parametrize(
    "condition", [MohrCoulomb(30, 30), DruckerPrager.from_friction(30, 30, "plane-strain")]
)
def test_in_plane_strain_the_matched_cone_fails_where_the_pyramid_does(condition):
    """With associated flow, far in the plastic range, s_1 - s_3 + (s_1 + s_3) sin = 2 c cos in the plane."""
    history = drive_program(soil("hypo", condition), plane_strain(-0.04, 1.0, steps=20))
    assert -history.stress[-1, 0] * (1.0 - SIN) == pytest.approx(2.0 * COHESION * COS, rel=2e-4)


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize(
    ("condition", "limit"),
    [
        ("cone", COHESION * COS / SIN),
        ("cone-cut", 0.3e6),
        ("pyramid", COHESION * COS / SIN),
        ("pyramid-cut", 0.5e6),
    ],
)
def test_pulled_equally_the_apex_or_the_cut_off_holds(update, condition, limit):
    """The mean stress ends at c cot(friction), or at the cut-off, without shear, also without dilation."""
    history = drive_program(soil(update, condition), volumetric(0.02, 1.0, steps=4))
    assert measured(history, update)[-1] == pytest.approx([limit] * 3 + [0.0] * 3, rel=1e-8, abs=1e-3)
    cauchy = limit * (1.0 if update == "hypo" else math.exp(-0.02))
    assert history.fields["plastic_volume"][-1] == pytest.approx(0.02 - cauchy / BULK, rel=1e-4)


@pytest.mark.parametrize("angle", [0.0, 10.0, 30.0])
def test_the_volume_grows_with_the_angle_of_dilation(angle):
    """In uniaxial compression 2 sin / (1 - sin) times the axial plastic strain."""
    history = drive_program(soil("hypo", MohrCoulomb(30, angle)), uniaxial_stress(-0.02, 1.0, steps=4))
    young = 9.0 * BULK * SHEAR / (3.0 * BULK + SHEAR)
    axial = 0.02 + history.stress[-1, 0] / young
    sine = math.sin(math.radians(angle))
    assert history.fields["plastic_volume"][-1] == pytest.approx(2.0 * sine / (1.0 - sine) * axial, rel=1e-5)


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize("condition", CONDITIONS)
@pytest.mark.parametrize("size", [1e-3, 0.3])
def test_stress_stays_within_the_surface_and_flow_dissipates(update, condition, size):
    """To 1e-8 of the cohesion, hardening, in small steps and in those of 30 %, along a random path."""
    history = drive(soil(update, condition, 2e6), wild_path(25, size, 5), 1e-3)
    cohesion = COHESION + 2e6 * history.fields["equivalent_plastic_strain"]
    scale = cohesion + np.abs(history.stress).max(axis=1)
    assert (excess(CONDITIONS[condition], measured(history, update), cohesion) <= 1e-8 * scale).all()
    assert history.fields["equivalent_plastic_strain"][-1] > size
    assert np.diff(history.plastic).min() >= 0.0


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize("condition", ["cone", "pyramid-cut"])
def test_a_turned_path_turns_the_stress(update, condition):
    """With a large rotation on top of every step, stress is Q s Q^T and every scalar is the same."""
    path = wild_path(15, 0.02, 3)
    spin = Rotation.random(len(path), rng=np.random.default_rng(2)).as_matrix()
    spin[0] = np.eye(3)
    still = drive(soil(update, condition), path, 1e-3)
    moving = drive(soil(update, condition), turned(path, spin), 1e-3)
    expected = spin @ still.stress[:, FULL] @ spin.transpose(0, 2, 1)
    assert moving.stress[:, FULL] == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())
    for name in ("plastic_volume", "equivalent_plastic_strain"):
        assert moving.fields[name] == pytest.approx(still.fields[name], rel=1e-8)
    assert moving.plastic == pytest.approx(still.plastic, rel=1e-8)


def test_what_does_not_fit_is_refused():
    """Back stresses with Mohr-Coulomb, more dilation than friction: typed errors that say what fits."""
    fitting = soil("hypo", "pyramid")
    with pytest.raises(MaterialError, match="leads elsewhere: take vonMises or drucker_prager"):
        replace(fitting, kinematic_hardening=Prager(1e6))
    with pytest.raises(MaterialError, match="0 <= dilation <= friction"):
        DruckerPrager.from_friction(20, 30)
    with pytest.raises(MaterialError, match="did you mean 'compression'"):
        DruckerPrager.from_friction(30, 30, "compresion")
    assert "give dilation_angle" in MohrCoulomb(10, 20).fault()
