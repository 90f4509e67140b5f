"""Observer: pictures of the run for ParaView, frames/*.vtu and series.pvd."""

import numpy as np

from core_models.checkpoint import Checkpoint
from studies.observers.observer import Observer
from studies.output.output_folder import OutputFolder


class Frames(Observer):
    """Writes the deformed domains of all points with their fields at `count` even times and at the end."""

    def __init__(self, folder: OutputFolder, end: float, count: int = 20) -> None:
        self._folder = folder
        self._interval = end / count
        self._written: list[tuple[float, str]] = []
        self._next = 0.0

    def start(self, solver) -> None:
        """Write the initial state."""
        self._write(solver)

    def resume(self, solver, checkpoint: Checkpoint) -> None:
        """Go on after the frames written so far; later ones are written over."""
        self._written = [(time, frame_name(k)) for k, time in enumerate(checkpoint["times"].tolist())]
        self._next = float(checkpoint["next"])

    def checkpoint(self) -> Checkpoint:
        """Times of the frames and of the next one."""
        return {"times": np.array([time for time, _ in self._written]), "next": np.array(self._next)}

    def step(self, solver) -> None:
        """Write when the next frame's time has come."""
        if solver.time >= self._next:
            self._write(solver)

    def finish(self, solver) -> None:
        """Write the final state, if the last step did not."""
        if solver.time > self._written[-1][0]:
            self._write(solver)

    def _write(self, solver) -> None:
        from meshes.io import write_domains_vtu, write_pvd

        self._next = (np.floor(solver.time / self._interval) + 1.0) * self._interval
        name = frame_name(len(self._written))
        write_domains_vtu(self._folder.file(name), solver.domains(), cell_data(solver))
        self._written.append((solver.time, name))
        write_pvd(self._folder.file("series.pvd"), self._written)


def frame_name(number: int) -> str:
    """File of a frame in the run's folder."""
    return f"frames/frame-{number:04d}.vtu"


def cell_data(solver) -> dict[str, np.ndarray]:
    """Fields of all points by name, with pressure and von Mises stress [Pa] derived from the stress."""
    data = {name: field.array for name, field in solver.points.fields().items() if field.array.ndim <= 2}
    if "stress" in data:
        data["pressure"] = -data["stress"][:, :3].mean(axis=1)
        data["mises_stress"] = _mises(data["stress"])
    return {name: np.ascontiguousarray(values, dtype=float) for name, values in data.items()}


def _mises(stress: np.ndarray) -> np.ndarray:
    normal, shear = stress[:, :3], stress[:, 3:]
    deviator = normal - normal.mean(axis=1, keepdims=True)
    return np.sqrt(1.5 * ((deviator**2).sum(axis=1) + 2.0 * (shear**2).sum(axis=1)))
