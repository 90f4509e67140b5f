"""Folders of studies that are gone on with."""

import pytest

from core_models.errors import OutputError
from studies.output.study_folder import study_folder

SETTINGS = {"study": "stability", "cases": ["melting"]}


def begun(path):
    """A folder that a study was started in."""
    with study_folder(path, SETTINGS, False):
        pass
    return path


def test_going_on_with_the_same_sources_says_nothing(tmp_path, caplog):
    """Results are all of one kind."""
    with study_folder(begun(tmp_path / "a"), SETTINGS, True):
        assert caplog.messages == []


def test_going_on_with_other_sources_is_told(tmp_path, monkeypatch, caplog):
    """What has been kept stays, and the message says that it is of other sources."""
    path = begun(tmp_path / "a")
    monkeypatch.setattr("studies.output.study_folder.source_hash", lambda: "other")
    with study_folder(path, SETTINGS, True):
        (message,) = caplog.messages
        assert str(path) in message and "other sources" in message and "--out" in message


def test_another_plan_is_refused(tmp_path):
    """The message names what differs."""
    path = begun(tmp_path / "a")
    with (
        pytest.raises(OutputError, match="without erosion"),
        study_folder(path, SETTINGS | {"cases": ["melting", "erosion"]}, True),
    ):
        pass
