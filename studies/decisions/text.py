"""Decisions about effects as plain text."""

from studies.decisions.afterwards import is_confirmed
from studies.decisions.beforehand import Decision
from studies.output.display import ABSENT
from studies.output.text_table import aligned

NUMBERS = 2  # the column of the number and its threshold


def decisions_text(found: list[Decision]) -> str:
    """One line for each: the effect, whether it is on, number against threshold, and whether they agree."""
    return _lines([[*_decided(each), each.meaning] for each in found])


def verified_text(found: list[tuple[Decision, float | None]]) -> str:
    """The same, and beside it the number that a run has found, and whether it is needed, as the scene's number said."""
    return _lines([[*_decided(each), _afterwards(each, number), each.meaning] for each, number in found])


def _lines(rows: list[list[str]]) -> str:
    """Columns under each other; words, which are in all but that of the numbers, begin under each other."""
    widths = [max(len(cell) for cell in column) for column in zip(*rows, strict=True)]
    return aligned(
        [
            [cell if column == NUMBERS else cell.ljust(widths[column]) for column, cell in enumerate(row)]
            for row in rows
        ]
    )


def _decided(decision: Decision) -> list[str]:
    return [decision.effect, "on " if decision.on else "off", _number(decision), _verdict(decision)]


def _afterwards(decision: Decision, number: float | None) -> str:
    if number is None:
        return "the run cannot tell"
    confirmed = is_confirmed(decision, number)
    if confirmed is None:
        return f"found {number:.2g}"
    needed = "needed" if number >= decision.threshold else "not needed"
    return f"found {number:.2g}: {needed}" + (", as foreseen" if confirmed else " after all")


def _number(decision: Decision) -> str:
    if decision.number is None:
        return ABSENT
    sign = "≥" if decision.wanted else "<"
    return f"{decision.number:.2g} {sign} {decision.threshold:g}"


def _verdict(decision: Decision) -> str:
    if decision.on and not decision.acts:
        return "reported only: changes no answer"
    if decision.wanted is None:
        return "the scene's choice"
    if decision.wanted == decision.on:
        return "as it should be"
    return "asked for, left out" if decision.wanted else "not needed, kept"
