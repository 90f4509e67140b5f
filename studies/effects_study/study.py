"""The effects study: a scene as it is, then with each effect switched: what that costs and changes."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core_models.walls import check_wall
from studies.bar.outline import bar_outline
from studies.bar.shape import foot_radius, length
from studies.effects_study.decisions import Decision, decisions
from studies.effects_study.switches import SWITCHES
from studies.methods import build_solver, check_run
from studies.output_folder import OutputFolder
from studies.report.study_page import Report, Section, write_report
from studies.run_record import to_json
from studies.scene import Scene
from studies.verification.outcome import Table
from studies.versions import processor, versions
from studies.work_precision.bars import with_fixed_end
from studies.work_precision.measurement import Measurement, measure_run

AS_IT_IS = "as it is"
SPATIAL = "three dimensions"
FIELDS = {"max_plastic_strain": "equivalent_plastic_strain", "max_temperature": "temperature"}
MATTERS = 0.005  # relative change of an answer that matters
SHAPE = ("final_length", "foot_radius")


@dataclass(frozen=True)
class Switched:
    """One run: the effect that is switched, to what, by which method, and what was measured."""

    effect: str
    to: str
    method: str
    run: Measurement


@dataclass(frozen=True)
class Outcome:
    """All runs, of each method the scene as it is first; remark : what could not be written, or nothing."""

    runs: list[Switched]
    report: Report
    remark: str


def planned(scene: Scene, method: str, spatial: bool) -> list[tuple[str, str, str, Scene]]:
    """Effect, what it is switched to, method and scene of each run."""
    plan = [(AS_IT_IS, "", method, scene)]
    for switch in SWITCHES:
        switched = switch.switched(scene)
        if switched is not None:
            plan.append((switch.effect, switched[0], method, switched[1]))
    if spatial and ":" not in method:
        plan.append((SPATIAL, "on", f"{method}:{'spatial' if method == 'mpm' else 'hex8'}", scene))
    return plan


def compare_effects(
    scene: Scene,
    out: Path | str,
    *,
    methods: tuple[str, ...] = ("fem-explicit", "mpm"),
    resolution: int = 8,
    wall: str | None = None,
    repeats: int = 3,
    spatial: bool = True,
    tell: Callable[[Switched], None] = lambda run: None,
) -> Outcome:
    """Measure all and write results.json, tables as CSV, report.html and report.md.

    A scene that ends with release is compared at the end time of its plane wall, the same for all runs.
    Raises SceneError for unknown methods, OutputError for a folder in use before anything is run.
    """
    wall = check_wall(wall or scene.wall)
    scene = with_fixed_end(scene)
    for method in methods:
        check_run(scene, method, resolution)
    with OutputFolder(out) as folder:
        runs = []
        for method in methods:
            for effect, to, variant, switched in planned(scene, method, spatial):
                runs.append(
                    Switched(effect, to, method, _measure(switched, variant, resolution, wall, repeats))
                )
                tell(runs[-1])
        found = decisions(scene, wall)
        report = report_of(scene, wall, runs, found, resolution)
        record = [{"effect": r.effect, "to": r.to, "method": r.method, "run": r.run.as_json()} for r in runs]
        folder.write_text(
            "results.json",
            to_json({"study": "effects", "runs": record, "versions": versions(), "processor": processor()}),
        )
        remark = write_report(report, folder)
    return Outcome(runs, report, remark)


def _measure(scene: Scene, variant: str, resolution: int, wall: str, repeats: int) -> Measurement:
    def finish(solver: Any) -> dict[str, float]:
        end = scene.end.limit(wall)
        while solver.time < end:
            solver.advance(end)
        return answers(solver)

    return measure_run(
        variant, resolution, lambda: build_solver(scene, variant, resolution, wall, 1), finish, repeats
    )


def answers(solver: Any) -> dict[str, float]:
    """Final length, foot radius [m]; largest plastic strain and temperature [K] where there are such."""
    outline, fields = bar_outline(solver), solver.points.fields()
    largest = {name: float(fields[of].array.max()) for name, of in FIELDS.items() if of in fields}
    return {"final_length": length(outline), "foot_radius": foot_radius(outline)} | largest


def report_of(
    scene: Scene, wall: str, runs: list[Switched], found: list[Decision], resolution: int
) -> Report:
    """Decisions first, then costs and changes, then how the two compare."""
    lead = "One effect after the other switched: what it costs in time and memory, and what it changes in the answers."
    facts = (f"wall {wall}", f"{resolution} across the radius", f"{scene.end.limit(wall) * 1e6:g} µs")
    return Report(
        f"Effects of {scene.name}",
        lead,
        facts,
        (
            Section("decisions", "Decided from the scene's own numbers", (_decision_table(found),)),
            Section("changes", "What each costs and changes", (change_table(runs),)),
            Section("verdicts", "Decisions against results", (verdict_table(runs, found),)),
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
                round(each.run.memory_bytes / 2**20),
                *(None if name not in changes else 100.0 * changes[name] for name in names),
            )
        )
    head = ("run", "s", "times as long", "MiB", *(f"{name.replace('_', ' ')} [%]" for name in names))
    return Table("Changes against the scene as it is", head, tuple(rows))


def verdict_table(runs: list[Switched], found: list[Decision]) -> Table:
    """Whether each decision was right: the largest change of length or foot radius by any method."""
    rows = []
    for decision in found:
        largest = _largest_change(runs, decision.effect)
        if largest is None:
            continue
        mattered = largest >= MATTERS
        right = decision.wanted is None or decision.wanted == mattered
        rows.append(
            (
                decision.effect,
                _asked(decision),
                100.0 * largest,
                "yes" if mattered else "no",
                "" if right else "no",
            )
        )
    head = ("effect", "asked for", "largest change of the shape [%]", "matters", "decided rightly")
    note = f"A change of {100.0 * MATTERS:g} % or more of final length or foot radius matters; empty: yes."
    return Table("Afterwards", head, tuple(rows), note)


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
