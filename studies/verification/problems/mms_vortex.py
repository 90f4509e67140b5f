"""Manufactured solution: generalized vortex."""

from dataclasses import replace

from meshes.mesh import Mesh
from studies.verification.bodies import ring
from studies.verification.closed_forms.mms_vortex import INNER, OUTER, VORTEX
from studies.verification.convergence import ManufacturedProblem, convergence
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant
from studies.verification.variants import CONTROL, elements, interpolations, transfers

SIZES = (0.05, 0.025, 1.0 / 60.0, 0.0125)  # m
QUICK_SIZES = (0.05, 0.5 / 12.0, 0.03125, 0.025)


def body(size: float, kind: str) -> Mesh:
    """The annulus 0.75 <= R <= 1.25 m."""
    return ring(INNER, OUTER, size, kind)


def run(quick: bool) -> Outcome:
    """All elements, interpolations and transfers."""
    problem = ManufacturedProblem(VORTEX, body, "plane-strain")
    variants = [*elements(2), *map(_narrow, interpolations(2)), *transfers(2)]
    return convergence(problem, variants, QUICK_SIZES if quick else SIZES, CONTROL)


def _narrow(variant: Variant) -> Variant:
    """Half as wide particles for CPDI, whose domains would be sheared over more cells than one may reach."""
    if variant.options["interpolation"] != "cpdi":
        return variant
    return replace(variant, label=f"{variant.label}, 4 × 4 particles", finer=2)


PROBLEM = Problem(
    "mms-vortex",
    "Generalized vortex",
    "An annulus in plane strain whose circles turn to and fro, each by its own angle: rotations of up to one radian "
    "and shears of up to five without change of volume, particles crossing the grid at every angle. Rims are free. "
    "Displacements are compared at 0.25 s, at 71 % of the largest rotation: later the coarser meshes are too distorted "
    "to show an order.",
    "Kamojjala, Brannon et al., Eng. Comput. 31 (2015) 27-44",
    run,
)
