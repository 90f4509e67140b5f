"""Necking runs and studies that were stopped: what is kept of them, and going on."""

import json
from dataclasses import replace

import numpy as np
import pytest

import fem
from core_models.equilibrium.stepping import QuasiStatic
from core_models.errors import NoEquilibrium, OutputError
from studies.command_line import main
from studies.necking.course import Course
from studies.necking.kept_state import KeptState
from studies.necking.methods import make_run
from studies.necking.record import perform_run
from studies.necking.scene import PlannedRun
from studies.necking.study import study_necking
from studies.sweep.job import FAILED, perform
from tests.studies.necking_samples import SIMO, small


class Killed(BaseException):
    """Ends a run at once, like a kill or Ctrl-C."""


def stop_at(monkeypatch, row, reason):
    """Let every run be ended by `reason` instead of taking its row of this number, once."""
    take, left = Course.row, [row]

    def stopping(self, force):
        left[0] -= 1
        if left[0] == 0:
            raise reason
        take(self, force)

    monkeypatch.setattr(Course, "row", stopping)


def in_this_process(jobs, folder, workers, tell):
    """Results of jobs, without processes of their own."""
    results = [perform(job) for job in jobs]
    for result in results:
        tell(result, 1, 1)
    return results


@pytest.mark.parametrize(
    "plan",
    [
        PlannedRun("implicit", "fem-implicit", 2, 6, 0.5, increments=6),
        PlannedRun("explicit", "fem-explicit", 2, 6, 0.5, periods=20.0),
    ],
)
@pytest.mark.parametrize("reason", [Killed(), NoEquilibrium("no equilibrium")])
def test_a_run_goes_on_from_the_state_that_was_kept(plan, reason, tmp_path, monkeypatch):
    """After a kill and after a typed failure: its history, shape and counts are bitwise those of one left alone."""
    scene, state = replace(SIMO, pull=1e-3), KeptState(tmp_path / "state.npz")
    whole = make_run(scene, plan)
    with monkeypatch.context() as patch:
        stop_at(patch, 4, reason)
        if isinstance(reason, Killed):
            with pytest.raises(Killed):
                make_run(scene, plan, state)
        else:
            assert make_run(scene, plan, state).history.rows == whole.history.rows[:3]
    assert int(state.read()["solver.step_count"]) < whole.steps
    again = make_run(scene, plan, state)
    assert again.history.rows == whole.history.rows and again.steps == whole.steps
    assert (again.shape == whole.shape).all() and again.kinetic_share == whole.kinetic_share


def test_states_of_other_sources_and_damaged_ones_are_not_gone_on_from(tmp_path, monkeypatch):
    """The run then begins anew."""
    state = KeptState(tmp_path / "state.npz")
    assert state.read() is None
    state.write({"x": np.ones(2)})
    assert (state.read()["x"] == 1.0).all()
    whole = state.path.read_bytes()
    state.path.write_bytes(whole[: len(whole) // 2])
    assert state.read() is None
    state.path.write_bytes(whole)
    monkeypatch.setattr("studies.necking.kept_state.source_hash", lambda: "other")
    assert state.read() is None


def test_a_study_is_kept_and_gone_on_with(tmp_path):
    """Runs that a folder holds are not made again; another scene's folder is refused; the report is whole."""
    scene, out = tmp_path / "small.xml", tmp_path / "out"
    scene.write_text(small("small"), encoding="utf-8")
    told = []
    outcome = study_necking(scene, out, workers=1, tell=lambda *each: told.append(each))
    assert len(told) == 1 and not outcome.criteria[0].met
    kept = json.loads((out / "runs" / "one.json").read_text())
    assert len(kept["rows"]) >= 3 and len(kept["strains"]) == 32
    study_necking(scene, out, going_on=True, workers=1, tell=lambda *each: told.append(each))
    assert len(told) == 1
    assert "peak force, one, 2 × 4" in (out / "report.html").read_text(encoding="utf-8")
    scene.write_text(small("other"), encoding="utf-8")
    with pytest.raises(OutputError, match="scene = small, not other"):
        study_necking(scene, out, going_on=True)
    scene.write_text(small("small").replace('length="26.667e-3"', 'length="25e-3"'), encoding="utf-8")
    with pytest.raises(OutputError, match="started with fingerprint"):
        study_necking(scene, out, going_on=True)


def test_a_run_that_stops_keeps_its_curves_and_goes_on(tmp_path, monkeypatch, capsys):
    """Exit status 3, the reason and what to try; rows up to there prove nothing; with other increments it goes on."""

    def advance(self, limit):
        if self.step_count == 2 and self.time_step > 0.2:
            raise NoEquilibrium("increment 3: no equilibrium")
        QuasiStatic.advance(self, limit)

    monkeypatch.setattr(fem.ImplicitSolver, "advance", advance, raising=False)
    monkeypatch.setattr("studies.necking.study.run_sweep", in_this_process)
    scene, out = tmp_path / "small.xml", tmp_path / "out"
    scene.write_text(small("small"), encoding="utf-8")
    assert main(["study", "necking", str(scene), "--out", str(out)]) == 3
    told = capsys.readouterr().out
    assert "increment 3: no equilibrium. The state at 4.667 mm is kept: --resume goes on" in told
    (criterion,) = json.loads((out / "results.json").read_text(encoding="utf-8"))["criteria"]
    assert criterion["what"] == "one runs to the end"
    assert "one (stopped)" in (out / "report.html").read_text(encoding="utf-8")
    record = perform_run(scene, "one")
    assert (record["status"], record["exit_status"], len(record["rows"])) == (FAILED, 3, 2)
    scene.write_text(small("small").replace('increments="3"', 'increments="6"'), encoding="utf-8")
    assert main(["study", "necking", str(scene), "--resume", str(out)]) == 1
    assert (out / "runs").is_dir() and not list((out / "runs").glob("*.npz"))
    assert "force at end" in (out / "report.html").read_text(encoding="utf-8")


def test_a_finished_run_is_made_again_for_other_increments(tmp_path, monkeypatch):
    """What is kept of the study is of the increments that the scene asks for; nothing else is made again."""
    scene, out = tmp_path / "small.xml", tmp_path / "out"
    scene.write_text(small("small"), encoding="utf-8")
    told = []
    monkeypatch.setattr("studies.sweep.sweep._results", lambda jobs, *_: map(perform, jobs))
    monkeypatch.setattr("studies.necking.study.write_report", lambda report, folder: "")
    for increments, made in (("3", 1), ("3", 1), ("4", 2)):
        text = small("small").replace('increments="3"', f'increments="{increments}"')
        scene.write_text(text, encoding="utf-8")
        study_necking(scene, out, going_on=out.exists(), tell=lambda *each: told.append(each))
        assert len(told) == made
        assert json.loads((out / "runs" / "one.json").read_text())["asked"] == [int(increments), None]
