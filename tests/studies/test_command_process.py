"""The command as a process: interruptions, and output that cannot be written."""

import errno
import logging
import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest

from studies.command_line import main
from studies.output.told_once import ToldOnce
from studies.process import Terminated, interruptible
from studies.runs.costs import measured


def said(capsys):
    """What was printed, and the error line."""
    captured = capsys.readouterr()
    return captured.out, captured.err


def test_ctrl_c_is_clean(capsys, monkeypatch):
    """An interrupt ends with status 130 and one line."""

    def interrupt(options):
        raise KeyboardInterrupt

    monkeypatch.setattr("studies.commands.scenes.execute", interrupt)
    assert main(["scenes"]) == 130
    assert said(capsys)[1].count("\n") == 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
@pytest.mark.parametrize("asked", ["scenes", "--help"])
def test_a_full_disk_behind_the_output_is_one_line_and_status_3(asked):
    """No traceback, and the status of a full disk anywhere."""
    with open("/dev/full", "w") as full:
        command = [sys.executable, "-m", "studies", asked]
        ended = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert ended.returncode == 3
    assert ended.stderr.startswith("matpoint: ") and ended.stderr.count("\n") == 1


def test_output_that_cannot_be_written_for_another_reason_has_status_2(capsys, monkeypatch):
    """Only a full disk has status 3."""

    def refuse(options):
        raise OSError(errno.EIO, os.strerror(errno.EIO))

    monkeypatch.setattr("studies.command_line.discard_output", lambda: None)
    monkeypatch.setattr("studies.commands.scenes.execute", refuse)
    assert main(["scenes"]) == 2
    assert said(capsys)[1].count("\n") == 1


def test_output_that_cannot_show_a_sign_shows_another():
    """A terminal without µ is no traceback."""
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    command = [sys.executable, "-m", "studies", "scenes"]
    ended = subprocess.run(command, env=environment, capture_output=True, check=False)
    assert ended.returncode == 0 and b"80 ?s" in ended.stdout


@pytest.mark.parametrize("code", ["raise SystemExit(5)", "raise ValueError('two\\nlines')"])
def test_a_law_file_that_fails_is_one_line(code, capsys, tmp_path):
    """Whatever a law file does at import becomes one line with its name."""
    (tmp_path / "laws.py").write_text(code)
    assert main(["check", "taylor-classic", "--laws", str(tmp_path / "laws.py")]) == 2
    _, err = said(capsys)
    assert err.count("\n") == 1 and "laws.py" in err


def test_a_warning_is_told_once(capfd):
    """However many runs make it."""
    logger = logging.getLogger("core_models.conduction")
    told = ToldOnce()
    logger.addHandler(told)
    for conductivity in (1.0, 1.0, 2.0):
        logger.warning("a conductivity of %g", conductivity)
    logger.removeHandler(told)
    assert capfd.readouterr().err.splitlines() == ["a conductivity of 1", "a conductivity of 2"]


def test_being_terminated_is_like_ctrl_c(capsys, monkeypatch):
    """SIGTERM ends the command cleanly with status 143."""
    monkeypatch.setattr(
        "studies.commands.scenes.execute", lambda options: signal.raise_signal(signal.SIGTERM)
    )
    assert main(["scenes"]) == 143
    assert said(capsys)[1].count("\n") == 1


@pytest.fixture
def usual_interrupts():
    """Ctrl-C raises KeyboardInterrupt, though shells let processes in the background ignore it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("fake_solvers", "usual_interrupts")
def test_an_interruption_that_was_swallowed_still_ends_the_run(monkeypatch, tmp_path):
    """Ctrl-C during an import may be lost there; the next step raises it anew."""

    def swallow(self, solver):
        with suppress(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr("studies.observers.contact_watch.ContactWatch.start", swallow)
    assert main(["run", "taylor-classic", "--out", str(tmp_path / "out")]) == 130
    assert not (tmp_path / "out/run.json").exists()


def test_an_interruption_that_was_swallowed_ends_a_study_at_its_next_measurement():
    """Compiling may swallow it, and the run that follows is measured first."""
    with interruptible():
        with suppress(Terminated):
            signal.raise_signal(signal.SIGTERM)
        with pytest.raises(Terminated), measured():
            pass
