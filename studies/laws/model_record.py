"""The material laws and what fits together, as plain data."""

import inspect
from typing import Any

from core_models.compatibility import CLASHES
from studies.laws.model_text import find_models


def model_records(name: str | None = None) -> list[dict[str, Any]]:
    """All laws, or those of a card type or class; SceneError naming the nearest one."""
    return [
        {
            "slot": slot,
            "law": model.law.__name__,
            "card_types": list(model.types),
            "module": model.law.__module__,
            "description": inspect.getdoc(model.law) or model.help,
            "parameters": [
                {
                    "tag": each.tag,
                    "unit": each.unit,
                    "range": str(each.range),
                    "help": each.help,
                    "when_left_out": each.requirement,
                }
                for each in model.parameters
            ],
        }
        for slot, model in find_models(name)
    ]


def compatibility_record() -> list[dict[str, Any]]:
    """Laws of one slot that do not fit laws of another, why, and what would fit; all other pairs fit."""
    return [clash._asdict() for clash in CLASHES]
