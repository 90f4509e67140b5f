"""The necking bar as a work-precision problem: largest force and radius of the neck."""

from dataclasses import replace
from functools import cache
from typing import Any

from core_models.errors import RunFailure
from studies.methods.solver_options import ELEMENTS, PARTICLES
from studies.methods.variants import KIND, Variant, read_variant
from studies.necking.bar_necking import quantity
from studies.necking.methods import IMPLICIT, METHODS, pulled
from studies.necking.reader import read_necking_scene
from studies.necking.scene import NeckingScene, PlannedRun
from studies.work_precision.problem import Reference, WorkProblem

PULL = 6.05e-3  # m: the last radius is taken at 6 mm
PULLS = {"mpm": 6.5e-3}  # whose end lags behind the grid that pulls it
INCREMENTS, PERIODS = 25, 60  # for one element or cell across
# Elements along for one across, and size at the neck by that at the end; others have cells all alike.
MESHES = {"fem-implicit": (4, 0.05), "mpm-implicit": (4, 0.05), "fem-explicit": (3, 0.17)}
QUANTITIES = {
    "peak_force": ("peak_force", None),
    "neck_radius_at_5_mm": ("neck_radius", 5e-3),
    "neck_radius_at_6_mm": ("neck_radius", 6e-3),
}
RESOLUTIONS = {
    "fem-implicit": (4, 5, 7, 10, 14),
    "fem-implicit:quad8+reduced": (3, 4, 5, 7, 10),
    "mpm-implicit": (4, 5, 7, 10, 14),
    "fem-explicit": (3, 4, 5, 6, 7),
    "mpm-tl": (3, 4, 5, 6, 7),
    "mpm": (3, 4, 5, 6, 7),
}
VARIANTS = tuple(RESOLUTIONS)
PLANE_KINDS = {KIND: ("quad4", "quad8", "tri6"), "integration": ("full", "reduced")}
NECKING_WORDS = {
    "fem-implicit": PLANE_KINDS | {"cure": ("none", "mean-dilatation", "linear-dilatation")},
    "mpm-implicit": {"cure": PARTICLES["cure"], "interpolation": ("quadratic", "cubic")},
    "fem-explicit": PLANE_KINDS | {"cure": ELEMENTS["cure"]},
    "mpm-tl": PARTICLES,
    "mpm": PARTICLES,
}
JOINT = Reference(None, 0.0, "joint extrapolation of all runs")


@cache
def bar(pull: float = PULL) -> NeckingScene:
    """Simo's bar, pulled as far as the last quantity needs it [m]."""
    return replace(read_necking_scene("necking-simo"), pull=pull)


def build(name: str, resolution: int, threads: int) -> Any:
    """The solver of a bar with so many elements or cells across, and increments or periods in step with them."""
    variant = read_necking_variant(name)
    scene = bar(PULLS.get(variant.solver, PULL))
    return METHODS[variant.solver](scene, planned_run(variant, resolution, threads))


def read_necking_variant(name: str) -> Variant:
    """The variant of a name; SceneError with the nearest known one."""
    return read_variant(name, NECKING_WORDS)


def planned_run(variant: Variant, resolution: int, threads: int) -> PlannedRun:
    """The run of a variant at a resolution."""
    is_implicit = variant.solver in IMPLICIT
    options = dict(variant.options)
    if variant.solver == "mpm-implicit":
        options.setdefault("cure", "mean-dilatation")
    along, grading = MESHES.get(variant.solver, (bar().length / bar().radius, 1.0))
    return PlannedRun(
        variant.solver, variant.solver, resolution, round(along * resolution), grading, variant.kind,
        increments=INCREMENTS * resolution if is_implicit else 0,
        periods=0.0 if is_implicit else float(PERIODS * resolution),
        options=options | {"threads": threads},
    )  # fmt: skip


def finish(solver: Any) -> dict[str, float]:
    """Largest force [N] and radii of the neck [m]; RunFailure for a run that stops on its way."""
    run = pulled(bar(), solver, is_scaled=True)
    if run.stopped:
        raise RunFailure(run.stopped)
    found = {name: quantity(run.history, *asked) for name, asked in QUANTITIES.items()}
    if None in found.values():
        reached = 1e3 * run.history.column("elongation")[-1]
        raise RunFailure(f"the bar has been pulled by {reached:.3f} mm only: take more cells across")
    return found


PROBLEM = WorkProblem(
    "necking-simo",
    "Necking of a round bar, pulled by 6 mm at each end",
    dict.fromkeys(QUANTITIES, JOINT),
    RESOLUTIONS,
    VARIANTS,
    build,
    finish,
    {"peak_force": "N", "neck_radius_at_5_mm": "m", "neck_radius_at_6_mm": "m"},
    read_necking_variant,
)
