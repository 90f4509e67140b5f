"""The stability matrix: verdicts of made-up solvers and processes, and a fast part of it."""

import faulthandler
import itertools
import json
import math
import os
import time
from types import SimpleNamespace

import numpy as np
import pytest

from core_models.errors import RunFailure, SceneError
from core_models.points import PointFailure
from core_models.redo import redoing
from core_models.status import NOT_CONVERGED
from studies.command_line import main
from studies.stability.case import Case
from studies.stability.cases import all_cases, find_case
from studies.stability.cell import FAILED, REFUSED, RESCUED, STABLE, run_cell
from studies.stability.isolated import Task, results_of
from studies.stability.study import VARIANTS, pairs, survey_stability
from studies.stability.tables import mark, summary
from studies.stability.true_limit import true_limit


class Pretended:
    """A solver of ten steps of 1 s; `act` is what happens in the fifth."""

    def __init__(self, act=lambda solver: None):
        self.time, self.step_count, self.time_step, self.place, self._act = 0.0, 0, 1.0, 0.0, act
        self.ledger = SimpleNamespace(relative_error=1e-3)
        self.points = SimpleNamespace(volume_ratio=np.array([1.3, 0.7]))
        self.spin, self.numerical_fracture = -2.0, lambda: None

    def advance(self, limit):
        """One step."""
        self.step_count += 1
        self.time += self.time_step
        if self.step_count == 5:
            self._act(self)

    def point_positions(self):
        """One point."""
        return np.array([[self.place]])


def redo(solver):
    """A step that works the second time."""
    tried = []

    def attempt(dt):
        tried.append(dt)
        if len(tried) == 1:
            raise PointFailure(NOT_CONVERGED, 0)

    redoing(attempt, 1.0, 0.0, lambda: "", lambda reason: RunFailure(str(reason)))


def refuse(solver):
    """A typed error."""
    raise RunFailure("step 5: not finite")


def stumble(solver):
    """An error of the program."""
    raise ZeroDivisionError("division by zero")


def get_lost(solver):
    """A number that is none."""
    solver.place = math.nan


def explode(solver):
    """Energy from nowhere."""
    solver.ledger.relative_error = 7.0


@pytest.mark.parametrize(
    ("act", "verdict", "why"),
    [
        (lambda solver: None, STABLE, ""),
        (redo, RESCUED, ""),
        (refuse, REFUSED, "step 5"),
        (stumble, FAILED, "ZeroDivisionError"),
        (get_lost, FAILED, "energy"),
        (explode, FAILED, "700 %"),
    ],
)
def test_a_cell_is_judged_by_what_happened(act, verdict, why):
    """Typed errors are refusals; whatever else goes wrong is a failure; redone steps are counted."""
    cell = run_cell(Case("made", "", lambda variant: Pretended(act), 10.0), "mpm", False)
    assert cell.verdict == verdict and why in cell.why
    assert cell.redone == (act is redo)
    if verdict == STABLE:
        assert (cell.steps, cell.drift, cell.smallest_ratio, cell.smallest_step) == (10, 1e-3, 0.7, 1.0)
        assert cell.largest_ratio == 1.3


def slow_down(solver):
    """A quantity that is lost."""
    solver.spin *= 0.5


def come_apart(solver):
    """Two pairs of particles that part."""
    solver.numerical_fracture = lambda: SimpleNamespace(pairs=2)


@pytest.mark.parametrize(
    ("act", "why"), [(slow_down, "50 % of the spin is left"), (come_apart, "2 pairs of particles")]
)
def test_a_body_that_has_to_keep_something_fails_without_it(act, why):
    """Such a case ends at once where the quantity is lost or particles part, however good the energy is."""
    case = Case("made", "", lambda variant: Pretended(act), 10.0, keeps=("spin", lambda solver: solver.spin))
    cell = run_cell(case, "mpm", False)
    assert cell.verdict == FAILED and why in cell.why and cell.steps == 5
    free = run_cell(Case("made", "", lambda variant: Pretended(act), 10.0), "mpm", False)
    assert free.verdict == STABLE and free.parted == (2 if act is come_apart else 0)


def wrong():
    """Work that ends with an untyped error."""
    raise ValueError("no")


def crash():
    """A crash without the traceback that pytest would print of it."""
    faulthandler.disable()
    os.abort()


@pytest.mark.parametrize(
    ("work", "why"),
    [
        (lambda: time.sleep(60), "not at its end after 0.05 s"),
        (crash, "crashed with signal 6"),
        (wrong, "ended with status 1"),
        (lambda: np.ones(2**33).sum(), "ended with status 1"),
        (lambda: next(k for k in itertools.count() if k < 0), "not at its end after 1 s"),
    ],
)
def test_what_hangs_or_crashes_has_failed(work, why, capfd):
    """A process that sleeps, loops, dies, or wants too much memory costs its own cell."""
    (cell,) = results_of([Task("made", "mpm", work)], 0.05 if "0.05" in why else 1.0, 1)
    assert cell["verdict"] == FAILED and why in cell["why"]
    json.dumps(cell, allow_nan=False)


