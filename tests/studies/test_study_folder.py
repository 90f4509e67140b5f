"""Folders of studies that are gone on with."""

import pytest

from core_models.errors import OutputError
from studies.output.study_folder import keep, kept, study_folder

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


DAMAGED = pytest.mark.parametrize("content", [b"", b'{"case": "melti', b"[]", b"\xff\x00"])


@DAMAGED
def test_a_damaged_result_is_one_line_that_names_its_file(tmp_path, content):
    """Emptied, cut short, no object, no text: removed, it is made again."""
    with study_folder(begun(tmp_path / "a"), SETTINGS, True) as folder:
        keep(folder, "melting--mpm:total", {"case": "melting"})
        file = folder.path / "runs/melting--mpm-total.json"
        file.write_bytes(content)
        with pytest.raises(OutputError) as refused:
            kept(folder, "melting--mpm:total")
        file.unlink()
        assert kept(folder, "melting--mpm:total") is None
    assert str(refused.value) == (
        f"{file}: cannot be read (it is damaged or cut short); remove it and resume again"
    )
    assert refused.value.exit_status == 2


@DAMAGED
def test_damaged_settings_are_one_line_that_says_to_start_another(tmp_path, content):
    """Without them nobody knows which study the folder holds."""
    path = begun(tmp_path / "a")
    (path / "study.json").write_bytes(content)
    with (
        pytest.raises(OutputError, match=r"study\.json: cannot be read .*--out"),
        study_folder(path, SETTINGS, True),
    ):
        pass
