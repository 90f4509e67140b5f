"""The report of a work-precision study: time to reach given errors first, then everything behind it."""

from collections.abc import Iterable
from itertools import islice

from studies.output.display import plus_minus, shown, shown_unit
from studies.report.parts import Curve, Plot, Table
from studies.report.study_page import Report, Section
from studies.work_precision.analysis import (
    EXTRAPOLATED,
    LEVELS,
    MEASURED,
    RESOLVABLE,
    Reach,
    by_variant,
    joint_reference,
    observed_order,
    pareto_front,
    reach,
    relative_error,
)
from studies.work_precision.choice import time_text
from studies.work_precision.choice_section import choice_section
from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import Reference, WorkProblem
from studies.work_precision.verdict import verdict_section

PERCENT = 100.0
LEAD = (
    "Processor seconds that each variant needs for a given error, kernels compiled beforehand, one thread. "
    "How it is measured: docs/work-precision.md."
)


def references_of(problem: WorkProblem, runs: list[Measurement]) -> dict[str, Reference]:
    """References of all quantities; those that are to be extrapolated from the runs are."""
    return {
        name: joint_reference(runs, name) if reference.value is None else reference
        for name, reference in problem.references.items()
    }


def report_of(problem: WorkProblem, measured: list[Measurement], repeats: int) -> Report:
    """The whole report; errors and times are those of runs on one thread."""
    runs = [run for run in measured if run.threads == 1]
    references = references_of(problem, runs)
    failures = [run for run in measured if not run.values]
    spent = sum(run.seconds * run.repeats for run in measured)
    facts = (
        f"{len(runs)} runs",
        f"median of {repeats}" if repeats > 1 else "one run each",
        f"{f'{spent / 60.0:.2g} min' if spent >= 60.0 else f'{spent:.2g} s'} of processor time",
        f"{len(failures)} without an answer",
    )
    quantity, reference = next(iter(references.items()))
    against_time = tuple(islice(_plots(runs, quantity, reference), 1))
    sections = [choice_section(runs, references, against_time)] + [
        Section(
            f"reach-{name}",
            f"Time to reach an error of the {_words(name)}",
            (reach_table(runs, name, reference, problem.units[name]),),
        )
        for name, reference in references.items()
    ]
    sections.append(verdict_section(problem, runs))
    sections += [
        Section(
            f"errors-{name}",
            f"Error of the {_words(name)}",
            (_errors_table(runs, name, reference, problem.units[name]),),
            tuple(_plots(runs, name, reference)),
        )
        for name, reference in references.items()
    ]
    sections += [
        Section("threads", "All threads", (_threads_table(measured),)),
        Section("runs", "Every run", (_runs_table(runs, tuple(references)),)),
        Section("failures", "Refused or gone wrong", (_failures_table(failures),)),
    ]
    return Report(f"Work and precision: {problem.title}", LEAD, facts, tuple(sections))


def reach_table(runs: list[Measurement], quantity: str, reference: Reference, unit: str = "1") -> Table:
    """Seconds to reach each level by variant, and its observed order; the fastest known one of a level is starred.

    Of several upper bounds none is known to be the fastest.
    """
    groups = by_variant(runs)
    found = {
        name: [reach(group, quantity, reference, level) for level in LEVELS] for name, group in groups.items()
    }
    fastest = [_fastest(times) for times in zip(*found.values(), strict=True)]
    rows = [
        (
            name,
            *(_reach_text(time, time is fastest[k]) for k, time in enumerate(times)),
            observed_order(groups[name], quantity, reference),
        )
        for name, times in found.items()
    ]
    head = ("variant", *(f"{PERCENT * level:g} % [s]" for level in LEVELS), "order")
    note = (
        f"Reference: {_reference_text(reference, unit)}. Interpolated between runs; ≤: the coarsest run has it; "
        f"~: extrapolated; not resolvable: below {RESOLVABLE:g} times the reference's uncertainty; "
        "*: the fastest that is not extrapolated, of several ≤ none; order: of the error, observed."
    )
    return Table("Processor seconds", head, tuple(rows), note)


