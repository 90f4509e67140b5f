"""The experiments: the shots as data, their runs, and a sweep that is stopped, goes on and loses workers."""

import json
import logging
import multiprocessing
import os
import signal
import time

import pytest

from core_models.cards import shipped_materials
from core_models.errors import OutputError, RunFailure, SceneError, UnsupportedError
from studies.command_line import main
from studies.commands.studies.experiments import _tell
from studies.experiments.predictions import CARDS, predict, scene_of
from studies.experiments.shots import read_shots
from studies.experiments.study import compare_experiments
from studies.observers.fracture_watch import fracture_text
from studies.output.output_folder import OutputFolder
from studies.process import Terminated
from studies.sweep.job import Job, perform
from studies.sweep.processes import results_by_processes
from studies.sweep.sweep import run_sweep


def double(value, folder=""):
    """A job that works; in a folder it leaves a trace of each time that it is done."""
    if folder:
        with open(os.path.join(folder, "trace"), "a") as trace:
            trace.write(f"{value}\n")
    return {"value": 2 * value}


def go_wrong():
    """A job that fails as runs do."""
    raise RunFailure("step 3: not finite")


def die():
    """A job that takes its process with it."""
    os.kill(os.getpid(), signal.SIGKILL)


def take_long():
    """A job that nobody wants to wait for."""
    time.sleep(60.0)
    return {}


def die_once(folder):
    """A job that takes its process with it the first time."""
    mark = os.path.join(folder, "died")
    if not os.path.exists(mark):
        open(mark, "w").close()
        die()
    return {"value": 1}


def test_there_are_85_shots_with_what_was_measured():
    """All of the source: metals, sizes, ten profiles that end at the measured length; SI."""
    shots = read_shots()
    assert len(shots) == len({shot.name for shot in shots}) == 85
    assert {shot.material for shot in shots} == set(CARDS)
    assert sum(shot.profile is not None for shot in shots) == 10
    for shot in shots:
        assert 0.2 < shot.measured["final_length"] / shot.length < 1.0 and 40.0 < shot.velocity < 700.0
    zerilli = next(shot for shot in shots if shot.name == "cu-zerilli-03")
    assert (zerilli.velocity, zerilli.length, zerilli.diameter) == (190.0, 25.4e-3, 7.62e-3)
    assert zerilli.measured["foot_diameter"] == 13.564e-3 and zerilli.profile[:, 0].max() == pytest.approx(
        6.8e-3, rel=0.01
    )


def test_every_shot_has_a_scene_for_each_card():
    """The cards ship, and the bar has time to shorten as measured."""
    assert {card for cards in CARDS.values() for card in cards} <= set(shipped_materials())
    for shot in read_shots():
        scene = scene_of(shot, CARDS[shot.material][0])
        shortening = shot.length - shot.measured["final_length"]
        assert scene.end.limit("unilateral") > 2.0 * shortening / shot.velocity
        assert scene.end.after_release("unilateral")


def test_a_prediction_stands_next_to_what_was_measured():
    """Copper at 190 m/s with Johnson and Cook's own constants: length within a tenth even this coarsely."""
    row = predict("cu-zerilli-03", "copper_ofhc_johnson_cook", "fem-explicit", 3, 60.0)
    assert abs(row["errors"]["final_length"]) < 0.1
    assert row["errors"]["final_length"] == pytest.approx(row["predicted"]["final_length"] / 16.205e-3 - 1.0)
    assert 0.0 < row["profile_distance"] < 1e-3
    json.dumps(row, allow_nan=False)


def test_a_run_that_takes_too_long_has_failed():
    """It says how far it came."""
    with pytest.raises(RunFailure, match="not at its end after"):
        predict("cu-zerilli-03", "copper_ofhc_johnson_cook", "fem-explicit", 3, 0.05)


