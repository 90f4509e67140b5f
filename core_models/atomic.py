"""Files that appear whole or not at all."""

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from core_models.errors import DiskFull, OutputError


@contextmanager
def replacing(path: Path | str) -> Iterator[Path]:
    """Give a temporary path in the same folder; when the block ends well, flush it and rename it to `path`.

    When the block raises, the temporary file is removed and an earlier `path` stays as it was.
    Raises DiskFull when there is no space left, another OutputError when the folder cannot be written to.
    """
    path = Path(path)
    temporary = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        yield temporary
        _flush(temporary)
        os.replace(temporary, path)
        _flush(path.parent)
    except OSError as error:
        raise unwritable(path, error) from error
    finally:
        temporary.unlink(missing_ok=True)


def unwritable(path: Path, error: OSError) -> OutputError:
    """The error for a path that the operating system would not let us write."""
    reason = error.strerror or error
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        return DiskFull(f"{path}: cannot be written ({reason}); free space or choose another --out")
    return OutputError(f"{path}: cannot be written ({reason}); name a file in a writable folder")


def _flush(path: Path) -> None:
    """Have the operating system put a file's, or a folder's, content on the disk."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
