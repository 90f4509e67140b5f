"""The outcome of `matpoint drive` as plain data."""

from typing import Any

from studies.drive.columns import columns
from studies.drive.driving import DriveResult
from studies.drive.text import remarks


def drive_record(result: DriveResult) -> dict[str, Any]:
    """What was done, every quantity of the history by 'name [unit]', and remarks."""
    test = result.test
    return {
        "material": test.material.name,
        "laws": {type(law).__name__: law for law in test.material.laws},
        "test": test.words,
        "temperature": test.temperature,
        "history": columns(result.history, test.material),
        "remarks": list(remarks(result)),
    }