def test_the_study_goes_on_where_it_was_stopped(tmp_path, monkeypatch):
    """A job that fails is a row of its own; done ones are kept, failed ones tried again; another study is refused."""
    monkeypatch.setattr("studies.sweep.sweep.is_installed", lambda: False)
    monkeypatch.setattr(
        "studies.sweep.sweep.results_by_processes",
        lambda jobs, workers: (here(job) for job in jobs),
    )
    asked = []

    def here(job):
        asked.append(job.key)
        return {"key": job.key, "status": "failed", "message": "lost"} if len(asked) == 2 else made(job)

    def one_material(job):
        return job.key.startswith("st-johnson")

    first = compare_experiments(tmp_path / "out", quick=True, only=one_material)
    assert len(asked) == 6 and first.failed == 1 and "lost" in (tmp_path / "out/failures.csv").read_text()
    again = compare_experiments(tmp_path / "out", quick=True, going_on=True, only=one_material)
    assert len(asked) == 7 and asked[6] == asked[1] and again.failed == 0
    table = (tmp_path / "out/medians.csv").read_text()
    assert '"steel 4340, steel_4340_johnson_cook, mpm",3,0,1.0' in table
    assert '"steel 4340, up to 400 K, 200 to 300 m/s, mpm",2,1.0' in (tmp_path / "out/bands.csv").read_text()
    assert "Taylor impact experiments" in (tmp_path / "out/report.html").read_text()
    with pytest.raises(OutputError, match="quick = True, not False"):
        compare_experiments(tmp_path / "out", going_on=True)


def test_a_study_of_one_method_is_told_too(tmp_path, monkeypatch, capsys):
    """Where every run of the other method has gone wrong, table and report are there all the same."""
    monkeypatch.setattr("studies.sweep.sweep.is_installed", lambda: False)
    monkeypatch.setattr(
        "studies.sweep.sweep.results_by_processes", lambda jobs, workers: (only_mpm(job) for job in jobs)
    )

    def only_mpm(job):
        return made(job) if "mpm" in job.key else {"key": job.key, "status": "failed", "message": "lost"}

    assert main(["study", "experiments", "--quick", "--out", str(tmp_path / "out")]) == 3
    assert "steel 4340, steel_4340_johnson_cook, mpm" in capsys.readouterr().out


def made(job):
    """A result like that of `predict`: every value a hundredth too large."""
    shot, card, method, resolution, _ = job.arguments
    asked = next(each for each in read_shots() if each.name == shot)
    return {
        "key": job.key, "status": "complete", "message": "", "shot": shot, "material": asked.material, "card": card,
        "temperature": asked.temperature, "velocity": asked.velocity, "method": method, "resolution": resolution,
        "ended": "", "points": 1, "steps": 1, "seconds": 1.0, "measured": asked.measured,
        "predicted": {name: 1.01 * value for name, value in asked.measured.items()},
        "errors": dict.fromkeys(asked.measured, 0.01), "profile_distance": None,
    }  # fmt: skip


def test_processes_that_die_cost_their_own_job():
    """The jobs beside it come out, a failed one says why."""
    jobs = [Job("two", double, (1,)), Job("wrong", go_wrong), Job("dies", die)]
    results = {result["key"]: result for result in results_by_processes(jobs, 2)}
    assert results["two"]["value"] == 2
    assert results["wrong"]["message"] == "step 3: not finite"
    assert results["dies"]["status"] == "failed" and "died" in results["dies"]["message"]


def remark_twice():
    """Work that warns twice of the same."""
    for name in ("core_models.cards.reader", "core_models.cards.reader", "distributed.worker"):
        logging.getLogger(name).warning("%s: %s", "card.xml", "odd")
    return {"value": 1}


def test_a_job_keeps_its_remarks(capfd):
    """They come with the result, each once, instead of on the worker's terminal; a worker's own do not."""
    assert perform(Job("odd", remark_twice))["remarks"] == ["card.xml: odd"]
    assert "card.xml" not in capfd.readouterr().err
    assert perform(Job("two", double, (1,)))["remarks"] == perform(Job("wrong", go_wrong))["remarks"] == []


