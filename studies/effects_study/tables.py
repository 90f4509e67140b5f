"""Tables and report of the effects study."""

from collections.abc import Iterable

from studies.decisions.beforehand import Decision
from studies.effects_study.off import OffCost
from studies.effects_study.switched import AS_IT_IS, Switched
from studies.output.display import number, shown_title
from studies.report.parts import Table
from studies.report.study_page import TOLD, Report, Section, Verdict
from studies.scenes.scene import Scene
from studies.work_precision.measurement import Measurement

FIELDS = {"max_plastic_strain": "equivalent_plastic_strain", "max_temperature": "temperature"}
MATTERS = 0.005  # relative change of an answer that matters
SMALLEST = 5e-5  # relative change that is still told in short
SHAPE = ("final_length", "foot_radius")


def report_of(
    scene: Scene, wall: str, runs: list[Switched], found: list[Decision], resolution: int, offs: list[OffCost]
) -> Report:
    """Decisions first, then costs and changes, then how the two compare, and what costs nothing."""
    lead = "One effect after the other switched: what it costs in time and memory, and what it changes in the answers."
    facts = (f"wall {wall}", f"{resolution} across the radius", f"{scene.end.limit(wall) * 1e6:g} µs")
    return Report(
        f"Effects of {scene.name}",
        lead,
        facts,
        (
            Section("short", "In short", verdicts=tuple(_in_short(runs))),
            Section("decisions", "Decided from the scene's own numbers", (_decision_table(found),)),
            Section("changes", "What each costs and changes", (change_table(runs),)),
            Section("verdicts", "Decisions against results", (verdict_table(runs, found),)),
            Section("off", "What is off costs nothing", (_off_table(offs),)),
            Section("failures", "Refused or gone wrong", (_failures(runs),)),
        ),
    )


def _decision_table(found: list[Decision]) -> Table:
    rows = tuple(
        (each.effect, "on" if each.on else "off", each.number, each.threshold, _asked(each), each.meaning)
        for each in found
    )
    return Table("Decisions", ("effect", "scene", "number", "threshold", "asked for", "what it is"), rows)


def _asked(decision: Decision) -> str:
    return {True: "yes", False: "no", None: "cannot tell"}[decision.wanted]


def _changes(switched: Switched, base: Measurement) -> dict[str, float]:
    both = set(switched.run.values) & set(base.values)
    return {name: switched.run.values[name] / base.values[name] - 1.0 for name in both}


def _in_short(runs: list[Switched]) -> Iterable[Verdict]:
    """A sentence for each effect: what it changes in the shape and how long it takes, what changes most first."""
    base = {each.method: each.run for each in runs if each.effect == AS_IT_IS}
    switched = [
        each for each in runs if each.effect != AS_IT_IS and each.run.values and base[each.method].values
    ]
    effects = dict.fromkeys((each.effect, each.to) for each in switched)
    told = []
    for effect, to in effects:
        group = [each for each in switched if (each.effect, each.to) == (effect, to)]
        parts = [_part(each, base[each.method]) for each in group]
        largest = max(abs(change) for change, _ in parts)
        told.append((largest, f"{shown_title(f'{effect} {to}')}: {'; '.join(text for _, text in parts)}."))
    return (Verdict(TOLD, text) for _, text in sorted(told, reverse=True))


def _part(each: Switched, base: Measurement) -> tuple[float, str]:
    changes = _changes(each, base)
    name = max(SHAPE, key=lambda name: abs(changes[name]))
    times = each.run.seconds / base.seconds
    change = f"{100.0 * changes[name]:+.2f} %" if abs(changes[name]) >= SMALLEST else "not"
    words = f"{name.replace('_', ' ')} {change}"
    return changes[name], f"by {each.method} {words}, {number(times, 2)} times as long"


def change_table(runs: list[Switched]) -> Table:
    """Times, memory and changes of all answers by effect and method, relative to the scene as it is."""
    names = (*SHAPE, *FIELDS)
    rows, base = [], None
    for each in runs:
        if each.effect == AS_IT_IS:
            base = each.run
        if not each.run.values or base is None or not base.values:
            continue
        changes = _changes(each, base)
        rows.append(
            (
                f"{each.method}: {each.effect} {each.to}".rstrip(),
                each.run.seconds,
                each.run.seconds / base.seconds,
                each.run.steps / base.steps,
                each.run.array_bytes / 2**20,
                *(None if name not in changes else 100.0 * changes[name] for name in names),
            )
        )
    head = (
        "run", "s", "times as long", "times the steps", "MiB of arrays",
        *(f"{name.replace('_', ' ')} [%]" for name in names),
    )  # fmt: skip
    note = f"Processor seconds of the steps, {_repeats_text(runs)}; memory is what the solver's arrays hold."
    return Table("Changes against the scene as it is", head, tuple(rows), note)


def _repeats_text(runs: list[Switched]) -> str:
    if all(each.run.repeats == 1 for each in runs):
        return "one run each"
    spread = max((each.run.spread for each in runs if each.run.values), default=1.0)
    return f"median of repeats, which differ by up to {100.0 * (spread - 1.0):.0f} %"


def _off_table(offs: list[OffCost]) -> Table:
    rows = tuple(
        (
            each.method, min(each.off), min(each.never), 100.0 * (each.ratio - 1.0), 100.0 * each.noise,
            "yes" if each.same else "no",
        )
        for each in offs
    )  # fmt: skip
    head = (
        "method", "all effects off [s]", "card that never had them [s]", "costs [%]", "noise ± [%]",
        "bitwise the same answers",
    )  # fmt: skip
    note = (
        "Damage, heating, conduction, viscosity and friction off, beside a card without the numbers that only these "
        "read; the fastest of runs of both made in turn; noise: how far the faster quarter of equal runs is from it."
    )
    return Table("Off beside never", head, rows, note)


def verdict_table(runs: list[Switched], found: list[Decision]) -> Table:
    """Whether each decision was right: the largest change of length or foot radius by any method."""
    rows = []
    for decision in found:
        largest = _largest_change(runs, decision.effect)
        if largest is None:
            continue
        mattered = largest >= MATTERS
        rows.append(
            (
                decision.effect,
                _asked(decision),
                100.0 * largest,
                "yes" if mattered else "no",
                _verdict(decision.wanted, mattered),
            )
        )
    head = ("effect", "asked for", "largest change of the shape [%]", "matters", "so the decision was")
    note = f"A change of {100.0 * MATTERS:g} % or more of final length or foot radius matters."
    return Table("Afterwards", head, tuple(rows), note)


def _verdict(wanted: bool | None, mattered: bool) -> str:
    if wanted is None:
        return "left to the scene"
    if wanted == mattered:
        return "right"
    return "cautious: kept for nothing" if wanted else "wrong: it is missing"


def _largest_change(runs: list[Switched], effect: str) -> float | None:
    base = {each.method: each.run for each in runs if each.effect == AS_IT_IS}
    changes = [
        abs(_changes(each, base[each.method])[name])
        for each in runs
        if each.effect == effect and each.run.values and base[each.method].values
        for name in SHAPE
    ]
    return max(changes, default=None)


def _failures(runs: list[Switched]) -> Table:
    rows = tuple((f"{r.method}: {r.effect} {r.to}", r.run.message) for r in runs if not r.run.values)
    return Table("What the program said", ("run", "message"), rows)
