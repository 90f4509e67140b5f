"""The generalized vortex as a work-precision problem: the exact displacement of every point."""

from typing import Any

import numpy as np

from core_models.errors import SceneError
from core_models.loads import REFERENCE, BodyForce
from studies.methods.variants import read_variant
from studies.report.parts import FEM, MPM
from studies.verification.closed_forms.mms_vortex import VORTEX
from studies.verification.convergence import neo_hookean
from studies.verification.problems.mms_vortex import body
from studies.verification.variant import Variant as Discretisation
from studies.work_precision.problem import Reference, WorkProblem

WIDTH = 0.5  # m, of the annulus
RESOLUTIONS = {"fem-explicit": (10, 16, 20, 24, 30), "mpm": (10, 16, 20, 24, 30)}
VARIANTS = ("fem-explicit", "fem-explicit:quad8", "mpm", "mpm:cubic", "mpm:total")


def build(name: str, resolution: int, threads: int) -> Any:
    """The annulus with so many cells across its width."""
    variant = read_variant(name)
    if variant.is_spatial:
        raise SceneError(f"{name}: the vortex is plane; leave the 3-D kinds out")
    method = FEM if variant.solver == "fem-explicit" else MPM
    return Discretisation(name, method, variant.kind, variant.options).solver(
        body,
        neo_hookean(VORTEX.density, VORTEX.bulk, VORTEX.shear),
        WIDTH / resolution,
        geometry="plane-strain",
        threads=threads,
        velocity=lambda places: VORTEX.velocity(places, 0.0),
        displacement=lambda places: VORTEX.displacement(places, 0.0),
        loads=(BodyForce(VORTEX.body_force, at=REFERENCE),),
    )


def finish(solver: Any) -> dict[str, float]:
    """Root-mean-square error of the displacement of the points over that of the displacement itself [-]."""
    while solver.time < VORTEX.end:
        solver.advance(VORTEX.end)
    reference = solver.reference_positions
    exact = VORTEX.displacement(reference, VORTEX.end)
    error = solver.point_positions() - reference - exact
    return {"displacement": float(np.sqrt((error**2).sum() / (exact**2).sum()))}


PROBLEM = WorkProblem(
    "vortex",
    "Generalized vortex, displacement of all points",
    {"displacement": Reference(0.0, 0.0, "exact (manufactured)")},
    RESOLUTIONS,
    VARIANTS,
    build,
    finish,
    {"displacement": "1"},
)
