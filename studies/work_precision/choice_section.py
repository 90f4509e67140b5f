"""The first section of the report: which method to take for which accuracy, at a glance and in sentences."""

from itertools import groupby

from studies.output.display import shown_name, shown_title
from studies.report.parts import Plot, Table
from studies.report.study_page import TOLD, Section, Verdict
from studies.work_precision.analysis import LEVELS, NOT_REACHED, NOT_RESOLVABLE
from studies.work_precision.choice import Best, Choice, choose, time_text
from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import Reference

METHODS = "finite elements", "material points"
NOTE = (
    "The fastest variant of each method in processor seconds on one thread. *: to be taken; ≤: its coarsest run is "
    "good enough; ~: extrapolated, named only where nothing else is there."
)

Answer = tuple[str, float, Choice]


def choice_section(
    runs: list[Measurement], references: dict[str, Reference], plots: tuple[Plot, ...] = ()
) -> Section:
    """A grid of the fastest variants for every quantity and level, beside it the plots; then the same in sentences."""
    answers = [
        (quantity, level, choose(runs, quantity, reference, level))
        for quantity, reference in references.items()
        for level in LEVELS
    ]
    told = tuple(Verdict(TOLD, text) for text in _sentences(answers))
    return Section(
        "choice",
        "Which to take",
        (_grid(answers),),
        plots,
        verdicts=told,
        data=(_data(answers),),
        at_a_glance=True,
    )


def _grid(answers: list[Answer]) -> Table:
    """A row for levels in succession that have the same answer."""
    rows = [
        (f"{shown_name(quantity)}: {_levels(group)}", *cells)
        for (quantity, *cells), group in groupby(answers, key=lambda each: (each[0], *_cells(each[2])))
    ]
    return Table("Which to take", ("error", *METHODS), tuple(rows), NOTE)


def _cells(choice: Choice) -> tuple[str, ...]:
    if not choice.resolvable:
        return NOT_RESOLVABLE, NOT_RESOLVABLE
    return tuple(_cell(best, choice.winners) for best in choice.best)


def _cell(best: Best, winners: tuple[str, ...]) -> str:
    return NOT_REACHED if best is None else _variant(best) + " *" * (best[0] in winners)


def _sentences(answers: list[Answer]) -> list[str]:
    """A sentence for each answer, of all levels that have the same one after the other."""
    return [
        f"{shown_title(quantity)} within {_levels(group)}: {told}"
        for (quantity, told), group in groupby(answers, key=lambda each: (each[0], _told(each[2])))
    ]


def _levels(group) -> str:
    return f"{', '.join(f'{100.0 * level:g}' for _, level, _ in group)} %"


def _told(choice: Choice) -> str:
    if choice.best == (None, None):
        return f"{choice.advice}."
    times = (
        f"{method} do not reach it" if best is None else _variant(best)
        for method, best in zip(METHODS, choice.best, strict=True)
    )
    beyond = "" if choice.beyond is None else f"; extrapolated, {_variant(choice.beyond)}"
    return f"{choice.advice}. {'; '.join(times)}{beyond}."


def _variant(best: tuple) -> str:
    name, time = best
    return f"{name} {time_text(time)} s"


def _data(answers: list[Answer]) -> Table:
    """The same with all digits."""
    head = (
        "quantity",
        "error [%]",
        *(f"{method}{of}" for method in METHODS for of in ("", " [s]", " known")),
    )
    rows = tuple(
        (quantity, 100.0 * level, *(cell for best in choice.best for cell in _raw(best)), choice.advice)
        for quantity, level, choice in answers
    )
    return Table("", (*head, "take"), rows)


def _raw(best: Best) -> tuple:
    return (None, None, None) if best is None else (best[0], best[1].seconds, best[1].how)
