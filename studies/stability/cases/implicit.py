"""Increments of implicit methods that are far too large."""

from core_models.errors import UnsupportedError
from core_models.loads import Prescribed, Symmetry
from studies.stability.bodies import ASPECT, RADIUS, bar_mesh, classic
from studies.stability.case import Case
from studies.variants import read_variant

SHARE = 0.2  # by which the bar is drawn out
INCREMENTS = 4  # where 40 do well


def _drawn(variant: str):
    """A bar drawn out by a fifth, held sideways at its ends."""
    asked = read_variant(variant)
    if asked.solver != "fem-explicit":
        raise UnsupportedError(f"{variant}: has no implicit steps; take finite elements")
    from fem import ImplicitSolver

    speed = SHARE * ASPECT * RADIUS
    loads = (Symmetry("foot"), Prescribed("rear", 0, 0.0), Prescribed("rear", 1, speed))
    mesh = bar_mesh(variant)
    return ImplicitSolver(mesh, classic(), loads=loads, increment=1.0 / INCREMENTS, **asked.options)


# Of so large an increment the external work is a trapezoid's, far from what the stress does.
CASES = (Case("implicit-large", "Implicit increments ten times too large", _drawn, 1.0, drift=10.0),)
