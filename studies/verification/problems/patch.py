"""Patch tests: linear fields on distorted meshes, every element and interpolation."""

import numpy as np

from core_models.geometry import DIMENSIONS
from meshes.block import block
from meshes.elevate import elevate
from meshes.kinds import KINDS
from meshes.mesh import Mesh
from studies.report.parts import FEM, Table
from studies.verification.convergence import neo_hookean
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt
from studies.verification.variants import elements, interpolations

ROUND_OFF = 1e-11  # of the change of the gradient, which is a few per cent
DENSITY, BULK, SHEAR = 1000.0, 2e6, 1e6
COUNTS, DISTORTION = {2: (5, 4), 3: (3, 3, 3)}, 0.15
STRAIGHT = (
    "tri6",
    "tet10",
)  # their 3 and 4 points are exact for straight edges; all others' edges are curved too
STRETCH = {
    "plane-strain": np.array([[0.02, 0.03], [-0.01, 0.04]]),
    "axisymmetric": np.array([[0.02, 0.0], [0.0, 0.04]]),
    "spatial": np.array([[0.02, 0.03, 0.01], [-0.01, 0.04, 0.02], [0.02, -0.03, 0.01]]),
}
"""Displacement gradients; the axisymmetric one stretches alike along r and the hoop."""
RATE = 1e3  # 1/s, velocity over displacement gradient: strains of some per cent in a step


def body(size: float, kind: str) -> Mesh:
    """A distorted block between 0 and 1 m, its lower left corner on the axis; `size` does nothing."""
    dimension = 3 if kind.startswith(("hex", "tet")) else 2
    first = KINDS[kind].linear if kind in STRAIGHT else kind
    made = block([0.0] * dimension, [1.0] * dimension, COUNTS[dimension], first, distortion=DISTORTION)
    return elevate(made, kind) if kind in STRAIGHT else made


def gradient_error(variant: Variant, geometry: str) -> float:
    """Error of all points' deformation gradients after one step in a linear velocity field, relative to its change."""
    rate = RATE * STRETCH[geometry]
    solver = variant.solver(
        body,
        neo_hookean(DENSITY, BULK, SHEAR),
        1.0 / COUNTS[DIMENSIONS[geometry]][0],
        geometry=geometry,
        velocity=lambda places: places @ rate.T,
    )
    solver.advance()
    exact = np.eye(3)
    dimension = len(rate)
    exact[:dimension, :dimension] += solver.time * rate
    if geometry == "axisymmetric":
        exact[2, 2] += solver.time * rate[0, 0]
    found = solver.points.old_deformation_gradient
    return float(np.abs(found - exact).max() / (solver.time * np.abs(rate).max()))


def force_error(variant: Variant, geometry: str) -> float:
    """Largest force on a node inside under uniform strain, relative to the largest on the rim; elements only."""
    rate = STRETCH[geometry]
    solver = variant.solver(
        body,
        neo_hookean(DENSITY, BULK, SHEAR),
        0.0,
        geometry=geometry,
        displacement=lambda places: places @ rate.T,
    )
    rim = np.zeros(len(solver.mesh.points), dtype=bool)
    for name, nodes in solver.mesh.boundaries.items():
        if not (geometry == "axisymmetric" and name == "left"):
            rim[np.unique(nodes)] = True
    forces = solver.nodal_forces()
    if geometry == "axisymmetric":
        forces[solver.mesh.points[:, 0] == 0.0, 0] = 0.0
    return float(np.abs(forces[~rim]).max() / np.abs(forces[rim]).max())


def run(quick: bool) -> Outcome:
    """All of them; it is always quick."""
    outcome, rows = Outcome(), []
    for geometry, dimension in DIMENSIONS.items():
        variants = [*elements(dimension), *interpolations(dimension)]
        done, refused = attempt(variants, lambda variant, geometry=geometry: _both(variant, geometry))
        for label, (gradient, force) in done.items():
            rows.append((f"{label}, {geometry}", gradient, force))
            worst = max(gradient, force or 0.0)
            outcome.criteria.append(Criterion(f"linear fields, {label}, {geometry}", worst, high=ROUND_OFF))
        outcome.criteria += [
            Criterion(
                f"linear fields, {each.variant.label}, {geometry}", None, high=ROUND_OFF, reason=each.reason
            )
            for each in refused
        ]
    head = ("variant", "deformation gradient", "force on nodes inside")
    note = f"Edges are curved where elements have nodes on them, but for {' and '.join(STRAIGHT)}: those are straight."
    outcome.tables.append(Table("Relative errors", head, tuple(rows), note))
    return outcome


def _both(variant: Variant, geometry: str) -> tuple[float, float | None]:
    force = force_error(variant, geometry) if variant.method == FEM else None
    return gradient_error(variant, geometry), force


PROBLEM = Problem(
    "patch",
    "Patch tests",
    "Distorted blocks in a linear velocity field: every point's deformation gradient is exact, at boundaries and on "
    "the axis too, for every element and interpolation. Elements under uniform strain leave no force on nodes inside.",
    "Irons",
    run,
)
