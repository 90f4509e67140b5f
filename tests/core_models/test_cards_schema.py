"""The schema and the laws say the same."""

import pytest

from core_models.cards import DATA_FOLDER
from core_models.schema import BODY, CONSTANTS, CYLINDER, ELASTICITY, SLOTS, Interval
from core_models.schema.entries import NOT_NEGATIVE, POSITIVE, ZERO

MODELS = [model for slot in SLOTS for model in slot.models]
TAGS = [p for model in MODELS for p in model.parameters] + [*CONSTANTS, *ELASTICITY, *CYLINDER, *BODY]


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.types[0])
def test_every_field_of_a_law_has_one_tag(model):
    """A law's fields are fed by exactly the tags of its schema."""
    assert sorted(p.field for p in model.parameters) == sorted(model.law._fields)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.types[0])
def test_names_of_one_block_are_unique(model):
    """No tag or alias means two things in a block."""
    names = [name for p in model.parameters for name in (p.tag, *p.aliases)] + [i.tag for i in model.inert]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("slot", SLOTS, ids=lambda slot: slot.slot)
def test_types_of_one_slot_are_unique(slot):
    """No type name selects two models, and none is both available and not."""
    names = [name for model in slot.models for name in model.types] + [*slot.plain, *slot.unavailable]
    assert len(names) == len(set(names))


def test_every_tag_says_what_it_is():
    """Each tag has a unit and a help text; defaults lie in the tag's range."""
    for parameter in TAGS:
        assert parameter.unit
        assert parameter.help
        assert parameter.default is None or parameter.default in parameter.range
        assert parameter.requirement


def test_ranges_in_words():
    """Ranges read as they are meant."""
    assert [str(r) for r in (POSITIVE, NOT_NEGATIVE, Interval(0.0, 1.0, low_open=True), Interval())] == [
        "> 0",
        ">= 0",
        "> 0 and <= 1",
        "any number",
    ]
    assert 0.0 in ZERO
    assert 0.0 not in POSITIVE
    assert float("nan") not in Interval()


def test_founding_cards_are_shipped():
    """The founding documents' hrefs resolve in the shipped data."""
    names = {path.name for path in (DATA_FOLDER / "inputs/MPM/MaterialData").iterdir()}
    assert names == {
        "IsotropicElasticAnnCopper.xml",
        "JohnsonCookDamageAnnCopper.xml",
        "JohnsonCookPlasticAnnCopper.xml",
        "MTSPlasticAnnCopper.xml",
        "MaterialConstAnnCopper.xml",
        "MieGruneisenEOSAnnCopper.xml",
    }
