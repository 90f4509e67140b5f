"""A run's folder: claimed by one process, written file by file, never half a file."""

import fcntl
import os
import shutil
from pathlib import Path

from core_models.atomic import replacing, unwritable
from core_models.errors import OutputError

LOCK = ".lock"


class OutputFolder:
    """An empty or new folder that belongs to this process until released.

    Claiming raises OutputError, before anything is written, when the folder holds files or another live
    process has it. Every file goes to a temporary name in the same folder, is flushed to disk, then renamed.
    """

    REMEDY = "choose another with --out"
    """For a folder that another live process has."""

    def __init__(self, path: Path | str) -> None:
        self.path = Path(path)
        check_unused(self.path)
        self._made = [folder for folder in (self.path, *self.path.parents) if not folder.exists()]
        try:
            self.path.mkdir(parents=True, exist_ok=True)
            self._lock = open(self.path / LOCK, "a")  # noqa: SIM115 - held open as long as the folder is ours
        except OSError as error:
            raise unwritable(self.path, error) from error
        self._claim()

    def _live(self) -> OutputError:
        return _live(self.path, self.REMEDY)

    def _lock_file(self) -> None:
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            self._lock.close()
            raise self._live() from error

    def _claim(self) -> None:
        self._lock_file()
        if _holds_files(self.path):
            self._lock.close()
            raise _not_empty(self.path)

    def file(self, name: str) -> Path:
        """The path of a file in the folder, its own folder made; to be written atomically."""
        if not self._is_ours():
            raise OutputError(
                f"{self.path}: was removed while the run was writing to it; run again and leave it alone"
            )
        target = self.path / name
        try:
            target.parent.mkdir(exist_ok=True)
        except OSError as error:
            raise unwritable(target, error) from error
        return target

    def _is_ours(self) -> bool:
        try:
            return os.path.samestat(os.fstat(self._lock.fileno()), os.stat(self.path / LOCK))
        except OSError:
            return False

    def write_text(self, name: str, text: str) -> None:
        """Write one text file, atomically."""
        with replacing(self.file(name)) as temporary:
            temporary.write_text(text, encoding="utf-8")

    def copy(self, source: Path) -> None:
        """Copy one file into the folder, atomically."""
        with replacing(self.file(source.name)) as temporary:
            shutil.copyfile(source, temporary)

    def subfolder(self, name: str) -> "OutputFolder":
        """A folder of its own for one of several runs."""
        return OutputFolder(self.file(name))

    def release(self) -> None:
        """Give the folder up: remove the lock, and the folders made for it that stayed empty."""
        (self.path / LOCK).unlink(missing_ok=True)
        self._lock.close()
        for folder in self._made:
            if folder.is_dir():
                if any(folder.iterdir()):
                    break
                folder.rmdir()

    def __enter__(self) -> "OutputFolder":
        return self

    def __exit__(self, *_: object) -> None:
        self.release()


class ResumedFolder(OutputFolder):
    """The folder of a run that did not end, claimed in order to go on with it.

    Removes the temporary files that a killed process has left. Raises OutputError, before anything is written, when
    there is no such folder or another live process has it.
    """

    REMEDY = "wait for it, or stop it"

    def __init__(self, path: Path | str) -> None:
        self.path, self._made = Path(path), []
        if not self.path.is_dir():
            raise OutputError(f"{path}: no such folder; name that of a run which did not end")
        if _is_held(self.path):
            raise self._live()
        try:
            self._lock = open(self.path / LOCK, "a")  # noqa: SIM115 - held open as long as the folder is ours
        except OSError as error:
            raise unwritable(self.path, error) from error
        self._claim()
        for left in self.path.rglob(".*.part"):
            left.unlink()

    def _claim(self) -> None:
        self._lock_file()
        # Between opening and locking, the process that had the folder may have ended and removed its lock.
        if not self._is_ours():
            self._lock.close()
            raise self._live()


def check_unused(path: Path | str) -> None:
    """Refuse a folder that holds anything but an abandoned lock; writes nothing. Raises OutputError."""
    path = Path(path)
    try:
        if path.exists() and not path.is_dir():
            raise OutputError(f"{path}: is a file, not a folder; choose another with --out")
        if path.is_dir() and _is_held(path):
            raise _live(path, OutputFolder.REMEDY)
        if path.is_dir() and _holds_files(path):
            raise _not_empty(path)
    except OSError as error:
        raise OutputError(f"{path}: cannot be used ({error.strerror}); choose another with --out") from error


def _holds_files(path: Path) -> bool:
    return any(entry.name != LOCK for entry in path.iterdir())


def _is_held(path: Path) -> bool:
    """Whether a live process has the lock of a folder."""
    if not (path / LOCK).exists():
        return False
    with open(path / LOCK) as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return True
    return False


def _live(path: Path, remedy: str) -> OutputError:
    return OutputError(f"{path}: output folder in use (another run is writing to it); {remedy}")


def _not_empty(path: Path) -> OutputError:
    return OutputError(
        f"{path}: output folder in use (it is not empty); choose another with --out, or remove it"
    )
