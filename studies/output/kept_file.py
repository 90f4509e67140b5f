"""Files that are read again when something is gone on with, and what is said of a damaged one."""

import json
import zipfile
import zlib
from pathlib import Path
from typing import Any

from core_models.errors import OutputError

DAMAGE = (
    *(OSError, ValueError, KeyError, TypeError, EOFError, RuntimeError, OverflowError, MemoryError),
    *(zipfile.BadZipFile, zlib.error),
)
"""What NumPy raises for an archive that is damaged, wherever it is."""


def read_object(path: Path, remedy: str) -> dict[str, Any]:
    """The JSON object in a file; OutputError, which ends with the remedy, if there is no whole one."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise unreadable(path, error, remedy) from error
    if not isinstance(content, dict):
        raise unreadable(path, TypeError(), remedy)
    return content


def unreadable(path: Path, error: Exception, remedy: str) -> OutputError:
    """The error for a file that cannot be opened, with the system's reason, or is not what was written."""
    is_closed = getattr(error, "filename", None) is not None
    reason = error.strerror if is_closed else "it is damaged or cut short"
    return OutputError(f"{path}: cannot be read ({reason}); {remedy}")
