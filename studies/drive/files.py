"""The files of `matpoint drive`: history, picture, and a folder with both, the card and the summary."""

from importlib.util import find_spec
from pathlib import Path

from core_models.atomic import replacing
from core_models.cards import write_material
from core_models.errors import OutputError
from studies.drive.columns import csv_text
from studies.drive.driving import DriveResult
from studies.drive.plot import check_format, write_plot
from studies.output.output_folder import OutputFolder, check_unused

HISTORY, PICTURE, SUMMARY, CARD = "history.csv", "history.svg", "summary.txt", "material.xml"


def check_files(csv: str | None, plot: str | None, folder: str | None) -> None:
    """Refuse what could not be written, before anything is computed. Raises OutputError, SceneError."""
    if plot is not None:
        check_format(plot)
    for path in (csv, plot):
        if path is not None and not Path(path).parent.is_dir():
            raise OutputError(
                f"{path}: there is no folder {Path(path).parent}; make it, or name another file"
            )
    if folder is not None:
        check_unused(folder)


def write_files(
    result: DriveResult, text: str, csv: str | None, plot: str | None, folder: str | None
) -> list[Path]:
    """Write what was asked for; text: the summary for the folder. Returns the files, or the folder, in that order."""
    written = []
    if csv is not None:
        _write(Path(csv), csv_text(result.history, result.test.material))
        written.append(Path(csv))
    if plot is not None:
        write_plot(result, plot)
        written.append(Path(plot))
    if folder is not None:
        _write_folder(result, text, folder)
        written.append(Path(folder))
    return written


def _write(path: Path, text: str) -> None:
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def _write_folder(result: DriveResult, text: str, path: str) -> None:
    with OutputFolder(path) as folder:
        folder.write_text(HISTORY, csv_text(result.history, result.test.material))
        if find_spec("matplotlib") is not None:
            write_plot(result, folder.file(PICTURE))
        write_material(result.test.material, folder.file(CARD))
        folder.write_text(SUMMARY, f"{text}\n")
