"""Runs: their folder, their end, and what happens when they go wrong."""

import csv
import json
import shutil
from dataclasses import replace

import pytest

from core_models.errors import DiskFull, OutputError, RunFailure, SceneError
from studies.runs.running import run
from studies.scenes.scene import End


def files(folder):
    """Names of all files below a folder."""
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def test_a_run_leaves_the_documented_folder(fake_solvers, classic, tmp_path):
    """scene.xml, history.csv, frames with series.pvd, run.json, and nothing temporary."""
    run(classic, "mpm", 8, out=tmp_path / "out")
    names = files(tmp_path / "out")
    frames = [name for name in names if name.startswith("frames/")]
    assert len(frames) == 21
    assert [name for name in names if name not in frames] == [
        "history.csv",
        "run.json",
        "scene.xml",
        "series.pvd",
        "taylor-classic-history.csv",
    ]


def test_run_json_is_complete_strict_json(fake_solvers, classic, tmp_path):
    """The record holds method, quantities, cost, conservation, effects and versions."""
    run(classic, "mpm", 8, out=tmp_path / "out", threads=2)
    record = json.loads((tmp_path / "out/run.json").read_text(), parse_constant=pytest.fail)
    assert (record["status"], record["method"], record["resolution"], record["threads"]) == (
        "complete",
        "mpm",
        8,
        2,
    )
    assert set(record["conservation"]) == {"mass", "momentum", "energy"}
    costs = {"wall_s", "cpu_s", "compile_s", "steps", "point_updates", "peak_memory_bytes"}
    assert costs <= set(record["cost"])
    assert record["cost"]["point_updates"] == 2 * record["cost"]["steps"]
    assert all(effect["reason"] for effect in record["effects"])
    assert {True, False} == {effect["on"] for effect in record["effects"]}


def test_history_is_sampled_from_start_to_end(fake_solvers, classic, tmp_path):
    """The first row is t = 0, the last the end; the energies add up to the total."""
    run(classic, "mpm", 8, out=tmp_path / "out")
    rows = list(csv.DictReader((tmp_path / "out/history.csv").open()))
    assert float(rows[0]["t"]) == 0.0
    assert float(rows[-1]["t"]) == 80e-6
    parts = ("kinetic", "strain", "plastic", "viscosity", "transfer", "contact")
    for row in rows:
        assert float(row["total"]) == pytest.approx(sum(float(row[part]) for part in parts), rel=1e-6)


def test_a_scene_that_ends_with_release_ends_one_axial_period_after_it(fake_solvers, classic):
    """The length is the mean over the last period, with its amplitude; a plane wall ends at its own time."""
    scene = replace(classic, end=End(latest=150e-6, plane=90e-6))
    released = run(scene, "mpm", 8)
    ended = released.history.column("t")[-1]
    assert ended == pytest.approx(60e-6 + scene.axial_period, rel=1e-9)
    assert "axial period after" in released.ended
    assert released.quantities["final_length"].more["amplitude"] >= 0.0
    assert run(scene, "mpm", 8, wall="plane").history.column("t")[-1] == 90e-6


def test_a_folder_in_use_is_refused_before_anything_is_built(classic, tmp_path, monkeypatch):
    """No solver is built and nothing is written for a folder that holds something."""
    monkeypatch.setattr("studies.runs.running.build_solver", pytest.fail)
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(OutputError):
        run(classic, "mpm", 8, out=tmp_path)
    assert files(tmp_path) == ["mine.txt"]


@pytest.mark.parametrize(
    ("method", "resolution", "wall", "told"),
    [
        ("mpn", 8, None, "mpm"),
        ("mpm", 1, None, "cell"),
        ("mpm", "4", None, "whole number"),
        ("mpm", 100_000, None, "GiB of memory; give 314 or less"),
        ("mpm", 8, "plan", "plane"),
    ],
)
def test_bad_options_leave_nothing_behind(classic, tmp_path, method, resolution, wall, told):
    """Unknown methods and walls and empty resolutions are refused by name, without a folder."""
    with pytest.raises(SceneError, match=told):
        run(classic, method, resolution, wall=wall, out=tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_run_that_goes_wrong_keeps_what_it_had(fake_solvers, classic, tmp_path):
    """The failure is raised; history, frames and a run.json with status failed and the message stay."""
    with pytest.raises(RunFailure, match="point 1"):
        run(classic, "mpm", 13, out=tmp_path / "out")
    record = json.loads((tmp_path / "out/run.json").read_text())
    assert record["status"] == "failed"
    assert "point 1" in record["message"]
    assert record["quantities"] == {}
    rows = (tmp_path / "out/history.csv").read_text().splitlines()
    assert len(rows) > 20
    assert "frames/frame-0000.vtu" in files(tmp_path / "out")


def test_an_interrupted_run_has_no_run_json(fake_solvers, classic, tmp_path, monkeypatch):
    """Ctrl-C keeps the history; without run.json the run is not complete."""

    def interrupt(self, solver):
        if solver.step_count == 50:
            raise KeyboardInterrupt

    monkeypatch.setattr("studies.observers.contact_watch.ContactWatch.step", interrupt)
    with pytest.raises(KeyboardInterrupt):
        run(classic, "mpm", 8, out=tmp_path / "out")
    assert "run.json" not in files(tmp_path / "out")
    assert len((tmp_path / "out/history.csv").read_text().splitlines()) > 40


def test_a_run_ends_exactly_at_its_end_time(fake_solvers, classic):
    """The last step is cut, so that both methods are measured at the same time."""
    scene = replace(classic, end=End(time=10.37e-6))
    assert run(scene, "mpm", 8).history.column("t")[-1] == 10.37e-6


def test_a_folder_removed_during_the_run_is_an_error(fake_solvers, classic, tmp_path, monkeypatch):
    """It is not made again, and the run does not claim success."""

    def remove(self, solver):
        if solver.step_count == 50:
            shutil.rmtree(tmp_path / "out")

    monkeypatch.setattr("studies.observers.contact_watch.ContactWatch.step", remove)
    with pytest.raises(OutputError, match="was removed"):
        run(classic, "mpm", 8, out=tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_full_disk_ends_the_run_like_a_failure(fake_solvers, classic, tmp_path, full_disk):
    """Status 3 and a remedy; what had been written stays."""
    with pytest.raises(DiskFull, match="free space or choose another --out") as failure:
        run(classic, "mpm", 8, out=tmp_path / "out")
    assert failure.value.exit_status == 3
    assert "scene.xml" in files(tmp_path / "out") and "run.json" in files(tmp_path / "out")
