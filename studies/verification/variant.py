"""Variants of the two methods: an element, or an interpolation with its transfer."""

import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from core_models.errors import MatpointError
from core_models.material import Material
from fem import ExplicitSolver
from meshes.mesh import Mesh
from mpm import Solver
from studies.report.parts import FEM

Body = Callable[[float, str], Mesh]
"""Makes the mesh of a body from the size of its cells [m] and their kind."""


@dataclass(frozen=True)
class Variant:
    """One way of solving: a method, the kind of the mesh's cells, and options of the solver.

    label : for tables and figures. lowest_order : the order of convergence that is asked of it; None for none.
    finer : cells of the mesh that particles are made from, along an edge of a cell of the grid; each makes two.
    """

    label: str
    method: str
    kind: str
    options: Mapping[str, Any] = field(default_factory=dict)
    lowest_order: float | None = None
    finer: int = 1

    def solver(self, body: Body, material: Material, size: float, **common) -> ExplicitSolver | Solver:
        """The solver of a body; the cells of the MPM grid have the size that a mesh for elements would have."""
        mesh = body(size / self.finer, self.kind)
        if self.method == FEM:
            return ExplicitSolver(mesh, material, **common, **self.options)
        return Solver(mesh, material, cell_size=size, **common, **self.options)


class Refused(NamedTuple):
    """A variant that could not be run, and what the program said."""

    variant: Variant
    reason: str


def run_until(solver: ExplicitSolver | Solver, end: float) -> float:
    """Step to the time `end` [s], met exactly; returns the seconds of processor time that the steps took."""
    began = time.process_time()
    while solver.time < end:
        solver.advance(end)
    return time.process_time() - began


def attempt(
    variants: Iterable[Variant], work: Callable[[Variant], Any]
) -> tuple[dict[str, Any], list[Refused]]:
    """Results of the work by the variants' labels; what the program refuses or cannot finish is listed, not hidden."""
    done, refused = {}, []
    for variant in variants:
        try:
            done[variant.label] = work(variant)
        except MatpointError as error:
            refused.append(Refused(variant, str(error)))
    return done, refused
