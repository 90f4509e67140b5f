"""Where results go when nobody says."""

from datetime import datetime
from pathlib import Path


def default_folder(scene: str) -> Path:
    """results/SCENE-DATE-TIME below the current folder."""
    return Path("results") / f"{scene}-{datetime.now():%Y%m%d-%H%M%S}"
