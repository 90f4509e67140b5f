"""The average of a nonlocal damage: its weights, and what it leaves alone."""

import numpy as np
import pytest

from core_models.cards import material_element, parse_material
from core_models.damage.gurson import VoidNucleation
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.errors import MaterialError
from core_models.nonlocal_average import NonlocalAverage, bell_weights
from core_models.points import MaterialPoints
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.gurson_surface import effective_porosity

PLACES = np.random.default_rng(3).uniform(0.0, 1.0, (300, 2))
VOLUMES = np.random.default_rng(4).uniform(0.5, 1.5, 300)


def test_constants_stay_what_they_are():
    """Rows sum up to 1, at the edges of the body as well, and no weight is negative."""
    weights = bell_weights(PLACES, VOLUMES, 0.2)
    assert weights @ np.full(300, 0.7) == pytest.approx(np.full(300, 0.7), rel=1e-14)
    assert weights.data.min() > 0.0


def test_weights_are_those_of_the_bell():
    """V alpha(r) over its sum, worked out pair by pair."""
    weights = bell_weights(PLACES, VOLUMES, 0.2).toarray()
    distances = np.linalg.norm(PLACES[:, None] - PLACES, axis=2)
    bells = np.where(distances < 0.2, (1.0 - (distances / 0.2) ** 2) ** 2, 0.0) * VOLUMES
    assert weights == pytest.approx(bells / bells.sum(axis=1, keepdims=True), rel=1e-12)


def test_a_neighbourhood_without_neighbours_is_local():
    """A radius below the distance of the points changes no bit."""
    before, after = np.zeros(300), np.random.default_rng(5).uniform(0.0, 1.0, 300)
    kept = after.copy()
    NonlocalAverage(PLACES, VOLUMES, 1e-9).apply(before, after, before < 1.0)
    assert np.array_equal(after, kept)


def test_failed_points_take_no_part():
    """They neither give nor take; all others never lose damage."""
    before, after = np.full(300, 0.2), np.full(300, 0.3)
    before[:50], after[:50] = 1.5, 9.0
    NonlocalAverage(PLACES, VOLUMES, 0.2).apply(before, after, before < 1.0)
    assert np.all(after[:50] == 9.0)
    assert np.all(after[50:] >= 0.2) and np.all(after[50:] <= 0.3 + 1e-15)


@pytest.mark.usefixtures("interpreted")
def test_points_average_what_a_step_adds(copper):
    """Between a step and the next the growth spreads; points that were never connected keep theirs."""
    damage = JohnsonCookDamage(0.54, 4.89, -3.03, 0.014, 1.12, 294.0, 1356.0)
    material = copper("hypo", "linear", damage=damage, damage_radius=2.5)
    grown = []
    for is_connected in (True, False):
        points = MaterialPoints(material, np.ones(5))
        if is_connected:
            points.connect(np.arange(5.0)[:, None])
        points.deformation_gradient[2] += 0.1 * np.eye(3)[[1, 0, 2]]
        points.advance(1e-6)
        points.accept()
        grown.append(points.old.damage)
    assert np.count_nonzero(grown[0]) == 5 and np.count_nonzero(grown[1]) == 1
    assert grown[0][2] < grown[1][2] and grown[0][1] == grown[0][3]


@pytest.mark.usefixtures("interpreted")
def test_points_average_the_growth_of_voids(copper):
    """Their damage follows the porosity that is spread; what has failed keeps its own, and gives none."""
    condition, voids = Gurson(1.5, 1.0, 2.25, 4.0, 0.05), VoidNucleation(0.01, 0.0, 0.3, 0.1)
    material = copper("hypo", "linear", yield_condition=condition, damage=voids, damage_radius=2.5)
    points = MaterialPoints(material, np.ones(5))
    points.connect(np.arange(5.0)[:, None])
    points.old.porosity[4], points.old.damage[4] = 0.5, 1.0
    points.deformation_gradient[[2, 4]] *= 1.02
    points.advance(1e-6)
    alone = points.new.porosity.copy()
    points.accept()
    porosity, damage = points.old.porosity, points.old.damage
    assert 0.01 < porosity[1] == porosity[3] < porosity[2] < alone[2] and porosity[4] == alone[4] > 0.5
    assert damage[:4] == pytest.approx(
        [effective_porosity(condition, f)[0] * 1.5 / 0.99 for f in porosity[:4]]
    )
    assert damage[4] == 1.0


@pytest.mark.parametrize(("radius", "damage"), [(-1.0, True), (0.0, True), (1e-3, False)])
def test_a_radius_that_makes_no_sense_is_refused(copper, radius, damage):
    """Not positive, or without damage."""
    law = JohnsonCookDamage(0.54, 4.89, -3.03, 0.014, 1.12, 294.0, 1356.0) if damage else None
    with pytest.raises(MaterialError, match="damage_radius"):
        copper("hypo", "linear", damage=law, damage_radius=radius)


def test_cards_give_the_radius(read_card):
    """A plain tag of the material, written and read back."""
    density = "<density>8930.0</density>"
    damage = '<damage_model type="johnson_cook">'
    card = read_card(
        (density, density + "<damage_radius>1e-3</damage_radius>"),
        (damage, damage + "<coupling>0.5</coupling>"),
    )
    assert parse_material(material_element(card.material)).material == card.material
    assert card.material.damage_radius == 1e-3 and card.material.damage.coupling == 0.5
