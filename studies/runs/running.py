"""One run: a scene by one method at one resolution, with its folder."""

import time
from contextlib import suppress
from pathlib import Path

import numpy as np

from core_models.compilation import source_hash
from core_models.errors import DiskFull, OutputError, RunFailure, UnsupportedError
from core_models.walls import check_wall
from studies.bar.outline import bar_outline, bar_section
from studies.bar.taylor_impact import measure
from studies.checkpointing.checkpoint_file import Saved, Settings, Spent
from studies.checkpointing.checkpoints import Checkpoints
from studies.checkpointing.interval import USUAL, Interval, interval_text
from studies.methods.method import build_solver, check_run, resolutions_of
from studies.observers.contact_watch import ContactWatch
from studies.observers.deadline import Deadline
from studies.observers.fracture_watch import FractureWatch
from studies.observers.frames import Frames, cell_data
from studies.observers.history import ENERGIES, History
from studies.observers.observer import Observer
from studies.observers.progress import Progress
from studies.observers.scene_copy import SceneCopy
from studies.output.output_folder import OutputFolder
from studies.process import check_interrupted
from studies.runs.costs import Cost, measured
from studies.runs.ending import Ending
from studies.runs.record import run_record, to_json
from studies.runs.remaining import Remaining
from studies.runs.result import FinalState, RunResult
from studies.scenes.scene import Scene


def run(
    scene: Scene,
    method: str,
    resolution: int | None = None,
    *,
    wall: str | None = None,
    threads: int = 1,
    out: Path | str | None = None,
    progress: bool = False,
    interval: Interval | None = None,
) -> RunResult:
    """Run a scene and return what came of it.

    resolution: elements or cells across the radius (default: the scene's finest); wall: 'unilateral' or
    'plane' (default: the scene's); out: folder to keep the run in (default: nothing is written); interval: between
    checkpoints in that folder (default: a minute, if the method has any).
    Raises SceneError, MeshError, OutputError before anything is written; RunFailure when the run goes wrong,
    and then the folder keeps what had been written.
    """
    check_wall(wall or scene.wall)
    resolution = resolutions_of(scene, method)[-1] if resolution is None else resolution
    check_run(scene, method, resolution)
    options = {"wall": wall, "threads": threads, "progress": progress, "interval": interval}
    if out is None:
        result = simulate(scene, method, resolution, **options)
    else:
        with OutputFolder(out) as folder:
            result = simulate(scene, method, resolution, folder=folder, **options)
    if result.failure is not None:
        raise result.failure
    return result


def simulate(
    scene: Scene,
    method: str,
    resolution: int,
    *,
    wall: str | None = None,
    threads: int = 1,
    folder: OutputFolder | None = None,
    progress: bool = False,
    remaining: Remaining | None = None,
    interval: Interval | None = None,
    saved: Saved | None = None,
    within: float | None = None,
) -> RunResult:
    """Like `run`, into a folder that is already ours; a run that goes wrong is recorded, not raised.

    remaining: of the plan that this is a run of; saved: the checkpoint to go on from (default: from the start);
    within: seconds after which the run has failed.
    """
    wall = check_wall(wall or scene.wall)
    with measured() as cost:
        began = time.perf_counter()
        solver = build_solver(scene, method, resolution, wall, threads)
        cost.setup_s = time.perf_counter() - began
        mass = solver.mass
        contact, history = ContactWatch(), History(folder, scene.end.limit(wall))
        fracture = FractureWatch()
        ending = Ending(scene, wall, contact)
        observers: list[Observer] = [contact, fracture]
        if within is not None:
            observers.append(Deadline(within))
        if progress:
            plan = remaining or Remaining([(method, resolution)])
            observers.append(Progress(f"{method} {resolution}", ending, plan))
        if folder is not None:
            observers += [SceneCopy(scene, wall, folder), Frames(folder, scene.end.limit(wall))]
        observers.append(history)
        spent = Spent() if saved is None else saved.spent
        checkpoints = None
        if folder is not None and _can_be_resumed(solver, interval):
            interval = interval or USUAL
            settings = Settings(method, resolution, wall, threads, interval_text(interval), source_hash())
            checkpoints = Checkpoints(folder, interval, settings, observers, spent)
            observers.append(checkpoints)
        result = RunResult(scene, method, resolution, wall, threads, history, cost, resumed=spent.resumed)
        result.folder = None if folder is None else folder.path
        result.failure = _advance(solver, ending, observers, cost, saved)
    cost.add(spent.wall_s, spent.cpu_s)
    result.numerical_fracture = fracture.found
    _conclude(result, solver, ending, contact, mass)
    if folder is not None:
        _record(result, folder)
        if checkpoints is not None and result.failure is None:
            checkpoints.remove()
    return result


