"""Generic functions: one name, one implementation per type of model, resolved while compiling.

A law is a `NamedTuple` of parameters plus functions registered for its type on generic functions such as
`flow_stress` or `pressure`. Numba picks the implementation from the type during compilation, so a call costs nothing
at run time; plain Python looks the type up in a dictionary. `None` is a type like any other: an absent effect is an
implementation that does nothing.
"""

import functools
from collections.abc import Callable

import numpy as np
from numba.core import types
from numba.extending import overload

from core_models.errors import MaterialError

_law_classes: dict[str, type] = {}


def generic(stub: Callable) -> Callable:
    """Make `stub(model, *args)` a generic function.

    `stub.register(Type)` adds the implementation for a type, `stub.otherwise` the one for all other types.
    """
    implementations: dict[type, Callable] = {}
    fallback: list[Callable] = []

    def find(model_class: type | None) -> Callable | None:
        return implementations.get(model_class, fallback[0] if fallback else None)

    @functools.wraps(stub)
    def call(model, *args):
        implementation = find(type(model))
        if implementation is None:
            raise MaterialError(_no_implementation(stub, type(model), implementations))
        return implementation(model, *args)

    def register(model_class: type) -> Callable:
        _refuse_second_class_of_same_name(model_class)

        def add(implementation: Callable) -> Callable:
            implementations[model_class] = implementation
            return implementation

        return add

    def resolve(model, *args):
        return find(_python_type(model))

    def otherwise(implementation: Callable) -> Callable:
        fallback.append(implementation)
        return implementation

    overload(
        call, strict=False, jit_options={"error_model": "numpy", "boundscheck": False, "forceinline": True}
    )(resolve)
    call.register = register
    call.otherwise = otherwise
    call.implementations = implementations
    return call


def _python_type(numba_type: types.Type) -> type | None:
    if isinstance(numba_type, types.NoneType):
        return type(None)
    if isinstance(numba_type, types.Array):
        return np.ndarray
    return getattr(numba_type, "instance_class", None)


def _refuse_second_class_of_same_name(model_class: type) -> None:
    """Numba tells NamedTuples apart by name and fields only: two classes of one name would share machine code."""
    known = _law_classes.setdefault(model_class.__name__, model_class)
    if known is not model_class:
        raise MaterialError(
            f"a law named {model_class.__name__} exists already in {known.__module__}: "
            f"rename the class in {model_class.__module__}"
        )


def _no_implementation(stub: Callable, model_class: type, implementations: dict[type, Callable]) -> str:
    known = ", ".join(sorted(c.__name__ for c in implementations))
    return f"{stub.__name__} is not defined for {model_class.__name__}: register it, or use one of {known}"
