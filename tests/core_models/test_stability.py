"""Stability checks: where the second-order work and the acoustic tensor of continued flow are lost."""

from dataclasses import replace

import numpy as np
import pytest

from core_models import points as points_module
from core_models.cards.reader import read_material
from core_models.cards.writer import write_material
from core_models.driver import drive
from core_models.errors import UnsupportedError
from core_models.flow.voce import Voce
from core_models.paths import simple_shear
from core_models.points import MaterialPoints
from core_models.stability.drucker import DruckerStability
from core_models.stability.hyperbolicity import HyperbolicityLoss
from core_models.threads import Threads
from core_models.updates.continuing_tangent import continuing_tangents

BULK, SHEAR = 136.35e9, 45.45e9
NU = (3.0 * BULK - 2.0 * SHEAR) / (6.0 * BULK + 2.0 * SHEAR)
YIELD = 100e6
TENSION = np.array([YIELD, 0.0, 0.0, 0.0, 0.0, 0.0])
PURE_SHEAR = np.array([0.0, 0.0, 0.0, YIELD / np.sqrt(3.0), 0.0, 0.0])
LAWS = {"drucker": DruckerStability(), "acoustic": HyperbolicityLoss()}


def measure(copper, law, stress, modulus):
    """Measure of a point at yield under a stress, with a hardening modulus [Pa]."""
    rate = 2.0 * modulus / YIELD
    flow = Voce(YIELD, 1.5 * YIELD, rate, 0.0) if modulus > 0.0 else Voce(YIELD, 0.5 * YIELD, -rate, 0.0)
    points = MaterialPoints(copper("hypo", flow, stability=LAWS[law]), np.ones(1))
    points.old.stress[0] = stress
    return points.stability()[0]


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("stress", [TENSION, PURE_SHEAR])
def test_druckers_measure_is_that_of_the_hardening_modulus(copper, stress):
    """H / (3 G + H), to the size of the elastic strain."""
    for modulus in (5e9, 1e9, -1e9, -5e9):
        expected = modulus / (3.0 * SHEAR + modulus)
        assert measure(copper, "drucker", stress, modulus) == pytest.approx(expected, abs=2.0 * YIELD / SHEAR)


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize(("stress", "critical"), [(PURE_SHEAR, 0.0), (TENSION, -0.5 * SHEAR * (1.0 + NU))])
def test_hyperbolicity_is_lost_at_the_modulus_of_rudnicki_and_rice(copper, stress, critical):
    """In shear where hardening ends, in tension at H = -G (1 + nu) / 2 only."""
    margin = 0.02 * SHEAR
    assert measure(copper, "acoustic", stress, critical + margin) > 1e-4
    assert measure(copper, "acoustic", stress, critical - margin) < -1e-4


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_the_body_at_rest_is_stable(copper, update):
    """Elastic: 1 by both measures."""
    for law in LAWS.values():
        points = MaterialPoints(copper(update, "linear", stability=law), np.ones(3))
        assert points.stability() == pytest.approx(np.ones(3), abs=1e-12)


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_a_shear_band_can_form_where_adiabatic_shear_softens(hot_copper, update):
    """The acoustic measure passes zero where the shear stress passes its top, heat included, rate dependence apart."""
    material = hot_copper(update, "jc", damage=None, stability=HyperbolicityLoss())
    gamma = np.linspace(0.0, 4.0, 201)
    history = drive(material, simple_shear(gamma), 1e-5)
    lost = gamma[1:][history.fields["stability"][1:] <= 0.0]
    top = gamma[history.stress[:, 3].argmax()]
    assert 3.0 < top < 3.9
    assert lost[0] == pytest.approx(top, abs=0.15)
    assert np.all(history.fields["stability"][1:][gamma[1:] < lost[0]] > 0.0)
    cold = drive(replace(material, heating=None), simple_shear(gamma[::8]), 1e-5)
    assert np.all(cold.fields["stability"] > 0.0)


@pytest.mark.usefixtures("interpreted")
def test_a_melted_point_has_nothing_to_lose(hot_copper):
    """It counts as elastic."""
    points = MaterialPoints(hot_copper("hypo", "jc", stability=HyperbolicityLoss()), np.ones(1))
    points.old.temperature[0] = 1400.0
    assert points.stability()[0] == pytest.approx(1.0, rel=0.05)


def test_no_law_no_field(copper):
    """Without a law there is no field, and the measure says what to add."""
    points = MaterialPoints(copper("hypo", "linear"), np.ones(1))
    assert "stability" not in points.fields()
    with pytest.raises(UnsupportedError, match="give it one, such as drucker"):
        points.stability()


@pytest.mark.parametrize("name", LAWS)
def test_a_card_states_the_check(copper, tmp_path, name):
    """Written and read again."""
    material = replace(copper("hyper", "linear", stability=LAWS[name]), name="checked")
    write_material(material, tmp_path / "card.xml")
    assert f'<stability_check type="{name}"/>' in (tmp_path / "card.xml").read_text()
    assert read_material(tmp_path / "card.xml").material == material


def test_the_compiled_tangent_is_that_of_plain_python(copper, monkeypatch):
    """Of points at different strains, on one thread and on two."""
    material = copper("hypo", "linear", stability=DruckerStability())
    measures = []
    for threads in (1, 2):
        points = MaterialPoints(material, np.ones(600), threads=Threads(threads))
        points.deformation_gradient[:, 0, 1] = np.linspace(0.0, 0.1, points.n)
        points.advance(1.0)
        points.accept()
        measures.append(points.stability())
    assert np.array_equal(*measures)
    kernel = getattr(continuing_tangents, "py_func", continuing_tangents)
    monkeypatch.setattr(points_module, "continuing_tangents", kernel)
    assert points.stability() == pytest.approx(measures[0], rel=1e-10)
