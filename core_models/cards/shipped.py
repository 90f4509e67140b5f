"""The materials that come with matpoint."""

from pathlib import Path

DATA_FOLDER = Path(__file__).resolve().parents[1] / "data"


def shipped_materials() -> dict[str, Path]:
    """Name and file of every shipped material."""
    return {path.stem: path for path in sorted(DATA_FOLDER.glob("*.xml"))}
