"""One measured run: what it gives and what it costs, warm."""

import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from statistics import median
from typing import Any

from core_models.equilibrium.stepping import QuasiStatic
from core_models.errors import MatpointError
from studies.runs.costs import measured
from studies.work_precision.held_memory import held_bytes

WARM_STEPS = 3
ENOUGH = 10.0  # s of measurements, after which a run is not repeated any more


@dataclass(frozen=True)
class Measurement:
    """A variant at a resolution.

    values : answers by quantity [SI]. seconds : processor time of the steps, median of the repeats; spread : of these,
    largest over smallest; repeats : how many. wall_s : the same by the clock. compile_s : compilation, which is part of
    neither. point_updates : calls of the material law; node_updates : nodes of the mesh, or of the grid near particles,
    by steps or corrections; linear_solves : of implicit runs. array_bytes : held by the solver; memory_bytes : largest
    of the process, with what it has compiled. message : why there are no values.
    """

    variant: str
    resolution: int
    values: dict[str, float] = field(default_factory=dict)
    seconds: float = 0.0
    spread: float = 1.0
    compile_s: float = 0.0
    steps: int = 0
    point_updates: int = 0
    points: int = 0
    memory_bytes: int = 0
    message: str = ""
    threads: int = 1
    wall_s: float = 0.0
    repeats: int = 1
    linear_solves: int = 0
    node_updates: int = 0
    array_bytes: int = 0

    def as_json(self) -> dict[str, Any]:
        """Plain data."""
        return asdict(self)


def measure_run(
    variant: str,
    resolution: int,
    build: Callable[[], Any],
    finish: Callable[[Any], dict[str, float]],
    repeats: int,
    threads: int = 1,
) -> Measurement:
    """Run so many times, fewer if that takes longer than ENOUGH, and measure.

    build : makes the solver at time zero, with so many threads. finish : steps it to its end and returns its answers.
    What the program refuses or cannot finish becomes the message.
    A solver of its own makes some steps first, so that nothing is compiled while time is taken.
    """
    try:
        with measured() as warming:
            solver = build()
            for _ in range(WARM_STEPS):
                solver.advance()
        seconds, walls, values = [], [], {}
        with measured() as cost:
            while len(seconds) < repeats and sum(seconds) < ENOUGH:
                solver = build()
                wall, began = time.perf_counter(), time.process_time()
                values = finish(solver)
                seconds.append(time.process_time() - began)
                walls.append(time.perf_counter() - wall)
    except MatpointError as error:
        return Measurement(variant, resolution, message=str(error), threads=threads)
    return Measurement(
        variant,
        resolution,
        values,
        median(seconds),
        max(seconds) / min(seconds) if min(seconds) > 0.0 else 1.0,
        warming.compile_s,
        solver.step_count,
        solver.point_updates,
        solver.points.n,
        cost.peak_memory_bytes,
        threads=threads,
        wall_s=median(walls),
        repeats=len(seconds),
        linear_solves=_linear_solves(solver),
        node_updates=solver.node_updates,
        array_bytes=held_bytes(solver),
    )


def _linear_solves(solver: Any) -> int:
    if not isinstance(solver, QuasiStatic):
        return 0
    return sum(each.iterations for each in (*solver.log.increments, *solver.log.cuts))
