"""Card schemas of laws that come from outside: a user's own file."""

from core_models.errors import MaterialError
from core_models.names import suggestion
from core_models.schema.entries import ModelSchema
from core_models.schema.slots import SLOTS, UPDATE

OPEN_SLOTS = {slot.slot: slot for slot in SLOTS if slot.models and slot is not UPDATE}


def register_model(slot: str, model: ModelSchema) -> None:
    """Let cards name a law: reader, writer, messages and `matpoint models` know it from then on.

    Parameters
    ----------
    slot : 'flow', 'elasticity', 'eos', 'yield_condition', 'kinematic_hardening', 'heating', 'damage', 'erosion',
    'shear_modulus', 'melting' or 'specific_heat'.
    model : type names in a card, class, help, and one `Parameter` for each field of the class.

    Registering the same schema again does nothing.
    Raises MaterialError: an unknown slot, a type name that is taken, or tags that do not fit the class.
    """
    if slot not in OPEN_SLOTS:
        raise MaterialError(f"no slot '{slot}' takes laws of your own; {suggestion(slot, OPEN_SLOTS)}")
    schema = OPEN_SLOTS[slot]
    known = schema.model_of_class(model.law)
    if known == model:
        return
    name = model.law.__name__
    if known is not None:
        raise MaterialError(f"{name} has another card schema already: register it once")
    others = {name for other in schema.models for name in other.types}
    taken = sorted(set(model.types) & (others | {*schema.plain, *schema.unavailable}))
    if not model.types or taken:
        raise MaterialError(f"{name}: {_naming_fault(taken)} in the slot {slot}; give it another type name")
    fed = sorted(parameter.field for parameter in model.parameters)
    if fed != sorted(model.law._fields):
        raise MaterialError(
            f"{name}: its tags feed {', '.join(fed) or 'nothing'}, its fields are "
            f"{', '.join(model.law._fields) or 'none'}; give each field one Parameter"
        )
    schema.models = (*schema.models, model)


def _naming_fault(taken: list[str]) -> str:
    return f"the type name '{taken[0]}' is taken" if taken else "it has no type name"
