"""What a run pulls: mesh, supports and geometry of a scene's body, as a plane section or as a solid."""

from typing import Any

from core_models.errors import SceneError
from core_models.loads import Load, Prescribed, Symmetry
from core_models.material import Material
from meshes.kinds import KINDS, find_kind
from meshes.mesh import Mesh
from meshes.necking_bar import necking_bar
from meshes.square_bar import square_bar
from meshes.tension_strip import tension_strip
from studies.methods.quasi_static import slow_enough
from studies.necking.scene import ROUND_BAR, SQUARE_BAR, STRIP, NeckingScene, PlannedRun

DIMENSIONS = {ROUND_BAR: (2, 3), SQUARE_BAR: (3,), STRIP: (2,)}
"""A body: dimensions of the elements that it can be made of; a round bar is a body of revolution in two."""

COARSE = (3, 12)  # elements across and along, which have the lowest mode as well as a fine mesh
QUARTERS = 4.0  # of a solid's section, one of which is simulated


def check_kind(body: str, kind: str) -> None:
    """Refuse elements that a body cannot be made of; SceneError or MeshError names those there are."""
    if find_kind(kind).dimension not in DIMENSIONS[body]:
        kinds = [name for name, each in KINDS.items() if each.dimension in DIMENSIONS[body]]
        raise SceneError(f"a {body} is not made of {kind}: give it elements of a kind of {', '.join(kinds)}")


def is_solid(plan: PlannedRun) -> bool:
    """Whether a run is made in three dimensions: of an eighth of the body."""
    return KINDS[plan.kind].dimension == 3


def body_of(scene: NeckingScene, plan: PlannedRun, crowd: int = 1) -> Mesh:
    """The mesh of a run, with so many elements along for each that was asked for."""
    size = (scene.radius, scene.length, plan.across, plan.along * crowd, scene.taper)
    if scene.body == STRIP:
        return tension_strip(*size, plan.kind)
    make = square_bar if scene.body == SQUARE_BAR else necking_bar
    return make(*size, plan.grading, plan.kind)


def geometry_of(scene: NeckingScene, plan: PlannedRun) -> str:
    """Name of the geometry, as solvers take it."""
    if is_solid(plan):
        return "spatial"
    return "plane-strain" if scene.body == STRIP else "axisymmetric"


def loads_of(scene: NeckingScene, plan: PlannedRun, velocity: Any) -> tuple[Load, ...]:
    """Supports of the part that is simulated, whose end moves with a velocity [m/s]."""
    planes = ("symmetry_x", "symmetry_y") if is_solid(plan) else ("symmetry",) if scene.body == STRIP else ()
    across = len(planes) or 1
    held = tuple(Prescribed("end", axis, 0.0) for axis in range(across)) if scene.held else ()
    return (*(Symmetry(name) for name in ("neck", *planes)), Prescribed("end", across, velocity), *held)


def force_of(solver: Any) -> float:
    """Force [N] that pulls the body: on the whole section of a bar, on the quarter of a strip."""
    return float(solver.boundary_force("end")[-1]) * (QUARTERS if solver.mesh.dimension == 3 else 1.0)


def slowed(scene: NeckingScene, plan: PlannedRun) -> Material:
    """The material with its mass scaled by the lowest mode of the body."""
    across, along = COARSE
    coarse = PlannedRun("", "", across, along, kind="hex8" if is_solid(plan) else "quad4")
    return slow_enough(
        body_of(scene, coarse), scene.material, loads_of(scene, coarse, 0.0), scene.duration, plan.periods,
        geometry_of(scene, coarse),
    )  # fmt: skip
