"""What commands print with `--json`: one JSON document on standard output."""

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np


def json_text(content: Any) -> str:
    """Readable JSON of plain data, arrays, NamedTuples and classes; what is infinite or no number becomes null."""
    return json.dumps(plain(content), indent=1, allow_nan=False, ensure_ascii=False)


def plain(content: Any) -> Any:
    """The same as dictionaries, lists, words and finite numbers."""
    if isinstance(content, type):
        return content.__name__
    if isinstance(content, Mapping):
        return {str(key): plain(value) for key, value in content.items()}
    if hasattr(content, "_asdict"):
        return plain(content._asdict())
    if isinstance(content, np.ndarray | np.generic):
        return plain(content.tolist())
    if isinstance(content, list | tuple | set):
        return [plain(value) for value in content]
    if isinstance(content, float):
        return content if math.isfinite(content) else None
    return str(content) if isinstance(content, Path) else content


def print_results(folder: Path) -> None:
    """Print the results.json of a finished study with the folder's name."""
    content = json.loads((folder / "results.json").read_text(encoding="utf-8"))
    print(json_text({"folder": folder} | content))
