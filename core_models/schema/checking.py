"""The numbers of a law checked against its card schema, wherever the law was made."""

from collections.abc import Iterator
from numbers import Real
from typing import Any

from core_models.schema.entries import ModelSchema, Parameter
from core_models.schema.quantities import CONSTANTS, ELASTICITY
from core_models.schema.slots import SLOTS


def fault_of(slot: str, law: tuple) -> str:
    """What is wrong with the numbers of a law, as "problem: remedy"; empty if nothing is."""
    for parameter in _parameters(slot, law):
        fault = _range_fault(law, parameter)
        if fault:
            return fault
    for low, high in _ascending(slot, law):
        below, above = getattr(law, low.field), getattr(law, high.field)
        if not below < above:
            return f"{high.field} = {above!r} {high.unit} is not above {low.field} = {below!r}: give it above that"
    return law.fault() if hasattr(law, "fault") else ""


def _range_fault(law: tuple, parameter: Parameter) -> str:
    value = getattr(law, parameter.field)
    for number in value if isinstance(value, tuple) else (value,):
        if not isinstance(number, Real):
            return f"{parameter.field} = {number!r} is no number: give {parameter.help} in {parameter.unit}"
        if number not in parameter.range:
            wanted = f"give a value {parameter.range}"
            return f"{parameter.field} = {number!r}{parameter.said_unit} is out of its range: {wanted}"
    return ""


def _model(slot: str, law: tuple) -> ModelSchema | None:
    schema = next((known for known in SLOTS if known.slot == slot), None)
    return schema.model_of(law) if schema else None


def _parameters(slot: str, law: tuple) -> Iterator[Parameter]:
    """The schema's parameters, or the plain tags that feed the slot, each with the field of the law."""
    model = _model(slot, law)
    if model is not None:
        yield from model.parameters
        return
    for parameter in (*CONSTANTS, *ELASTICITY):
        fed, _, field = parameter.field.partition(".")
        if fed == slot and field in getattr(law, "_fields", ()):
            yield Parameter(parameter.tag, parameter.unit, parameter.range, parameter.help, field)


def _ascending(slot: str, law: tuple) -> list[tuple[Parameter, Parameter]]:
    model = _model(slot, law)
    by_tag: dict[str, Any] = {} if model is None else {p.tag: p for p in model.parameters}
    return [] if model is None else [(by_tag[low], by_tag[high]) for low, high in model.ascending]
