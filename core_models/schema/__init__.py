"""The declarative schema of material cards: what is read, checked, written and listed."""

from core_models.schema.elasticity import ANISOTROPY
from core_models.schema.entries import (
    ANY,
    ANY_NUMBER_OF,
    NOT_NEGATIVE,
    POSITIVE,
    Inert,
    Interval,
    ModelSchema,
    Parameter,
    SlotSchema,
    Switch,
)
from core_models.schema.quantities import (
    BODY,
    CONSTANTS,
    CYLINDER,
    DEAD_MODEL_TAGS,
    DEAD_TAGS,
    ELASTICITY,
    EXPANSION_COEFFICIENT,
    HEATED_FRACTION,
    SWITCHES,
    TOLERANCE,
    UNAVAILABLE_SHAPES,
    UNAVAILABLE_TAGS,
)
from core_models.schema.registration import register_model
from core_models.schema.slots import SLOTS, UPDATE

__all__ = [
    "ANISOTROPY",
    "ANY",
    "ANY_NUMBER_OF",
    "BODY",
    "CONSTANTS",
    "CYLINDER",
    "DEAD_MODEL_TAGS",
    "DEAD_TAGS",
    "ELASTICITY",
    "EXPANSION_COEFFICIENT",
    "HEATED_FRACTION",
    "NOT_NEGATIVE",
    "POSITIVE",
    "SLOTS",
    "SWITCHES",
    "TOLERANCE",
    "UNAVAILABLE_SHAPES",
    "UNAVAILABLE_TAGS",
    "UPDATE",
    "Inert",
    "Interval",
    "ModelSchema",
    "Parameter",
    "SlotSchema",
    "Switch",
    "register_model",
]