def test_cells_run_side_by_side(tmp_path):
    """As many at a time as there are workers; one that dies or is slow costs no other."""

    def meet(mine, other):
        (tmp_path / mine).touch()
        while not (tmp_path / other).exists():
            time.sleep(0.01)
        return {"met": mine}

    works = (crash, lambda: meet("a", "b"), lambda: meet("b", "a"), wrong)
    tasks = [Task(str(number), "mpm", work) for number, work in enumerate(works)]
    results = list(results_of(tasks, 1.0, 2))
    assert sorted(result["met"] for result in results if "met" in result) == ["a", "b"]
    assert {result["case"] for result in results if "met" not in result} == {"0", "3"}


def test_the_matrix_is_large_enough():
    """Eighteen cases or more by eight variants or more; names are unique and say what they are."""
    assert len(all_cases()) >= 18 and len(VARIANTS) >= 8
    assert all(case.title for case in all_cases().values())
    with pytest.raises(SceneError, match="did you mean 'spall'"):
        find_case("spal")


FAST = (
    ("soft", "fem-explicit", STABLE),
    ("soft", "mpm", STABLE),
    ("bouncing", "mpm", STABLE),
    ("step-1.05", "fem-explicit", REFUSED),
    ("step-1.05", "mpm", REFUSED),
    ("soft", "mpm:linear", FAILED),
    ("implicit-apart", "fem-implicit", RESCUED),
    ("implicit-soft", "fem-implicit", REFUSED),
)


@pytest.mark.parametrize(("case", "variant", "verdict"), FAST)
def test_a_fast_part_of_the_matrix(case, variant, verdict):
    """Cells that need no kernels of their own."""
    cell = run_cell(find_case(case), variant, True)
    assert cell.verdict == verdict, cell.why


def test_variants_in_space_are_unknown_here():
    """The cases are planar: a variant that none of them can have is bad input, not a refusal of the solver."""
    for name in ("mpm:hex8", "fem-explicit:tet4", "mpm:spatial"):
        with pytest.raises(SceneError, match="knows no"):
            pairs([find_case("soft")], (name,))


def test_cases_of_increments_are_for_implicit_variants():
    """Each case meets the variants that it suits; where there is none, one line says so."""
    cases = [find_case("soft"), find_case("implicit-soft")]
    found = pairs(cases, ("fem-explicit", "mpm-implicit"))
    assert found == [("soft", "fem-explicit"), ("implicit-soft", "mpm-implicit")]
    with pytest.raises(SceneError, match="take fem-implicit"):
        pairs(cases[1:], ("mpm",))


def test_the_true_limit_of_the_step_is_found():
    """An oscillator of the central difference method blows up beyond omega dt = 2, here 1.6 of the estimate.

    Its energy error is small beside what the energy has grown to, which does not pass for stable.
    """

    class Oscillator:
        def __init__(self, variant, safety):
            self.x, self.v, self.time_step, self.points = 1.0, 0.0, 0.0, None

        def advance(self):
            dt = 2.0 / 1.6 * self.time_step
            self.v -= dt * self.x
            self.x += dt * self.v
            self.time_step = 1.0

        @property
        def ledger(self):
            return SimpleNamespace(
                relative_error=0.0, kinetic=0.5 * self.v**2, strain=0.5 * self.x**2, initial=1e6
            )

        def point_positions(self):
            return np.array([self.x])

    assert true_limit("fem-explicit", Oscillator) == pytest.approx(1.6, rel=0.02)


def test_particles_that_have_parted_are_not_hidden_behind_stable():
    """Matrix, terminal and counts say so of cells that came to their end, and of no others."""
    cells = [
        {"case": "soft", "variant": variant, "verdict": verdict, "parted": parted}
        for variant, verdict, parted in (
            ("mpm", STABLE, 2), ("mpm:flip", RESCUED, 1), ("mpm:total", STABLE, 0), ("mpm:cubic", REFUSED, 3)
        )
    ]  # fmt: skip
    assert [mark(cell) for cell in cells] == ["stable, parted", "redone, parted", "stable", "refused"]
    said = summary(cells)
    assert "3 of 4 stable; parted: mpm, mpm flip; refused: mpm cubic" in said
    assert "2 of the stable with particles that have parted" in said


def test_the_study_leaves_the_matrix_with_reasons(tmp_path, capsys):
    """Cells in the order of cases and variants; refusals keep their message; unknown names are one line."""

    def made(cells, quick, workers):
        for case, variant in reversed(cells):
            yield {
                "case": case, "variant": variant, "verdict": REFUSED if variant == "mpm" else STABLE,
                "why": "too soft" if variant == "mpm" else "", "steps": 1, "time": 1.0, "drift": None,
                "smallest_ratio": 1.0, "smallest_step": None, "redone": 0, "seconds": 1.0,
            }  # fmt: skip

    outcome = survey_stability(
        tmp_path / "out", quick=True, cases=("soft", "spall"), variants=("fem-explicit", "mpm"), run=made
    )
    assert len(outcome.cells) == 4 and outcome.failed == 0
    again = survey_stability(
        tmp_path / "out", quick=True, cases=("soft", "spall"), variants=("fem-explicit", "mpm"), going_on=True
    )
    assert again.cells == outcome.cells
    assert "soft,stable,refused" in (tmp_path / "out/matrix.csv").read_text()
    assert "soft                      1 of 2 stable; refused: mpm" in summary(outcome.cells)
    assert "too soft" in (tmp_path / "out/reasons.csv").read_text()
    assert main(["study", "stability", "--cases", "spal", "--out", str(tmp_path / "b")]) == 2
    assert "spall" in capsys.readouterr().err
