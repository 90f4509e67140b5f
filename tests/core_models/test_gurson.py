"""Gurson-Tvergaard-Needleman: intercepts, growth and nucleation of voids, another code's curve, and failure."""

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core_models.damage.gurson import VoidNucleation
from core_models.driver import drive, drive_program
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.errors import MaterialError
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.flow.perfect import PerfectPlasticity
from core_models.laws import nucleated
from core_models.loading_paths import volumetric
from core_models.material import Material
from core_models.paths import simple_shear, turned
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.gurson_surface import effective_porosity, yield_function
from core_models.yield_condition.von_mises import VonMises
from tests.core_models.test_general_tangent import mismatch, plain  # noqa: F401

NEML2 = Path(__file__).parent / "neml2_gurson.csv"
UPDATES = {"hypo": HypoelasticPlastic, "hyper": HyperelasticPlastic}
PLAIN, TVERGAARD = Gurson(1.0, 1.0, 1.0, 1.0, 0.9), Gurson(1.5, 1.0, 2.25, 4.0, 0.05)
STRENGTH, YOUNG = 400e6, 200e9
FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]
"""Rows of the intercept table: f, then p and q over sigma_y for (1, 1, 1) and for (1.5, 1, 2.25)."""
INTERCEPTS = [
    (0.001, 4.60517, 0.9990, 4.33486, 0.9985),
    (0.005, 3.53221, 0.9950, 3.26190, 0.9925),
    (0.01, 3.07011, 0.9900, 2.79980, 0.9850),
    (0.05, 1.99715, 0.9500, 1.72684, 0.9250),
    (0.1, 1.53506, 0.9000, 1.26475, 0.8500),
    (0.2, 1.07296, 0.8000, 0.80265, 0.7000),
]

pytestmark = pytest.mark.usefixtures("interpreted")


def metal(update, condition, voids, flow=None, tolerance=1e-10):
    """A porous metal."""
    elastic = IsotropicElastic.from_young(YOUNG, 0.3)
    bulk = elastic.bulk_modulus
    eos = DefaultHypoelastic(bulk) if update == "hypo" else NeoHookean(bulk)
    flow = flow or PerfectPlasticity(STRENGTH)
    return Material("porous", 7850.0, UPDATES[update](tolerance), elastic, eos, flow, condition, damage=voids)


def wild_path(steps, size, seed=1):
    """Random increments, each with a random strain, spin and change of volume."""
    random = np.random.default_rng(seed)
    path = [np.eye(3)]
    for _ in range(steps):
        change = random.uniform(-size, size, (3, 3)) + random.uniform(-0.1, 1.0) * size * np.eye(3)
        path.append((np.eye(3) + change) @ path[-1])
    return np.array(path)


def mises(stress):
    """Von Mises' equivalent of stresses (k, 6)."""
    s = stress.copy()
    s[:, :3] -= s[:, :3].mean(axis=1, keepdims=True)
    return np.sqrt(1.5 * ((s[:, :3] ** 2).sum(axis=1) + 2.0 * (s[:, 3:] ** 2).sum(axis=1)))


@pytest.mark.parametrize("row", INTERCEPTS)
def test_intercepts_are_those_of_the_table(row):
    """The surface cuts the axes of the mean and of the equivalent stress where the table says."""
    porosity, *values = row
    for (q1, q3), mean, equivalent in (((1.0, 1.0), *values[:2]), ((1.5, 2.25), *values[2:])):
        law = Gurson(q1, 1.0, q3, 1.0, 0.6)
        around = [yield_function(law, 0.0, mean + part, 1.0, porosity) for part in (-6e-6, 6e-6)]
        assert around[0] < 0.0 < around[1]
        assert yield_function(law, equivalent, 0.0, 1.0, porosity) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("row", INTERCEPTS)
def test_equal_pull_on_all_sides_ends_at_the_hydrostatic_limit(row):
    """Such a body returns to a mean stress of 2 / (3 q2) ln(1 / (q1 f)) sigma_y, at the porosity that it then has."""
    for law in (PLAIN, TVERGAARD._replace(k=1.0, f_c=0.6)):
        history = drive_program(
            metal("hypo", law, VoidNucleation(row[0], 0.0, 0.3, 0.1)), volumetric(0.02, 1.0, steps=2)
        )
        porosity = history.fields["porosity"][-1]
        limit = -2.0 / 3.0 * np.log(law.q1 * porosity) * STRENGTH
        assert history.stress[-1, :3] == pytest.approx(limit, rel=1e-8)


