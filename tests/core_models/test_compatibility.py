"""The table of what fits together is true: every pair of laws is built and driven, or refused with its reason."""

from itertools import combinations, product

import numpy as np
import pytest

from core_models.compatibility import CLASHES, WHOLE_UPDATES, clash_of
from core_models.damage.gurson import VoidNucleation
from core_models.driver import drive
from core_models.errors import MaterialError
from core_models.heating.isentropic import IsentropicHeating
from core_models.laws import elastic_moduli
from core_models.material import SLOTS as MATERIAL_SLOTS
from core_models.material import Material, laws_for
from core_models.paths import simple_shear
from core_models.points import MaterialPoints
from core_models.schema import SLOTS
from core_models.yield_condition.gurson import Gurson
from studies.laws.compatibility_text import compatibility_text
from studies.laws.sample_laws import DENSITY, SAMPLES

BASE = {"flow": "LinearHardening", "yield_condition": "VonMises", "specific_heat": "ConstantSpecificHeat"}
PATH = simple_shear(np.array([0.0, 0.02, 0.05]))
HEATED_BY_VOLUME = {IsentropicHeating}
FREE = [slot for slot in SAMPLES if slot not in ("update", "elasticity")]


def sample(slot, name):
    """The sample law of a slot by its class name."""
    return next(law for law in SAMPLES[slot] if type(law).__name__ == name)


def material(update, laws):
    """A material of these laws, with what else they need."""
    fields = {"update": update, "elasticity": SAMPLES["elasticity"][0]}
    if not isinstance(update, WHOLE_UPDATES):
        fields |= {slot: sample(slot, name) for slot, name in BASE.items()}
        fields |= {
            "eos": sample(
                "eos", "MieGruneisen" if HEATED_BY_VOLUME & set(map(type, laws.values())) else "NeoHookean"
            )
        }
        fields |= {"damage": sample("damage", "JohnsonCookDamage")} if "erosion" in laws else {}
        kinds = set(map(type, laws.values()))
        if Gurson in kinds or VoidNucleation in kinds:
            fields |= {"yield_condition": sample("yield_condition", "Gurson")}
            fields |= {"damage": sample("damage", "VoidNucleation")}
        fields |= {"melting": sample("melting", "ConstantMelting")} if "shear_modulus" in laws else {}
    return Material("pair", DENSITY, **(fields | laws))


def test_every_law_of_the_cards_is_among_the_samples():
    """A law that is added comes with a sample, and is then tried with all others."""
    for slot in SLOTS:
        sampled = {type(law) for law in SAMPLES.get(slot.slot, ())}
        assert {model.law for model in slot.models} <= sampled, slot.slot
    for slot in MATERIAL_SLOTS:
        shipped = {law for law in laws_for(slot) if law.__module__.startswith("core_models.")}
        assert shipped == {type(law) for law in SAMPLES[slot]}, slot


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", SAMPLES["update"], ids=lambda law: type(law).__name__)
@pytest.mark.parametrize("slots", list(combinations(FREE, 2)), ids="-".join)
def test_every_pair_of_laws_is_driven_or_refused(update, slots):
    """What the table lets through runs, in plain Python; what it does not is refused with the table's words."""
    for pair in product(*(SAMPLES[slot] for slot in slots)):
        laws = dict(zip(slots, pair, strict=True))
        told = [clash_of("update", type(update), slot, type(law)) for slot, law in laws.items()]
        told += [clash_of(slots[0], type(pair[0]), slots[1], type(pair[1]))]
        reasons = [f"{clash.why}: {clash.remedy}" for clash in told if clash]
        if reasons:
            with pytest.raises(MaterialError) as refused:
                material(update, laws)
            assert any(reason in str(refused.value) for reason in reasons)
        else:
            history = drive(material(update, laws), PATH, 1e-6)
            assert np.isfinite(history.stress).all() and np.isfinite(history.stress_work).all()
            assert history.mises[-1] > 1e6


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", SAMPLES["update"][:2], ids=lambda law: type(law).__name__)
@pytest.mark.parametrize("damage", SAMPLES["damage"], ids=lambda law: type(law).__name__)
def test_every_damage_can_be_nonlocal(update, damage):
    """Points that a step leaves alone get a share of the damage of their neighbours, whatever the law."""
    points = MaterialPoints(material(update, {"damage": damage, "damage_radius": 2.5}), np.ones(3))
    points.connect(np.arange(3.0)[:, None])
    before = points.old.damage.copy()
    points.deformation_gradient[0] += 0.05 * np.eye(3)[[1, 0, 2]]
    points.advance(1e-3)
    points.accept()
    growth = points.old.damage - before
    assert 0.0 < growth[2] < growth[1] < growth[0]


@pytest.mark.parametrize("clash", CLASHES, ids=lambda clash: f"{clash.slot}-{clash.other}-{clash.why[:20]}")
def test_every_row_says_why_and_what_would_fit(clash):
    """Two sentences, and the printed table has them."""
    assert clash.why and clash.remedy
    assert clash.why in compatibility_text() and clash.remedy in compatibility_text()


def test_the_table_names_every_law():
    """Each law of the cards stands in it with a verdict for each update."""
    text = compatibility_text()
    for slot in SLOTS:
        for model in slot.models:
            assert model.law.__name__ in text
    assert elastic_moduli is MATERIAL_SLOTS["elasticity"]