def _can_be_resumed(solver, interval: Interval | None) -> bool:
    """Whether a solver has checkpoints; UnsupportedError if it has none and an interval asks for them."""
    if interval is not None and not hasattr(solver, "checkpoint"):
        raise UnsupportedError(
            f"{solver.method} writes no checkpoints; leave them out, or use fem-explicit or mpm"
        )
    return hasattr(solver, "checkpoint")


def _record(result: RunResult, folder: OutputFolder) -> None:
    try:
        folder.write_text("run.json", to_json(run_record(result)))
    except DiskFull as failure:
        result.failure = result.failure or failure


def _advance(
    solver, ending: Ending, observers: list[Observer], cost: Cost, saved: Saved | None
) -> RunFailure | DiskFull | None:
    """Step to the end, observed; returns the failure that stopped it, if one did."""
    began = time.perf_counter()
    finished = False
    try:
        _begin(solver, observers, saved)
        while not ending.reached(solver):
            check_interrupted()
            solver.advance(ending.next_stop(solver))
            observing = time.perf_counter()
            for observer in observers:
                observer.step(solver)
            cost.output_s += time.perf_counter() - observing
        for observer in observers:
            observer.finish(solver)
        finished = True
    except (RunFailure, DiskFull) as failure:
        return failure
    finally:
        cost.stepping_s = time.perf_counter() - began - cost.output_s
        if not finished:
            _abandon(observers)
    return None


def _begin(solver, observers: list[Observer], saved: Saved | None) -> None:
    if saved is None:
        for observer in observers:
            observer.start(solver)
        return
    solver.restore(saved.solver)
    for observer in observers:
        observer.resume(solver, saved.observers.get(type(observer).__name__, {}))


def _abandon(observers: list[Observer]) -> None:
    for observer in observers:
        # What stopped the run is told, not that its folder takes no more.
        with suppress(OutputError):
            observer.abandon()


def _conclude(result: RunResult, solver, ending: Ending, contact: ContactWatch, mass: float) -> None:
    result.cost.steps, result.cost.point_updates = solver.step_count, solver.point_updates
    result.points = solver.points.n
    result.energies = {name: float(getattr(solver.ledger, name)) for name in (*ENERGIES, "initial")}
    if result.failure is not None:
        return
    result.ended = ending.reason(solver)
    result.quantities = measure(solver, result.scene, result.wall, result.history, contact)
    result.conservation = _conservation(solver, mass)
    result.final = _final_state(solver)


def _final_state(solver) -> FinalState:
    polygons, points = bar_section(solver)
    fields = {name: values[points] for name, values in cell_data(solver).items()}
    reference, volumes = _reference(solver)
    return FinalState(polygons, fields, bar_outline(solver), reference[points], volumes[points])


def _reference(solver) -> tuple[np.ndarray, np.ndarray]:
    """Places (r, z) of all points in the undeformed bar, above its foot, and their volumes there."""
    places = solver.reference_positions
    r = np.linalg.norm(places[:, :-1], axis=1)
    z = places[:, -1] - solver.mesh.points[:, -1].min()
    stretched = np.linalg.det(solver.points.fields()["deformation_gradient"].array)
    return np.column_stack([r, z]), solver.point_volumes() / stretched


def _conservation(solver, initial_mass: float) -> dict[str, float]:
    """Relative errors: mass, momentum against the wall's impulse, energy by the ledger."""
    before = float(solver.initial_momentum[-1])
    expected = before + solver.wall_impulse
    return {
        "mass": float(abs(solver.mass - initial_mass) / initial_mass),
        "momentum": float(abs(solver.momentum[-1] - expected) / abs(before)),
        "energy": float(abs(solver.ledger.relative_error)),
    }
