"""The fields of a Material from the blocks of its card, with what a card leaves unsaid."""

import logging
from collections.abc import Mapping
from typing import Any, NamedTuple

from lxml import etree

from core_models.cards.models import Numbers, read_law, read_numbers
from core_models.cards.origins import origin, refusal
from core_models.compatibility import WHOLE_UPDATES
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.expansion.isotropic import IsotropicExpansion
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.schema import EXPANSION_COEFFICIENT, HEATED_FRACTION, SLOTS, UPDATE
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises

log = logging.getLogger(__name__)


class Blocks(NamedTuple):
    """A `<material>` element, its `<constitutive_model>`, and the children of both by canonical tag."""

    element: etree._Element
    model: etree._Element
    outer: Mapping[str, etree._Element]
    inner: Mapping[str, etree._Element]


def assembled_laws(blocks: Blocks, update: tuple, card: Numbers) -> dict[str, Any]:
    """The fields of the Material, except its name; `card` holds the plain numbers of both blocks."""
    fields: dict[str, Any] = {"density": card["density"], "update": update}
    constants, laws = _constants(card), _laws_given(blocks, card)
    if "elasticity" not in laws:
        fields["elasticity"] = IsotropicElastic(card["bulk_modulus"], card["shear_modulus"])
    fields |= constants | {
        slot: law for slot, law in laws.items() if law is not None or slot not in constants
    }
    if "eos" not in fields:
        fields["eos"] = _default_eos(blocks, update, card)
    if "yield_condition" not in fields and fields["flow"] is not None:
        fields["yield_condition"] = VonMises()
    fields["heating"] = _heating(blocks, fields)
    fields["expansion"] = _expansion(blocks, fields)
    return fields


def _laws_given(blocks: Blocks, card: Numbers) -> dict[str, Any]:
    laws = {}
    for slot in SLOTS:
        tag = slot.tags[0]
        block = blocks.outer.get(tag, blocks.inner.get(tag))
        if block is not None:
            laws[slot.slot] = read_law(block, slot, card)
        elif not slot.absent and slot is not UPDATE:
            raise refusal(
                blocks.model,
                f"<{blocks.model.tag}> lacks <{tag}>",
                f"add one of type {', '.join(slot.types)}",
            )
    return laws


def _constants(card: Numbers) -> dict[str, Any]:
    fields: dict[str, Any] = {name: card.get(name) for name in ("thermal_conductivity", "damage_radius")}
    if "room_temp" in card:
        fields["room_temperature"] = card["room_temp"]
    if "melt_temp" in card:
        fields["melting"] = ConstantMelting(card["melt_temp"])
    if "specific_heat" in card:
        fields["specific_heat"] = ConstantSpecificHeat(card["specific_heat"])
    return fields


def _default_eos(blocks: Blocks, update: tuple, card: Numbers) -> tuple | None:
    if isinstance(update, WHOLE_UPDATES) or "bulk_modulus" not in card:
        return None
    law = DefaultHypoelastic if isinstance(update, HypoelasticPlastic) else NeoHookean
    log.info("%s: no <equation_of_state>: %s is used", origin(blocks.model), law.__name__)
    return law(card["bulk_modulus"])


def _expansion(blocks: Blocks, fields: Mapping[str, Any]) -> tuple | None:
    """The expansion that the card states in a block, or by a plain coefficient from room temperature."""
    plain = blocks.inner.get(EXPANSION_COEFFICIENT.tag)
    if plain is not None and "expansion" in fields:
        raise refusal(plain, f"<{plain.tag}> stands beside a <thermal_expansion>", "delete one of them")
    coefficient = read_numbers(blocks.model, (EXPANSION_COEFFICIENT,), blocks.inner, {})[
        EXPANSION_COEFFICIENT.tag
    ]
    if coefficient == 0.0:
        return fields.get("expansion")
    return IsotropicExpansion(coefficient, fields.get("room_temperature", Material.room_temperature))


def _heating(blocks: Blocks, fields: Mapping[str, Any]) -> TaylorQuinney | None:
    """The heating that the card states, else Taylor-Quinney where heat arises and something feels it."""
    coefficient = blocks.inner.get(HEATED_FRACTION.tag)
    if "heating" in fields:
        if coefficient is not None:
            raise refusal(
                coefficient, f"<{coefficient.tag}> stands beside a <heating_model>", "delete one of them"
            )
        return fields["heating"]
    possible = fields["flow"] is not None and fields.get("specific_heat") is not None
    if coefficient is not None and not possible:
        raise refusal(
            coefficient,
            f"<{coefficient.tag}> heats nothing",
            "add <specific_heat> and a flow law, or delete it",
        )
    laws = (fields["flow"], fields.get("damage"), fields.get("shear_modulus"))
    felt = fields.get("melting") is not None or any(getattr(law, "uses_temperature", False) for law in laws)
    if not possible or not (felt or coefficient is not None):
        return None
    return TaylorQuinney(*read_numbers(blocks.model, (HEATED_FRACTION,), blocks.inner, {}).values())
