"""Runs of manufactured solutions: errors of every variant at every size."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import RunFailure
from core_models.loads import REFERENCE, BodyForce, Load
from core_models.material import Material
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from meshes.mesh import Mesh
from studies.report.parts import FEM
from studies.verification.closed_forms.manufactured import ManufacturedSolution
from studies.verification.convergence_report import convergence_outcome
from studies.verification.outcome import Outcome
from studies.verification.variant import Variant, attempt, run_until


class ErrorRow(NamedTuple):
    """Of one run: cell size [m], number of nodes or particles, displacement errors [m], steps, seconds of stepping."""

    size: float
    count: int
    root_mean_square: float
    largest: float
    steps: int
    seconds: float


@dataclass(frozen=True)
class ManufacturedProblem:
    """A manufactured solution and the body that it moves.

    body : makes the mesh from cell size [m] and kind. geometry : name of the solvers' geometry.
    loads : supports; the body force is added.
    """

    solution: ManufacturedSolution
    body: Callable[[float, str], Mesh]
    geometry: str
    loads: tuple[Load, ...] = ()


def neo_hookean(density: float, bulk: float, shear: float) -> Material:
    """Compressible neo-Hookean material of the manufactured solutions and the elastic problems."""
    return Material("neo-Hookean", density, CompressibleNeoHookean(), IsotropicElastic(bulk, shear), eos=None)


def error_row(problem: ManufacturedProblem, variant: Variant, size: float, **options) -> ErrorRow:
    """Run to the end and compare the places of all nodes, or of all particles, with the exact ones."""
    solution = problem.solution
    solver = variant.solver(
        problem.body,
        neo_hookean(solution.density, solution.bulk, solution.shear),
        size,
        geometry=problem.geometry,
        velocity=lambda places: solution.velocity(places, 0.0),
        displacement=lambda places: solution.displacement(places, 0.0),
        loads=(*problem.loads, BodyForce(solution.body_force, at=REFERENCE)),
        **options,
    )
    reference = solver.mesh.points if variant.method == FEM else solver.reference_positions
    seconds = run_until(solver, solution.end)
    exact = reference + solution.displacement(reference, solution.end)
    error = np.linalg.norm(solver.positions - exact, axis=1)
    return ErrorRow(
        size, len(error), float(np.sqrt((error**2).mean())), float(error.max()), solver.step_count, seconds
    )


def convergence(
    problem: ManufacturedProblem, variants: Sequence[Variant], sizes: Sequence[float], control: str
) -> Outcome:
    """Errors of every variant at every size, coarsest first, and the orders that are asked of them.

    control : label of the variant that must converge visibly worse.
    """
    done, refused = attempt(variants, lambda variant: _sequence(problem, variant, sizes))
    return convergence_outcome(done, refused, {variant.label: variant for variant in variants}, control)


def _sequence(problem: ManufacturedProblem, variant: Variant, sizes: Sequence[float]) -> list[ErrorRow]:
    """Errors at all sizes; the coarsest runs twice, so that no compilation is in its time."""
    _row_or_failure(problem, variant, sizes[0])
    return [_row_or_failure(problem, variant, size) for size in sizes]


def _row_or_failure(problem: ManufacturedProblem, variant: Variant, size: float) -> ErrorRow:
    """The row of a run; no number for the errors of one that went wrong."""
    try:
        return error_row(problem, variant, size)
    except RunFailure:
        return ErrorRow(size, 0, math.nan, math.nan, 0, math.nan)
