"""The folder of a study: new, or that of one which was stopped; results are kept in it as soon as they are there."""

import json
import logging
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from core_models.compilation import source_hash
from core_models.errors import OutputError
from studies.output.kept_file import read_object
from studies.output.output_folder import OutputFolder, ResumedFolder
from studies.runs.record import to_json

logger = logging.getLogger(__name__)
SETTINGS = "study.json"
KEPT = "runs"


@contextmanager
def study_folder(path: Path | str, settings: dict[str, Any], going_on: bool) -> Iterator[OutputFolder]:
    """The folder, ours until the end; settings say which study it holds.

    going_on : it is that of a study with the same settings, which was stopped. Raises OutputError for a folder that is
    in use, that another study was started in, or whose settings are damaged; warns if other sources did.
    """
    with ResumedFolder(path) if going_on else OutputFolder(path) as folder:
        now = {"sources": source_hash()} | settings
        if going_on:
            before = _before(folder.path)
            _check_settings(folder.path, before, settings)
            if before.get("sources") != now["sources"]:
                logger.warning(
                    "%s: was started with other sources of matpoint; what has been kept is not made again. Start "
                    "another with --out for results of one kind",
                    path,
                )
        folder.write_text(SETTINGS, to_json(now))
        yield folder


def _before(path: Path) -> dict[str, Any]:
    file = path / SETTINGS
    return (
        read_object(file, "it says which study the folder holds: start another with --out")
        if file.exists()
        else {}
    )


def _check_settings(path: Path, before: dict[str, Any], settings: dict[str, Any]) -> None:
    if before.get("study") != settings["study"]:
        raise OutputError(f"{path}: holds no {settings['study']} study to go on with; start one with --out")
    for name, value in json.loads(to_json(settings)).items():
        if before.get(name) != value:
            raise OutputError(
                f"{path}: was started with {_difference(name, before.get(name), value)}; give what it was started "
                "with, or start another with --out"
            )


def _difference(name: str, before: Any, now: Any) -> str:
    if not (isinstance(before, list) and isinstance(now, list)):
        return f"{name} = {before}, not {now}"
    extra = [entry for entry in before if entry not in now] or [entry for entry in now if entry not in before]
    whose = "with" if extra and extra[0] in before else "without"
    return f"another {name}, {whose} {_entry(extra[0])}" if extra else f"another order of {name}"


def _entry(entry: Any) -> str:
    return " ".join(str(part) for part in entry) if isinstance(entry, list) else str(entry)


def kept(folder: OutputFolder, key: str) -> dict[str, Any] | None:
    """The result that was kept under a key, or None; OutputError if its file is damaged."""
    path = folder.path / KEPT / f"{_file(key)}.json"
    return read_object(path, "remove it and resume again") if path.exists() else None


def keep(folder: OutputFolder, key: str, result: dict[str, Any]) -> None:
    """Keep a result under a key."""
    folder.write_text(f"{KEPT}/{_file(key)}.json", to_json(result))


def forget(folder: OutputFolder, key: str) -> None:
    """Remove the result that was kept under a key."""
    (folder.path / KEPT / f"{_file(key)}.json").unlink()


def _file(key: str) -> str:
    return key.replace(":", "-").replace("/", "-")
