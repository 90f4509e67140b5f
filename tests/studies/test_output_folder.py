"""Output folders: refused when in use, never half a file."""

import subprocess
import sys

import pytest

from core_models.errors import OutputError
from studies.output.output_folder import LOCK, OutputFolder, check_unused


def test_a_folder_that_holds_files_is_refused_and_left_alone(tmp_path):
    """Nothing is written into a folder that is not empty."""
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(OutputError, match="in use.*--out"):
        OutputFolder(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


def test_a_file_in_place_of_a_folder_is_refused(tmp_path):
    """The error says that it is a file."""
    (tmp_path / "out").write_text("")
    with pytest.raises(OutputError, match="is a file"):
        OutputFolder(tmp_path / "out")


def test_a_second_claim_is_refused_while_the_first_lives(tmp_path):
    """Two runs never share a folder."""
    with OutputFolder(tmp_path / "out"), pytest.raises(OutputError, match="another run"):
        OutputFolder(tmp_path / "out")


def test_a_lock_left_by_a_killed_process_does_not_count(tmp_path):
    """The lock belongs to a live process, not to a file."""
    code = (
        "import os, sys; from studies.output.output_folder import OutputFolder;"
        "held = OutputFolder(sys.argv[1]); os._exit(9)"
    )
    subprocess.run([sys.executable, "-c", code, str(tmp_path / "out")], check=False)
    assert (tmp_path / "out" / LOCK).exists()
    with OutputFolder(tmp_path / "out") as folder:
        folder.write_text("a.txt", "a")
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["a.txt"]


def test_files_appear_whole_without_leftovers(tmp_path):
    """A rewritten file is there whole, and no temporary name stays."""
    with OutputFolder(tmp_path / "out") as folder:
        folder.write_text("a.txt", "first")
        folder.write_text("frames/b.txt", "b")
        folder.write_text("a.txt", "second")
    assert (tmp_path / "out/a.txt").read_text() == "second"
    assert sorted(path.name for path in (tmp_path / "out").rglob("*")) == ["a.txt", "b.txt", "frames"]


def test_a_folder_that_stayed_empty_is_removed(tmp_path):
    """Bad input found after the claim leaves nothing behind."""
    with OutputFolder(tmp_path / "out"):
        assert (tmp_path / "out").is_dir()
    assert not (tmp_path / "out").exists()


def test_a_live_run_with_files_is_not_to_be_removed(tmp_path):
    """Only a folder that nobody is writing to may be called one to remove."""
    with OutputFolder(tmp_path / "out") as folder:
        folder.write_text("a.txt", "a")
        with pytest.raises(OutputError, match="another run") as refused:
            check_unused(tmp_path / "out")
        assert "remove" not in str(refused.value)
    with pytest.raises(OutputError, match="or remove it"):
        check_unused(tmp_path / "out")


def test_a_path_that_no_folder_can_have_is_refused(tmp_path):
    """A name that is too long is an output error, not a traceback."""
    with pytest.raises(OutputError, match="--out"):
        OutputFolder(tmp_path / ("x" * 300))
