"""Variants of a method, named by words after a colon: `fem-explicit:hex8`, `mpm:cubic+flip`, `mpm:spatial`.

A word is a mesh's kind of element (3-D kinds give a quarter of the bar in 3-D), or the value of one of the solver's
options; the words of one solver are all different, so that no option needs to be named.
"""

from dataclasses import dataclass, field
from typing import Any

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.methods.solver_options import ELEMENTS, PARTICLES, SOLVER_OPTIONS

PLANAR_KINDS = ("quad4", "quad8", "quad9", "tri3", "tri6")
SPATIAL_KINDS = ("hex8", "hex20", "hex27", "tet4", "tet10")
SPATIAL = "spatial"
EXAMPLE = "mpm:cubic"
KIND = "kind"

WORDS: dict[str, dict[str, tuple[str, ...]]] = {
    "fem-explicit": {KIND: (*PLANAR_KINDS, *SPATIAL_KINDS), **ELEMENTS},
    "mpm": {
        KIND: ("quad4", "hex8"),
        **PARTICLES,
        "update": ("usl", "musl"),
        "configuration": ("updated", "total"),
    },
}
"""Words of each solver by option."""


@dataclass(frozen=True)
class Variant:
    """A solver's name, the kind of element of its mesh, and the options that differ from the solver's own."""

    solver: str
    kind: str = "quad4"
    options: dict[str, Any] = field(default_factory=dict)

    @property
    def is_spatial(self) -> bool:
        """Whether it simulates the bar in three dimensions."""
        return self.kind in SPATIAL_KINDS

    @property
    def elements_per_cell(self) -> int:
        """Elements along the edge of a cell that particles are seeded from, two along the edge of each.

        Particles of a foot that spreads in two directions would else come to lie more than a cell apart in both, and
        let it spread by 3 to 8 % too much; in axial symmetry it is in one.
        """
        return 2 if self.solver == "mpm" and self.is_spatial else 1


def read_variant(name: str, known: dict[str, dict[str, tuple[str, ...]]] = WORDS) -> Variant:
    """The variant of that name among the known ones; SceneError for an unknown solver or word, with the nearest."""
    solver, colon, words = name.partition(":")
    if solver not in known:
        raise SceneError(
            f"{_unknown(solver)}; {suggestion(solver, known)}, each also with words after a colon like {EXAMPLE}"
        )
    option_of = {word: option for option, values in known[solver].items() for word in values}
    if "hex8" in option_of:
        option_of[SPATIAL] = KIND
    given: dict[str, str] = {}
    for word in words.split("+") if colon else []:
        if word not in option_of:
            raise SceneError(f"{name}: {solver} knows no '{word}'; {suggestion(word, option_of)}")
        option = option_of[word]
        if option in given:
            raise SceneError(f"{name}: '{given[option]}' and '{word}' exclude each other: keep one")
        given[option] = word
    kind = given.pop(KIND, "quad4")
    return Variant(solver, "hex8" if kind == SPATIAL else kind, given)


def _unknown(solver: str) -> str:
    if not solver:
        return "no method given"
    if solver in SOLVER_OPTIONS:
        return f"method '{solver}' does not run this, but what is loaded slowly (matpoint study necking)"
    return f"unknown method '{solver}'"
