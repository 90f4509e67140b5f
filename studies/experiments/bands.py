"""How the errors of the predictions change with the temperature and the speed of the shots."""

from collections import defaultdict
from collections.abc import Sequence
from statistics import median
from typing import Any

from studies.report.parts import Table

TEMPERATURES = (400.0, 800.0)  # K, between bands
SPEEDS = (200.0, 300.0)  # m/s


def band(value: float, limits: Sequence[float], unit: str) -> str:
    """The band between two limits that holds a value, as text; a limit belongs to the band below it."""
    above = [limit for limit in limits if value > limit]
    below = [limit for limit in limits if value <= limit]
    if not above:
        return f"up to {below[0]:g} {unit}"
    if not below:
        return f"above {above[-1]:g} {unit}"
    return f"{above[-1]:g} to {below[0]:g} {unit}"


def by_temperature_and_speed(done: Sequence[dict[str, Any]]) -> Table:
    """Median absolute errors of length and foot diameter by metal, band of temperature and of speed, and method."""
    groups = defaultdict(list)
    for run in done:
        place = (
            run["material"],
            band(run["temperature"], TEMPERATURES, "K"),
            band(run["velocity"], SPEEDS, "m/s"),
        )
        groups[place, run["method"]].append(run)
    rows = tuple(
        (
            ", ".join((*place, method)),
            len({run["shot"] for run in runs}),
            _median(runs, "final_length"),
            _median(runs, "foot_diameter"),
        )
        for (place, method), runs in sorted(groups.items(), key=lambda item: _order(item[1]))
    )
    head = ("metal, temperature, speed, method", "shots", "length [%]", "foot diameter [%]")
    return Table(
        "By temperature and speed", head, rows, "Medians of absolute errors over all cards of the metal."
    )


def _order(runs: list[dict[str, Any]]) -> tuple:
    first = runs[0]
    hotter = sum(first["temperature"] > limit for limit in TEMPERATURES)
    faster = sum(first["velocity"] > limit for limit in SPEEDS)
    return first["material"], hotter, faster, first["method"]


def _median(runs: list[dict[str, Any]], name: str) -> float | None:
    errors = [100.0 * abs(run["errors"][name]) for run in runs if name in run["errors"]]
    return median(errors) if errors else None
