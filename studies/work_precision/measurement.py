"""One measured run: what it gives and what it costs, warm."""

import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from statistics import median
from typing import Any

from core_models.errors import MatpointError
from studies.costs import measured

WARM_STEPS = 3


@dataclass(frozen=True)
class Measurement:
    """A variant at a resolution.

    values : answers by quantity [SI]. seconds : processor time of the steps, median of the repeats; spread : of these,
    largest over smallest. compile_s : compilation, which is not part of it. memory_bytes : largest of the process.
    message : why there are no values.
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

    def as_json(self) -> dict[str, Any]:
        """Plain data."""
        return asdict(self)


def measure_run(
    variant: str,
    resolution: int,
    build: Callable[[], Any],
    finish: Callable[[Any], dict[str, float]],
    repeats: int,
) -> Measurement:
    """Run so many times and measure; what the program refuses or cannot finish becomes the message.

    build : makes the solver at time zero. finish : steps it to its end and returns its answers.
    A solver of its own makes some steps first, so that nothing is compiled while time is taken.
    """
    try:
        with measured() as warming:
            solver = build()
            for _ in range(WARM_STEPS):
                solver.advance()
        seconds, values = [], {}
        with measured() as cost:
            for _ in range(repeats):
                solver = build()
                began = time.process_time()
                values = finish(solver)
                seconds.append(time.process_time() - began)
    except MatpointError as error:
        return Measurement(variant, resolution, message=str(error))
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
    )
