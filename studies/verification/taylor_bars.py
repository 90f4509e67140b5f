"""Taylor bars of the shipped scenes in two and three dimensions, by any variant, and what is measured on them."""

from functools import partial
from typing import NamedTuple

import numpy as np

from core_models.loads import Symmetry
from meshes.mesh import Mesh
from meshes.taylor_bar import taylor_bar
from meshes.taylor_quarter import taylor_quarter
from studies.scenes.reader import read_scene
from studies.scenes.scene import Scene
from studies.verification.variant import Variant, run_until


class BarState(NamedTuple):
    """Of a bar at the end: length and radius of the foot [m], largest equivalent plastic strain, roughness of the
    pressure (see `pressure_roughness`), relative error of the energy balance, steps, seconds of stepping.
    """

    length: float
    radius: float
    plastic_strain: float
    roughness: float | None
    energy_error: float
    steps: int
    seconds: float


def final_state(scene_name: str, variant: Variant, across: int, wall: str) -> BarState:
    """The scene's bar at its end, `across` elements or cells on the radius; the kind of cell decides the dimension."""
    scene = read_scene(scene_name)
    spatial = variant.kind.startswith(("hex", "tet"))
    planes = (Symmetry("symmetry_x"), Symmetry("symmetry_y")) if spatial else ()
    solver = variant.solver(
        partial(_body, scene, spatial),
        scene.material,
        scene.bar.radius / across,
        velocity=scene.bar.velocity,
        temperature=scene.bar.temperature,
        wall=wall,
        viscosity=scene.viscosity,
        loads=planes,
    )
    seconds = run_until(solver, scene.end.limit(wall))
    return BarState(
        float(solver.boundary_positions("rear")[:, -1].mean()),
        float(np.linalg.norm(solver.boundary_positions("foot")[:, :-1], axis=1).max()),
        float(solver.points.old.equivalent_plastic_strain.max()),
        pressure_roughness(solver) if variant.method == "fem" else None,
        solver.ledger.relative_error,
        solver.step_count,
        seconds,
    )


def pressure_roughness(solver) -> float:
    """How much the elements' pressures jump from one to the next: a checkerboard has about 1, a smooth field about 0.

    Root mean square of the differences between the elements' mean stresses and their averages round nodes, over the
    root mean square of the mean stress.
    """
    cells = solver.mesh.cells
    per_point = solver.points.old.stress[:, :3].mean(axis=1)
    volumes = solver.points.reference_volumes.reshape(len(cells), -1)
    pressure = (per_point.reshape(len(cells), -1) * volumes).sum(axis=1) / volumes.sum(axis=1)
    weight = np.repeat(volumes.sum(axis=1), cells.shape[1])
    total = np.bincount(cells.ravel(), weight * np.repeat(pressure, cells.shape[1]))
    smooth = (total / np.bincount(cells.ravel(), weight))[cells].mean(axis=1)
    return float(np.sqrt(((pressure - smooth) ** 2).mean() / (pressure**2).mean()))


def _body(scene: Scene, spatial: bool, size: float, kind: str) -> Mesh:
    make = taylor_quarter if spatial else taylor_bar
    return make(scene.bar.radius, scene.bar.length, round(scene.bar.radius / size), kind=kind)
