"""Runs that are killed and go on: what they leave is bitwise what an undisturbed run leaves."""

import errno
import fcntl
import os
import subprocess
import sys

import numpy as np
import pytest

from core_models.errors import DiskFull, OutputError, SceneError
from studies.checkpointing.checkpoint_file import FILE, read_checkpoint
from studies.checkpointing.interval import Interval, interval_text, read_interval
from studies.checkpointing.resuming import resume
from studies.command_line import main
from studies.output.output_folder import LOCK
from studies.runs.running import run
from tests.studies.killing import killed_run, results

SOON = Interval(steps=25)


class Killed(BaseException):
    """Ends a run like a kill: nothing is written any more."""


def stop_after(monkeypatch, steps):
    """Let every run end after so many steps as if killed."""
    from studies.observers.contact_watch import ContactWatch

    look, left = ContactWatch.step, [steps]

    def step(self, solver):
        left[0] -= 1
        if left[0] < 0:
            raise Killed
        look(self, solver)

    monkeypatch.setattr(ContactWatch, "step", step)
    monkeypatch.setattr("studies.runs.running._abandon", lambda observers: None)


@pytest.fixture
def stopped(classic, tmp_path, monkeypatch):
    """Folder of a run that was killed some steps after a checkpoint."""
    with monkeypatch.context() as patch:
        stop_after(patch, 60)
        with pytest.raises(Killed):
            run(classic, "fem-explicit", 4, wall="plane", out=tmp_path / "out", interval=SOON)
    return tmp_path / "out"


@pytest.fixture
def undisturbed(classic, tmp_path):
    """What the same run leaves when it is left alone."""
    run(classic, "fem-explicit", 4, wall="plane", out=tmp_path / "undisturbed", interval=SOON)
    return results(tmp_path / "undisturbed")


def test_a_killed_run_goes_on_from_its_last_checkpoint(stopped, undisturbed):
    """It makes only the steps since then again; all files are bitwise the same, no checkpoint is left."""
    assert int(read_checkpoint(stopped).solver["step_count"]) == 50
    result = resume(stopped)
    assert result.resumed == 1 and FILE not in undisturbed
    assert results(stopped) == undisturbed


def test_killed_processes_leave_what_an_undisturbed_one_does(classic, tmp_path):
    """Two kills of real processes at random moments, in MPM, which also keeps its grid's box."""
    run(classic, "mpm", 6, wall="plane", out=tmp_path / "undisturbed")
    assert killed_run("mpm", tmp_path / "out", kills=2, seed=1) >= 1
    assert results(tmp_path / "out") == results(tmp_path / "undisturbed")


def test_a_run_that_goes_on_elsewhere_is_refused(stopped):
    """While a live process has the folder, a second one does not touch it; a killed one's lock does not count."""
    before = (stopped / FILE).read_bytes()
    with open(stopped / LOCK, "a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        command = [sys.executable, "-m", "studies", "run", "--resume", str(stopped)]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        assert ended.returncode == 2 and "another run is writing to it" in ended.stderr
        assert "wait for it" in ended.stderr and "--out" not in ended.stderr
    assert (stopped / FILE).read_bytes() == before
    assert resume(stopped).status == "complete"


def test_a_full_disk_leaves_a_checkpoint_to_go_on_from(classic, tmp_path, monkeypatch, undisturbed):
    """The run ends with what to do; the checkpoint before is whole, and with space again the run goes on."""
    save, written = np.savez, []

    def full(file, **arrays):
        written.append(1)
        if len(written) == 3:
            file.write(b"half a checkpoint")
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        save(file, **arrays)

    monkeypatch.setattr("numpy.savez", full)
    with pytest.raises(DiskFull, match="free space"):
        run(classic, "fem-explicit", 4, wall="plane", out=tmp_path / "out", interval=SOON)
    assert int(read_checkpoint(tmp_path / "out").solver["step_count"]) == 25
    resume(tmp_path / "out")
    assert results(tmp_path / "out") == undisturbed


def test_a_disk_that_is_full_from_the_start_leaves_nothing_to_go_on_from(classic, tmp_path, monkeypatch):
    """Without a checkpoint the message says what went wrong, without its remedy, and to start anew."""

    def full(file, **arrays):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("numpy.savez", full)
    with pytest.raises(DiskFull):
        run(classic, "fem-explicit", 4, wall="plane", out=tmp_path / "out", interval=SOON)
    with pytest.raises(
        OutputError, match="before its first checkpoint: .*No space left.*start it anew"
    ) as told:
        resume(tmp_path / "out")
    assert "free space" not in str(told.value)
    (tmp_path / "out/run.json").write_text("{")
    with pytest.raises(OutputError, match=r"run\.json: cannot be read .*start it anew"):
        resume(tmp_path / "out")


def test_what_cannot_be_resumed_is_refused_by_what_it_is(stopped, tmp_path, monkeypatch, capsys):
    """No folder, no checkpoint, a damaged one, other code, a run that has ended; options that do not apply."""
    for folder, told in ((tmp_path / "none", "no such folder"), (tmp_path, "holds no checkpoint")):
        with pytest.raises(OutputError, match=told):
            resume(folder)
    whole = (stopped / FILE).read_bytes()
    for damaged in (whole[: len(whole) // 2], b"", b"no archive of numbers"):
        (stopped / FILE).write_bytes(damaged)
        with pytest.raises(OutputError, match="damaged") as told:
            resume(stopped)
        assert "allow_pickle" not in str(told.value)
    (stopped / FILE).write_bytes(whole)
    with monkeypatch.context() as patch:
        patch.setattr("studies.checkpointing.checkpoint_file.source_hash", lambda: "other")
        with pytest.raises(OutputError, match="another version"):
            resume(stopped)
    assert main(["run", "taylor-classic", "--resume", str(stopped)]) == 2
    assert "as it was started" in capsys.readouterr().err
    assert main(["run", "--resume", str(stopped)]) == 0
    with pytest.raises(OutputError, match="has ended"):
        resume(stopped)


def test_temporary_files_of_a_killed_process_are_removed(stopped):
    """What was half written at the kill does not stay."""
    (stopped / ".history.csv.1.part").write_text("half")
    resume(stopped)
    assert not list(stopped.rglob(".*.part"))


@pytest.mark.parametrize(
    ("text", "interval"),
    [
        ("60s", Interval(60.0)),
        ("10min", Interval(600.0)),
        ("2h", Interval(7200.0)),
        ("5steps", Interval(steps=5)),
    ],
)
def test_intervals_are_read_and_written(text, interval):
    """Every unit; what is written reads back the same."""
    assert read_interval(text) == interval == read_interval(interval_text(interval))


@pytest.mark.parametrize("text", ["60", "0s", "-1s", "1.5h", "soon"])
def test_intervals_that_are_none_are_refused(text):
    """With how to write one."""
    with pytest.raises(SceneError, match="60s"):
        read_interval(text)
