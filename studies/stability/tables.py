"""What the stability study shows: matrix, reasons, true limits of the step, every number."""

import re
from collections import Counter
from textwrap import fill
from typing import Any

from studies.report.parts import Table
from studies.report.study_page import Report, Section
from studies.stability.cases import find_case
from studies.stability.cell import FAILED, REFUSED, RESCUED, STABLE
from studies.stability.true_limit import HIGHEST, STEPS
from studies.stability.variants import is_implicit

MARKS = {STABLE: "stable", RESCUED: "redone", REFUSED: "refused", FAILED: "FAILED"}
PARTED = "parted"  # stable in numbers, but neighbouring particles no longer hold together
NAMES, WIDTH = 24, 100  # letters of a case, and of a line, in the terminal


def summary(cells: list[dict[str, Any]]) -> str:
    """For the terminal: each case, how many variants stay stable, the names of the others, and counts."""
    lines = []
    for name in dict.fromkeys(cell["case"] for cell in cells):
        here = [cell for cell in cells if cell["case"] == name]
        stable = sum(cell["verdict"] in (STABLE, RESCUED) for cell in here)
        others = [said for word in (PARTED, MARKS[REFUSED], MARKS[FAILED]) if (said := _named(here, word))]
        line = f"{name:<{NAMES}} {stable:>2} of {len(here)} stable" + "; ".join(["", *others])
        lines.append(fill(line, WIDTH, subsequent_indent=" " * (NAMES + 1), break_on_hyphens=False))
    return "\n".join([*lines, "", ", ".join(_counts(cells))])


def mark(cell: dict[str, Any]) -> str:
    """The verdict on a cell in a word or two: of one that came to its end, whether particles have parted too."""
    came_through = cell["verdict"] in (STABLE, RESCUED)
    parted = f", {PARTED}" if came_through and cell.get("parted") else ""
    return MARKS[cell["verdict"]] + parted


def _named(cells: list[dict[str, Any]], word: str) -> str:
    names = [short(cell["variant"]) for cell in cells if word in mark(cell)]
    return f"{word}: {'all' if len(names) == len(cells) > 1 else ', '.join(names)}" if names else ""


def _counts(cells: list[dict[str, Any]]) -> tuple[str, ...]:
    counts = Counter(cell["verdict"] for cell in cells)
    parted = sum(PARTED in mark(cell) for cell in cells)
    more = (f"{parted} of the stable with particles that have parted",) if parted else ()
    return (*(f"{counts[verdict]} {verdict}" for verdict in MARKS), *more)


def short(variant: str) -> str:
    """A variant's name that is narrow enough for a column: without what its table says, in words."""
    return re.sub("[:+]", " ", re.sub("-(ex|im)plicit", "", variant))


def without_laws(message: str) -> str:
    """A message without the list of laws behind a material's name."""
    return re.sub(r"\(material ([^:()]*): [^()]*\)", r"(\1)", message)


def report_of(cells: list[dict[str, Any]], quick: bool, limits: dict[str, float | None]) -> Report:
    """The matrix, why cells were refused or failed, the true limits of steps, and every number."""
    facts = (*_counts(cells), "a tenth of the steps" if quick else "all steps")
    lead = (
        "Hard cases by variants of both methods. Refused: by a typed error that says what to do; failed: a number that "
        "is none, an energy that is off by more than a tenth, a crash, a run that does not end, or a body that loses "
        "what its case says that it has to keep. Parted: neighbouring particles no longer share a node of the grid, "
        "which tears the body without any physics of fracture; its numbers stay good."
    )
    said = [cell for cell in cells if cell["verdict"] in (REFUSED, FAILED)]
    reasons = tuple(
        (f"{cell['case']}, {cell['variant']}", MARKS[cell["verdict"]], without_laws(cell["why"]))
        for cell in said
    )
    return Report(
        "Stability",
        lead,
        facts,
        (
            Section("matrix", "The matrix", _matrices(cells)),
            Section(
                "reasons", "What was said", (Table("Refused and failed", ("cell", "", "message"), reasons),)
            ),
            Section("cases", "The cases", (_cases(cells),)),
            Section("limits", "True limit of the step", (_limits(limits),) if limits else ()),
            Section("cells", "Every cell", (_numbers(cells),)),
        ),
    )


def _matrices(cells: list[dict[str, Any]]) -> tuple[Table, ...]:
    explicit = [cell for cell in cells if not is_implicit(cell["variant"])]
    implicit = [cell for cell in cells if is_implicit(cell["variant"])]
    parts = (("Cases by explicit variants", explicit), ("Cases by implicit variants", implicit))
    return tuple(_matrix(title, part) for title, part in parts if part)


def _matrix(title: str, cells: list[dict[str, Any]]) -> Table:
    variants = tuple(dict.fromkeys(cell["variant"] for cell in cells))
    marks = {(cell["case"], cell["variant"]): mark(cell) for cell in cells}
    names = dict.fromkeys(cell["case"] for cell in cells)
    rows = tuple((name, *(marks.get((name, variant)) for variant in variants)) for name in names)
    return Table(title, ("case", *(short(variant) for variant in variants)), rows)


def _cases(cells: list[dict[str, Any]]) -> Table:
    names = dict.fromkeys(cell["case"] for cell in cells)
    return Table("What they are", ("case", ""), tuple((name, find_case(name).title) for name in names))


def _limits(limits: dict[str, float | None]) -> Table:
    note = (
        f"Of an elastic bar that swings, by bisection to 2 %, {STEPS} steps each; {HIGHEST:g}: that or more. "
        "Usual steps are 0.9 (finite elements) and 0.5 (material points) of the estimate."
    )
    return Table("Largest stable step over the estimate", ("variant", "ratio"), tuple(limits.items()), note)


def _numbers(cells: list[dict[str, Any]]) -> Table:
    head = (
        "cell",
        "verdict",
        "steps",
        "t [s]",
        "energy off [%]",
        "smallest J",
        "largest J",
        "smallest step [s]",
        "redone",
        "pairs parted",
        "processor time [s]",
    )
    rows = tuple(
        (
            f"{cell['case']}, {cell['variant']}",
            cell["verdict"],
            cell["steps"],
            cell["time"],
            None if cell["drift"] is None else 100.0 * cell["drift"],
            cell["smallest_ratio"],
            cell.get("largest_ratio"),
            cell["smallest_step"],
            cell["redone"],
            cell.get("parted"),
            cell["seconds"],
        )
        for cell in cells
    )
    return Table("Numbers", head, rows)
