"""Which method to take for which accuracy: the fastest variant of both methods for each quantity and error."""

from itertools import groupby

from studies.output.display import number, shown_title
from studies.report.parts import Table
from studies.report.study_page import NEUTRAL, Section, Verdict
from studies.work_precision.analysis import EXTRAPOLATED, LEVELS, NOT_RESOLVABLE, Reach, by_variant, reach
from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import Reference

MARKS = {"measured": "≤ ", "extrapolated": "~ "}
ALIKE = 1.2  # times as fast, below which two are
LEAD = (
    "The fastest variant of each method in processor seconds on one thread; ≤: its coarsest run is good enough; "
    "~: extrapolated, which is named only where nothing else is there."
)

Best = tuple[str, Reach] | None


def choice_section(runs: list[Measurement], references: dict[str, Reference]) -> Section:
    """For every quantity and level the fastest variant by finite elements and by material points, and which to take."""
    rows = tuple(
        (quantity, 100.0 * level, *_answers(runs, quantity, reference, level))
        for quantity, reference in references.items()
        for level in LEVELS
    )
    head = ("quantity", "error [%]", "finite elements", "material points", "take")
    sentences = tuple(Verdict(NEUTRAL, text) for text in _sentences(rows))
    return Section("choice", "Which to take", lead=LEAD, verdicts=sentences, data=(Table("", head, rows),))


def _sentences(rows: tuple) -> list[str]:
    """A sentence for each answer, of all levels that have the same one after the other."""
    return [
        f"{shown_title(quantity)} within {', '.join(f'{row[1]:g}' for row in group)} %: {_told(*answers)}"
        for (quantity, *answers), group in groupby(rows, key=lambda row: (row[0], *row[2:]))
    ]


def _told(fem: str, mpm: str, advice: str) -> str:
    return f"{advice}." if fem == mpm else f"{advice}. {fem}; {mpm}."


def _answers(runs: list[Measurement], quantity: str, reference: Reference, level: float) -> tuple[str, ...]:
    found = {name: reach(group, quantity, reference, level) for name, group in by_variant(runs).items()}
    if all(each.how == NOT_RESOLVABLE for each in found.values()):
        return NOT_RESOLVABLE, NOT_RESOLVABLE, f"{NOT_RESOLVABLE}, the reference is not that sure"
    best = [_fastest(found, is_fem) for is_fem in (True, False)]
    return _text("finite elements", best[0]), _text("material points", best[1]), _advice(*best)


def _fastest(found: dict[str, Reach], is_fem: bool) -> Best:
    """The fastest of a method, one that is extrapolated only where there is no other."""
    known = [
        each for each in found.items() if each[0].startswith("fem") == is_fem and each[1].seconds is not None
    ]
    return min(known, key=lambda each: (each[1].how == EXTRAPOLATED, each[1].seconds), default=None)


def _text(method: str, best: Best) -> str:
    if best is None:
        return f"{method} do not reach it"
    name, time = best
    return f"{name} {MARKS.get(time.how, '')}{number(time.seconds, 2)} s"


def _advice(first: Best, second: Best) -> str:
    if first is None or second is None:
        found = first or second
        return f"take {found[0]}" if found else "nothing reaches it: refine"
    quick, slow = sorted((first, second), key=lambda each: each[1].seconds)
    times = slow[1].seconds / quick[1].seconds
    return f"take {quick[0]}, {number(times, 2)} times as fast" if times >= ALIKE else "take either"
