"""Decisions about effects as plain text."""

from studies.display import ABSENT
from studies.effects_study.decisions import Decision
from studies.text_table import aligned


def decisions_text(found: list[Decision]) -> str:
    """One line for each: the effect, whether it is on, number against threshold, and whether they agree."""
    width = max(len(each.meaning) for each in found)
    return aligned(
        [
            [
                each.effect,
                "on " if each.on else "off",
                _number(each),
                _verdict(each),
                each.meaning.ljust(width),
            ]
            for each in found
        ]
    )


def _number(decision: Decision) -> str:
    if decision.number is None:
        return ABSENT
    sign = "≥" if decision.wanted else "<"
    return f"{decision.number:.2g} {sign} {decision.threshold:g}"


def _verdict(decision: Decision) -> str:
    if decision.wanted is None:
        return "the scene's choice"
    if decision.wanted == decision.on:
        return "as it should be"
    return "asked for, left out" if decision.wanted else "not needed, kept"
