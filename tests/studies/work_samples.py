"""Made-up measurements for the tests of work and precision."""

from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import Reference

EXACT = Reference(2.0, 0.0, "made")
RESOLUTIONS = (4, 8, 16, 32, 64)


def sequence(name="fem-explicit", order=2.0, error=0.16, seconds=1e-3, cost=3.0):
    """Runs with an error of `error` at 4 that falls with an order, and seconds that grow with another."""
    return [
        Measurement(
            name,
            n,
            {"u": 2.0 * (1.0 + error * (4.0 / n) ** order)},
            seconds * (n / 4.0) ** cost,
            points=n,
            point_updates=n,
        )
        for n in RESOLUTIONS
    ]
