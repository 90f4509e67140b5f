"""The vibrating bar as a work-precision problem: its period has a closed form."""

from typing import Any

import numpy as np

from core_models.errors import SceneError
from core_models.loads import Symmetry
from studies.methods.variants import read_variant
from studies.report.parts import FEM, MPM
from studies.verification.bodies import strip_body
from studies.verification.closed_forms.elastic_bodies import bar_period
from studies.verification.convergence import neo_hookean
from studies.verification.problems.vibrating_bar import DENSITY, HEIGHT, LENGTH, SPEED, YOUNG, period
from studies.verification.variant import Variant as Discretisation
from studies.work_precision.problem import Reference, WorkProblem

PERIODS = 3
RESOLUTIONS = {"fem-explicit": (1, 2, 3, 4, 6), "mpm": (2, 3, 4, 6, 8)}
VARIANTS = ("fem-explicit", "fem-explicit:tri6", "mpm", "mpm:flip", "mpm:total")


def build(name: str, resolution: int, threads: int) -> Any:
    """The bar with so many cells across its height, at rest in the middle of its swing."""
    variant = read_variant(name)
    if variant.is_spatial:
        raise SceneError(f"{name}: the vibrating bar is plane; leave the 3-D kinds out")
    method = FEM if variant.solver == "fem-explicit" else MPM
    return Discretisation(name, method, variant.kind, variant.options).solver(
        strip_body(LENGTH, HEIGHT),
        neo_hookean(DENSITY, YOUNG / 3.0, YOUNG / 2.0),
        HEIGHT / resolution,
        geometry="plane-strain",
        threads=threads,
        velocity=lambda places: np.column_stack(
            [SPEED * np.sin(0.5 * np.pi * places[:, 0] / LENGTH), np.zeros(len(places))]
        ),
        loads=(Symmetry("left"),),
    )


def finish(solver: Any) -> dict[str, float]:
    """The period of the centroid's motion [s]."""
    end = (PERIODS + 0.5) * bar_period(LENGTH, YOUNG, DENSITY)
    times, places = [], []
    while solver.time < end:
        solver.advance()
        times.append(solver.time)
        places.append(np.average(solver.point_positions()[:, 0], weights=solver.points.reference_volumes))
    displacement = np.array(places) - places[0]
    return {"period": period(np.array(times), displacement)}


PROBLEM = WorkProblem(
    "vibrating-bar",
    f"Axial vibration of a bar, {PERIODS} periods",
    {"period": Reference(bar_period(LENGTH, YOUNG, DENSITY), 1e-4 * 10.0, "closed form of small strains")},
    RESOLUTIONS,
    VARIANTS,
    build,
    finish,
    {"period": "s"},
)
