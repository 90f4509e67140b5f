"""Files that are there completely or not at all."""

import os
from pathlib import Path

from core_models.errors import OutputError


def write_atomically(path: str | Path, content: bytes) -> None:
    """Write a file under a temporary name in the same folder, flush it to disk, then rename it.

    Raises
    ------
    OutputError : the folder is missing or cannot be written to; nothing is left half-written.
    """
    path = Path(path)
    temporary = path.parent / f".{path.name}.{os.getpid()}.tmp"
    try:
        with temporary.open("xb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(temporary, path)
    except OSError as error:
        raise OutputError(f"{path}: cannot be written ({error}); name a file in a writable folder") from error
    finally:
        temporary.unlink(missing_ok=True)
