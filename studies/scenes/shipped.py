"""The scenes that come with matpoint, and scene files by name."""

from pathlib import Path

from core_models.errors import SceneError
from core_models.names import suggestion

SCENES_FOLDER = Path(__file__).resolve().parent


def shipped_scenes() -> dict[str, Path]:
    """Name and file of every shipped scene."""
    return {path.stem: path for path in sorted(SCENES_FOLDER.glob("*.xml"))}


def find_scene(name: str | Path) -> Path:
    """The file of a shipped scene's name, or the path itself; raises SceneError naming the nearest scene."""
    shipped = shipped_scenes()
    if str(name) in shipped:
        return shipped[str(name)]
    path = Path(name)
    if path.suffix == ".xml" or path.is_file():
        return path
    raise SceneError(
        f"no scene '{name}'; {suggestion(str(name), shipped)} (or give the path of a scene file)"
    )
