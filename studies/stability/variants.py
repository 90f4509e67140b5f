"""Variants of the study: those of the explicit solvers (studies.methods.variants), and of the implicit ones."""

from studies.methods.solver_options import SOLVER_OPTIONS
from studies.methods.variants import KIND, PLANAR_KINDS, WORDS, Variant, read_variant

EXPLICIT = (
    "fem-explicit",
    "fem-explicit:reduced",
    "fem-explicit:tri3",
    "fem-explicit:quad8",
    "fem-explicit:quad8+none",
    "mpm",
    "mpm:flip",
    "mpm:xpic",
    "mpm:linear",
    "mpm:linear+flip+musl",
    "mpm:gimp",
    "mpm:cubic",
    "mpm:cpdi",
    "mpm:total",
)
IMPLICIT = ("fem-implicit", "fem-implicit:quad8+none", "mpm-implicit", "mpm-implicit:cubic")
# The cases are bodies in the plane or with axial symmetry.
_EXPLICIT = {"fem-explicit": PLANAR_KINDS, "mpm": ("quad4",)}
_IMPLICIT = {"fem-implicit": PLANAR_KINDS, "mpm-implicit": ("quad4",)}
_WORDS = {solver: WORDS[solver] | {KIND: kinds} for solver, kinds in _EXPLICIT.items()} | {
    solver: {KIND: kinds, **SOLVER_OPTIONS[solver]} for solver, kinds in _IMPLICIT.items()
}


def variant_of(name: str) -> Variant:
    """The variant of that name; SceneError for an unknown solver or word, with the nearest one."""
    return read_variant(name, _WORDS)


def is_implicit(name: str) -> bool:
    """Whether the variant of that name takes quasi-static increments instead of explicit steps."""
    return variant_of(name).solver in _IMPLICIT
