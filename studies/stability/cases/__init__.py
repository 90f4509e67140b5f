"""The hard cases by name; each module adds its own."""

from importlib import import_module

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.stability.case import Case

MODULES = ("impact", "volume", "elastic", "discretisation", "contact", "implicit")


def all_cases() -> dict[str, Case]:
    """Every case by its name, in the order of the report."""
    found: dict[str, Case] = {}
    for name in MODULES:
        found |= {case.name: case for case in import_module(f"{__name__}.{name}").CASES}
    return found


def find_case(name: str) -> Case:
    """The case of that name; SceneError with the nearest one otherwise."""
    cases = all_cases()
    if name not in cases:
        raise SceneError(f"no stability case is called {name!r}; {suggestion(name, cases)}")
    return cases[name]