def _fastest(times: Iterable[Reach]) -> Reach | None:
    known = [time for time in times if time.seconds is not None and time.how != EXTRAPOLATED]
    best = min(known, key=lambda time: time.seconds, default=None)
    bounds = sum(time.how == MEASURED for time in known)
    return None if best is None or (best.how == MEASURED and bounds > 1) else best


def _reach_text(time: Reach, is_fastest: bool) -> str:
    return time.how if time.seconds is None else time_text(time) + " *" * is_fastest


def _reference_text(reference: Reference, unit: str) -> str:
    if not reference.value:
        return reference.source
    value = plus_minus(reference.value, reference.uncertainty, unit)
    return f"{value} {shown_unit(unit)}, {reference.source}"


def _errors_table(runs: list[Measurement], quantity: str, reference: Reference, unit: str) -> Table:
    if reference.value is None:
        return Table("Errors", ("variant",), ())
    front = set(map(id, pareto_front(runs, quantity, reference)))
    rows = []
    for name, group in by_variant(runs).items():
        for run in group:
            value, error = shown(run.values[quantity], unit, 6), relative_error(run, quantity, reference)
            best = "yes" if id(run) in front else ""
            rows.append((f"{name} {run.resolution}", value, PERCENT * error, run.seconds, best))
    head = ("run", f"value [{shown_unit(unit) or '-'}]", "error [%]", "s", "on the Pareto front")
    return Table("Errors", head, tuple(rows), f"Reference: {_reference_text(reference, unit)}.")


def _plots(runs: list[Measurement], quantity: str, reference: Reference) -> Iterable[Plot]:
    if reference.value is None:
        return
    works = {
        "processor time [s]": "seconds",
        "point updates": "point_updates",
        "node updates": "node_updates",
        "linear solves": "linear_solves",
    }
    for label, attribute in works.items():
        curves = [
            Curve(
                name,
                tuple(float(getattr(run, attribute)) for run in group),
                tuple(max(PERCENT * relative_error(run, quantity, reference), 1e-6) for run in group),
                "fem" if name.startswith("fem") else "mpm",
            )
            for name, group in by_variant(runs).items()
            if all(getattr(run, attribute) for run in group)
        ]
        yield Plot(f"Error of the {_words(quantity)}", label, "error [%]", tuple(curves), logarithmic=True)


def _runs_table(runs: list[Measurement], quantities: tuple[str, ...]) -> Table:
    solved = any(run.linear_solves for run in runs)
    rows = [
        (
            f"{run.variant} {run.resolution}", run.points, run.steps, run.point_updates,
            run.node_updates, *((run.linear_solves,) if solved else ()), run.seconds, run.repeats, run.spread,
            run.compile_s, run.array_bytes / 2**20 or None, round(run.memory_bytes / 2**20),
            *(run.values[name] for name in quantities),
        )
        for run in runs if run.values
    ]  # fmt: skip
    head = (
        "run", "points", "steps", "point updates", "node updates", *(("linear solves",) if solved else ()), "s",
        "repeats", "slowest / fastest", "compile s", "MiB of arrays", "MiB of the process", *quantities,
    )  # fmt: skip
    note = "Arrays: what the solver holds; the process keeps, besides, what was compiled and run before."
    return Table("Runs", head, tuple(rows), note)


def _threads_table(measured: list[Measurement]) -> Table:
    alone = {(run.variant, run.resolution): run for run in measured if run.threads == 1}
    rows = []
    for run in measured:
        if run.threads > 1 and run.values:
            one = alone[run.variant, run.resolution]
            same = "yes" if run.values == one.values else "no"
            rows.append(
                (
                    f"{run.variant} {run.resolution}",
                    run.threads,
                    one.wall_s,
                    run.wall_s,
                    one.wall_s / run.wall_s,
                    same,
                )
            )
    head = ("finest run", "threads", "one thread [s]", "all [s]", "times as fast", "bitwise the same")
    return Table("Seconds by the clock", head, tuple(rows))


def _failures_table(failures: list[Measurement]) -> Table:
    rows = tuple((f"{run.variant} {run.resolution}", run.message) for run in failures)
    return Table("What the program said", ("run", "message"), rows)


def _words(quantity: str) -> str:
    return quantity.replace("_", " ")