def test_small_strain_curve_of_another_code_is_met():
    """NEML2's uniaxial strain curve (fully implicit, small strain) within 1 %, at every point."""
    strain, axial, lateral = np.loadtxt(NEML2, delimiter=",").T
    elastic = IsotropicElastic.from_young(3e10, 0.3)
    material = Material(
        "neml2", 1e3, HypoelasticPlastic(), elastic, DefaultHypoelastic(elastic.bulk_modulus),
        PerfectPlasticity(60e6), Gurson(1.25, 1.0, 1.57, 1.0, 0.5), damage=VoidNucleation(0.002, 0.0, 0.3, 0.1),
    )  # fmt: skip
    path = np.tile(np.eye(3), (len(strain), 1, 1))
    path[:, 0, 0] = np.exp(strain)
    history = drive(material, path, 1e-2)
    assert history.stress[1:, 0] == pytest.approx(1e6 * axial[1:], rel=0.01)
    assert history.stress[1:, 1] == pytest.approx(1e6 * lateral[1:], rel=0.01)


@pytest.mark.parametrize(
    ("start", "strain", "end"),
    [
        (0.001, 0.01, 0.01094),
        (0.001, 0.05, 0.04972),
        (0.001, 0.1, 0.09607),
        (0.001, 0.2, 0.18209),
        (0.01, 0.01, 0.01985),
        (0.01, 0.05, 0.05828),
        (0.01, 0.1, 0.10421),
        (0.01, 0.2, 0.18946),
    ],
)
def test_voids_grow_with_the_plastic_volume(start, strain, end):
    """f = 1 - (1 - f_0) exp(-v_p), as in the table; pulled equally on all sides, in four steps."""
    material = metal("hypo", PLAIN, VoidNucleation(start, 0.0, 0.3, 0.1), PerfectPlasticity(0.1 * STRENGTH))
    history = drive_program(material, volumetric(strain, 1.0, steps=4))
    grown = history.fields["plastic_volume"][-1]
    assert history.fields["porosity"][-1] == pytest.approx(1.0 - (1.0 - start) * np.exp(-grown), rel=1e-12)
    assert 1.0 - (1.0 - start) * np.exp(-strain) == pytest.approx(end, abs=5e-6)
    assert grown == pytest.approx(strain - history.stress[-1, 0] / material.elasticity.bulk_modulus, rel=1e-6)
    assert yield_function(
        PLAIN, 0.0, history.stress[-1, 0], 0.1 * STRENGTH, history.fields["porosity"][-1]
    ) == pytest.approx(0.0, abs=1e-8)


def test_voids_nucleate_with_the_strain_of_the_matrix():
    """The integral of the normal distribution, to the digits of the table, whatever the steps."""
    law = VoidNucleation(0.0, 0.04, 0.3, 0.1)
    for strain, expected in ((0.1, 0.00086), (0.2, 0.00629), (0.3, 0.01995), (0.5, 0.03904)):
        assert nucleated(law, 0.0, strain)[0] == pytest.approx(expected, abs=5e-6)
    step = 1e-6
    slope = (nucleated(law, 0.1, 0.1 + step)[0] - nucleated(law, 0.1, 0.1 - step)[0]) / (2.0 * step)
    assert nucleated(law, 0.1, 0.1)[1] == pytest.approx(slope, rel=1e-6)


def test_coalescence_is_accelerated_and_ends_at_the_full_porosity():
    """f* = f, then f_c + k (f - f_c), up to 99 % of 1 / q1, where the damage is 1."""
    for porosity, expected in ((0.04, 0.04), (0.05, 0.05), (0.1, 0.25), (0.9, 0.99 / 1.5)):
        assert effective_porosity(TVERGAARD, porosity)[0] == pytest.approx(expected, rel=1e-12)
    history = drive(metal("hypo", TVERGAARD, VoidNucleation(0.01, 0.0, 0.3, 0.1)), wild_path(12, 0.1), 1e-3)
    assert history.fields["damage"][0] == 0.0 and history.fields["damage"].max() <= 1.0


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize("size", [2e-3, 0.2])
def test_stress_stays_within_the_surface_and_flow_dissipates(update, size):
    """To 1e-8, with hardening, growth, nucleation and coalescence, in small steps and in those of 20 %."""
    flow = LinearHardening(STRENGTH, 1e9)
    history = drive(
        metal(update, TVERGAARD, VoidNucleation(0.002, 0.04, 0.1, 0.05), flow), wild_path(25, size), 1e-3
    )
    j = np.linalg.det(history.deformation_gradient)[:, None]
    stress = history.stress * (1.0 if update == "hypo" else j)
    strength = STRENGTH + 1e9 * history.fields["equivalent_plastic_strain"]
    points = zip(mises(stress), stress[:, :3].mean(axis=1), strength, history.fields["porosity"], strict=True)
    assert max(yield_function(TVERGAARD, *point) for point in points) <= 1e-8
    assert history.fields["porosity"].max() > 0.004
    assert np.diff(history.plastic).min() >= 0.0


