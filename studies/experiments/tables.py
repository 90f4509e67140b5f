"""What the experiments say: medians of errors, the methods' difference beside the models' error, every run."""

from collections import defaultdict
from collections.abc import Iterable
from statistics import median
from typing import Any

from studies.experiments.bands import by_temperature_and_speed
from studies.experiments.shots import MEASURED, MEASURED_SCATTER
from studies.report.parts import Curve, Plot, Table
from studies.report.study_page import Section
from studies.sweep.job import COMPLETE

Result = dict[str, Any]
NAMES = {
    "final_length": "length",
    "foot_diameter": "foot diameter",
    "diameter_at_02_L0": "W",
    "undeformed_length": "X_f",
}
PERCENT = 100.0


def sections(results: list[Result], methods: tuple[str, ...]) -> tuple[Section, ...]:
    """All sections of the report; the results that have failed have their own."""
    done = [result for result in results if result["status"] == COMPLETE]
    gone_wrong = [result for result in results if result["status"] != COMPLETE]
    low, high = (PERCENT * value for value in MEASURED_SCATTER)
    scatter = f"Two digitisations of the same shots differ by {low:g} to {high:g} %."
    return (
        Section("medians", "Predicted against measured", (_medians(done),), remarks=(scatter,)),
        Section("bands", "Cold and hot, slow and fast", (by_temperature_and_speed(done),)),
        Section("methods", "The methods' difference beside the models' error", (_methods(done, methods),)),
        Section("shots", "Length by speed", plots=tuple(_plots(done))),
        Section("runs", "Every run", (_runs(done),)),
        Section("failures", "Runs that went wrong", (_failures(gone_wrong),)),
    )


def _by(results: Iterable[Result], *keys: str) -> dict[tuple, list[Result]]:
    groups: dict[tuple, list[Result]] = defaultdict(list)
    for result in results:
        groups[tuple(result[key] for key in keys)].append(result)
    return dict(groups)


def _by_speed(results: list[Result]) -> list[Result]:
    return sorted(results, key=lambda run: run["velocity"])


def _median_error(results: list[Result], name: str) -> float | None:
    errors = [abs(result["errors"][name]) for result in results if name in result["errors"]]
    return PERCENT * median(errors) if errors else None


def _medians(done: list[Result]) -> Table:
    rows = []
    for (material, card, method), group in sorted(_by(done, "material", "card", "method").items()):
        distances = [result["profile_distance"] for result in group if result["profile_distance"] is not None]
        rows.append(
            (
                f"{material}, {card}, {method}",
                len(group),
                sum(_parted(result) is not None for result in group),
                *(_median_error(group, name) for name in MEASURED),
                1e3 * median(distances) if distances else None,
            )
        )
    head = (
        "metal, card, method",
        "shots",
        "parted",
        *(f"{NAMES[name]} [%]" for name in MEASURED),
        "profile [mm]",
    )
    note = (
        "Medians of absolute errors relative to what was measured, of X_f relative to L0, over the runs that came to "
        "an end; parted: in so many of them neighbouring particles share no node of the grid any more at some time, "
        "which tears the body without any physics of fracture; profile: root-mean-square distance, where there is a "
        "measured one."
    )
    return Table("Median absolute error by metal and card", head, tuple(rows), note)


def _methods(done: list[Result], methods: tuple[str, ...]) -> Table:
    rows = []
    for (material, card), group in sorted(_by(done, "material", "card").items()):
        shots = [{run["method"]: run for run in runs} for runs in _by(group, "shot").values()]
        pairs = [tuple(runs[method] for method in methods) for runs in shots if set(methods) <= set(runs)]
        for name in ("final_length", "foot_diameter"):
            both = [(a["predicted"][name], b["predicted"][name]) for a, b in pairs]
            gaps = [PERCENT * abs(b - a) / a for a, b in both]
            if gaps:
                rows.append(
                    (
                        f"{material}, {card}, {NAMES[name]}",
                        len(gaps),
                        median(gaps),
                        max(gaps),
                        _median_error([run for pair in pairs for run in pair], name),
                    )
                )
    head = (
        "metal, card, quantity",
        "shots",
        "methods apart, median [%]",
        "largest [%]",
        "model's error, median [%]",
    )
    return Table(
        f"{methods[1]} against {methods[0]}",
        head,
        tuple(rows),
        "At the resolutions of this study, not at their limits.",
    )


def _plots(done: list[Result]) -> Iterable[Plot]:
    for (material,), group in sorted(_by(done, "material").items()):
        curves = [
            Curve(
                f"{card}, {method}",
                tuple(run["velocity"] for run in runs),
                tuple(PERCENT * run["errors"]["final_length"] for run in runs),
                "fem" if method.startswith("fem") else "mpm",
            )
            for (card, method), runs in sorted(_by(_by_speed(group), "card", "method").items())
        ]
        yield Plot(
            f"Error of the final length, {material}",
            "speed [m/s]",
            "error [%]",
            tuple(curves),
            scattered=True,
        )


def _runs(done: list[Result]) -> Table:
    rows = [
        (
            result["shot"], result["material"], result["temperature"], result["velocity"], result["card"],
            result["method"], result["resolution"], result["steps"], result["seconds"], _parted(result),
            *(value for name in MEASURED for value in _triple(result, name)), _millimetres(result["profile_distance"]),
        )
        for result in done
    ]  # fmt: skip
    columns = [
        f"{NAMES[name]} {what}"
        for name in MEASURED
        for what in ("measured [mm]", "predicted [mm]", "error [%]")
    ]
    head = (
        "shot", "metal", "K", "m/s", "card", "method", "resolution", "steps", "s", "particles part at [s]", *columns,
        "profile [mm]",
    )  # fmt: skip
    return Table("Runs", head, tuple(rows))


def _parted(result: Result) -> float | None:
    found = result.get("numerical_fracture")
    return None if found is None else found["time"]


def _triple(result: Result, name: str) -> tuple:
    error = result["errors"].get(name)
    values = (_millimetres(result[kind].get(name)) for kind in ("measured", "predicted"))
    return (*values, None if error is None else PERCENT * error)


def _millimetres(value: float | None) -> float | None:
    return None if value is None else 1e3 * value


def _failures(gone_wrong: list[Result]) -> Table:
    rows = [(result["key"], result["message"]) for result in gone_wrong]
    return Table("What the program said", ("run", "message"), tuple(rows))