def test_the_command_passes_remarks_on(capfd, caplog):
    """As warnings, which a command tells once each; numerical fracture stands in the line of the run."""
    parted = {"time": 2e-5, "pairs": 3, "position": [0.0, 1e-3], "stretch": 3.0}
    result = {"key": "shot", "status": "complete", "remarks": ["card.xml: odd", fracture_text(parted)]}
    _tell(result | {"numerical_fracture": parted}, 1, 2, 1.0)
    _tell(result | {"remarks": []}, 2, 2, 2.0)
    assert caplog.messages == ["card.xml: odd"]
    first, second = capfd.readouterr().err.splitlines()
    assert first.endswith("shot complete: numerical fracture from t = 2.0000e-05 s on")
    assert second == "[2/2, 0:00 left] shot complete"


def test_a_dask_sweep_that_loses_a_worker_gives_the_same(tmp_path):
    """One of two workers is killed by force in the middle of a job; done jobs are not done again."""
    pytest.importorskip("distributed")
    jobs = [Job(str(k), double, (k, str(tmp_path))) for k in range(8)] + [
        Job("once", die_once, (str(tmp_path),))
    ]
    with OutputFolder(tmp_path / "out") as folder:
        results = run_sweep(jobs, folder, workers=2)
        assert [result.get("value") for result in results] == [*range(0, 16, 2), 1]
        traces = (tmp_path / "trace").read_text()
        assert run_sweep(jobs, folder, workers=2) == results
    assert (tmp_path / "trace").read_text() == traces


def test_an_interruption_ends_the_processes():
    """What is running is not waited for: SIGTERM to the command alone would take as long as its longest run."""
    before = set(multiprocessing.active_children())
    results = results_by_processes([Job("a", double, (1,)), Job("b", take_long)], 2)
    assert next(results)["value"] == 2
    began = time.monotonic()
    with pytest.raises(Terminated):
        results.throw(Terminated())
    assert time.monotonic() - began < 30.0
    assert set(multiprocessing.active_children()) <= before


def test_a_scheduler_that_is_not_there_is_one_line(tmp_path, capsys, monkeypatch, caplog):
    """Without Dask it says what to install, with Dask how to start one; that it waits is told beforehand."""
    with OutputFolder(tmp_path / "out") as folder, monkeypatch.context() as patch:
        patch.setattr("studies.sweep.sweep.is_installed", lambda: False)
        with pytest.raises(UnsupportedError, match="matpoint.sweep"):
            run_sweep([Job("a", double, (1,))], folder, scheduler="tcp://127.0.0.1:9")
    pytest.importorskip("distributed")
    monkeypatch.setattr("studies.sweep.dask_cluster.CONNECT_TIMEOUT", 0.5)
    with OutputFolder(tmp_path / "out") as folder, pytest.raises(SceneError, match="dask scheduler"):
        run_sweep([Job("a", double, (1,))], folder, scheduler="tcp://127.0.0.1:9")
    assert "waiting up to 0.5 s" in caplog.messages[0]


def test_a_scheduler_has_workers_of_its_own(capsys):
    """How many processes of this machine says nothing about those of a cluster."""
    assert main(["study", "experiments", "--scheduler", "tcp://127.0.0.1:9", "--workers", "3"]) == 2
    assert "not allowed with" in capsys.readouterr().err


def test_a_scheduler_that_cannot_be_used_leaves_no_folder(tmp_path, capsys):
    """Status 2, with or without Dask."""
    out = tmp_path / "out"
    arguments = ["study", "experiments", "--quick", "--scheduler", "nowhere", "--out", str(out)]
    assert main(arguments) == 2
    assert "--scheduler" in capsys.readouterr().err and not out.exists()


def test_a_study_to_resume_has_to_be_one(tmp_path, capsys):
    """An empty folder is no study; out and resume exclude each other."""
    assert main(["study", "experiments", "--resume", str(tmp_path)]) == 2
    assert "no experiments study" in capsys.readouterr().err
    assert main(["study", "experiments", "--resume", "a", "--out", "b"]) == 2
    assert "not allowed with" in capsys.readouterr().err