def test_a_turned_path_turns_the_stress():
    """With a large rotation on top of every step, stress is Q s Q^T and the porosity is the same."""
    path = wild_path(12, 0.02)
    spin = Rotation.random(len(path), rng=np.random.default_rng(2)).as_matrix()
    spin[0] = np.eye(3)
    for update in UPDATES:
        material = metal(update, TVERGAARD, VoidNucleation(0.01, 0.04, 0.1, 0.05))
        still, moving = (drive(material, each, 1e-3) for each in (path, turned(path, spin)))
        expected = spin @ still.stress[:, FULL] @ spin.transpose(0, 2, 1)
        assert moving.stress[:, FULL] == pytest.approx(expected, abs=1e-7 * np.abs(expected).max())
        assert moving.fields["porosity"] == pytest.approx(still.fields["porosity"], rel=1e-7)


def test_without_voids_it_is_von_mises():
    """Porosity 0 and no nucleation: the stress of the scalar return."""
    path = simple_shear(np.linspace(0.0, 0.3, 7))
    porous = drive(metal("hypo", TVERGAARD, VoidNucleation(0.0, 0.0, 0.3, 0.1)), path, 1e-3)
    elastic = porous.stress[-1, 3]
    solid = drive(metal("hypo", VonMises(), None), path, 1e-3)
    assert porous.stress == pytest.approx(solid.stress, abs=1e-8 * elastic)


def test_pressure_closes_the_voids_for_good():
    """Far below the pressure that opens any, the porosity is 0, the volume that of the matrix, its strength left."""
    material = metal("hypo", TVERGAARD, VoidNucleation(0.05, 0.0, 0.3, 0.1))
    path = np.array([np.eye(3), 0.9 * np.eye(3), 0.9 * np.eye(3)])
    path[2, 0, 1] = 0.1
    history = drive(material, path, 1e-3)
    assert history.fields["porosity"][1:] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert history.fields["plastic_volume"][1] == pytest.approx(np.log(0.95), rel=1e-9)
    assert history.mises[2] == pytest.approx(STRENGTH, rel=1e-9)
    assert np.diff(history.plastic).min() >= 0.0


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize("strains", [[0.01, 0.008, 0.005], [0.02, -0.008, -0.009], [-0.03, 0.005, -0.02]])
def test_the_tangent_is_the_derivative(update, strains):
    """To 1e-6 against central differences, voids and their nucleation included."""
    flow = LinearHardening(STRENGTH, 1e9)
    material = metal(update, TVERGAARD, VoidNucleation(0.02, 0.04, 0.02, 0.01), flow, tolerance=1e-14)
    assert mismatch(material, np.diag(strains)) <= 1e-6


@pytest.mark.parametrize("update", UPDATES)
def test_a_matrix_that_heat_has_left_without_strength_is_a_fluid(update):
    """Above the T_m of its flow law, without a melting law, the body carries pressure alone and still can be led."""
    hot = JohnsonCook(90e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0)
    body = metal(update, TVERGAARD, VoidNucleation(1e-3, 0.04, 0.3, 0.1), hot)
    path = wild_path(3, 0.1)
    history = drive(body, path, 1e-3, temperature=2000.0)
    volume = np.linalg.det(path)
    law = np.log(volume) if update == "hypo" else 0.5 * (volume - 1.0 / volume)
    assert -history.pressure == pytest.approx(body.eos.bulk_modulus * law, rel=1e-9, abs=1.0)
    assert history.mises == pytest.approx(0.0, abs=1.0)


@pytest.mark.parametrize(("porosity", "value"), [(0.02, -0.113219), (0.08, 0.405263)])
def test_yield_function_before_and_after_coalescence(porosity, value):
    """At q = 0.9 sigma_y and a mean stress of half sigma_y."""
    assert yield_function(TVERGAARD, 0.9, 0.5, 1.0, porosity) == pytest.approx(value, abs=0.5e-6)


def test_what_does_not_fit_is_refused():
    """Voids go with this yield condition and it with them; coalescence begins before nothing carries."""
    with pytest.raises(MaterialError, match="take the damage law gurson_voids"):
        metal("hypo", TVERGAARD, None)
    with pytest.raises(MaterialError, match="take the yield condition gurson"):
        metal("hypo", VonMises(), VoidNucleation(0.01, 0.0, 0.3, 0.1))
    assert "give less than 0.66" in Gurson(1.5, 1.0, 2.25, 4.0, 0.7).fault()
