"""Which method to take for which accuracy: the fastest variant of both methods, and what their times prove."""

from dataclasses import dataclass

from studies.output.display import number
from studies.work_precision.analysis import EXTRAPOLATED, MEASURED, NOT_RESOLVABLE, Reach, by_variant, reach
from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import Reference

MARKS = {MEASURED: "≤ ", EXTRAPOLATED: "~ "}
ALIKE = 1.2  # times as fast, below which two are

Best = tuple[str, Reach] | None


@dataclass(frozen=True)
class Choice:
    """The answer for one quantity and error.

    best : the fastest variant by finite elements and by material points, None where none reaches it. advice : in words.
    winners : the variants to take, two where either will do, none where no run has the error. beyond : a variant beside
    those whose extrapolated time is the shortest, if any. resolvable : whether the reference is sure enough to tell.
    """

    best: tuple[Best, Best]
    advice: str
    winners: tuple[str, ...] = ()
    beyond: Best = None
    resolvable: bool = True


def choose(runs: list[Measurement], quantity: str, reference: Reference, level: float) -> Choice:
    """The variant to take for an error of a quantity."""
    found = {name: reach(group, quantity, reference, level) for name, group in by_variant(runs).items()}
    if all(each.how == NOT_RESOLVABLE for each in found.values()):
        return Choice((None, None), f"{NOT_RESOLVABLE}, the reference is not that sure", resolvable=False)
    best = _fastest(found, True), _fastest(found, False)
    return Choice(best, *_advice(*best), _beyond(found, best))


def time_text(time: Reach) -> str:
    """Seconds to two digits, with the mark of how they are known."""
    return f"{MARKS.get(time.how, '')}{number(time.seconds, 2)}"


def _fastest(found: dict[str, Reach], is_fem: bool) -> Best:
    """The fastest of a method, one that is extrapolated only where there is no other."""
    known = [
        each for each in found.items() if each[0].startswith("fem") == is_fem and each[1].seconds is not None
    ]
    return min(known, key=lambda each: (each[1].how == EXTRAPOLATED, each[1].seconds), default=None)


def _beyond(found: dict[str, Reach], best: tuple[Best, Best]) -> Best:
    quick = min((each for each in found.items() if each[1].seconds is not None), key=_seconds, default=None)
    return None if quick in best or quick[1].how != EXTRAPOLATED else quick


def _seconds(each: tuple[str, Reach]) -> float:
    return each[1].seconds


def _advice(first: Best, second: Best) -> tuple[str, tuple[str, ...]]:
    """Words and winners. Only a time that is known bears a factor: of two bounds, or beyond all runs, there is none."""
    if first is None or second is None:
        return _alone(first or second)
    hows = {first[1].how, second[1].how}
    quick, slow = sorted((first, second), key=_seconds)
    if hows == {MEASURED}:
        return "either will do, both have it with their coarsest run", (first[0], second[0])
    if hows == {EXTRAPOLATED}:
        return f"neither was run so fine; extrapolated, {_which(quick, slow)}", ()
    if EXTRAPOLATED in hows:
        known, other = sorted((first, second), key=lambda each: each[1].how == EXTRAPOLATED)
        return f"take {known[0]}, whose runs have it; the time of {other[0]} is extrapolated", (known[0],)
    if MEASURED in hows:
        return _beside_bound(quick, slow)
    if _times(quick, slow) < ALIKE:
        return "either will do, they are alike", (first[0], second[0])
    return f"take {quick[0]}, {number(_times(quick, slow), 2)} times as fast", (quick[0],)


def _alone(found: Best) -> tuple[str, tuple[str, ...]]:
    if found is None:
        return "nothing reaches it: refine", ()
    if found[1].how == EXTRAPOLATED:
        return f"no run has it; extrapolated, {found[0]} would", ()
    return f"take {found[0]}", (found[0],)


def _beside_bound(quick: tuple[str, Reach], slow: tuple[str, Reach]) -> tuple[str, tuple[str, ...]]:
    """One time is a bound from above: only where it is the shorter one does it tell how much faster at least."""
    times = _times(quick, slow)
    if quick[1].how != MEASURED:
        return f"take {quick[0]}; the coarsest run of {slow[0]} has it and takes longer", (quick[0],)
    by = f"{number(times, 2)} times as fast" if times >= ALIKE else "as fast"
    return f"take {quick[0]}, at least {by}", (quick[0],)


def _which(quick: tuple[str, Reach], slow: tuple[str, Reach]) -> str:
    return "they are alike" if _times(quick, slow) < ALIKE else f"{quick[0]} is the faster"


def _times(quick: tuple[str, Reach], slow: tuple[str, Reach]) -> float:
    return slow[1].seconds / quick[1].seconds
