"""The file of a checkpoint: checkpoint.npz in the folder of the run."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from core_models.atomic import replacing
from core_models.checkpoint import Checkpoint, part_of, under
from core_models.compilation import source_hash
from core_models.errors import OutputError
from studies.output.kept_file import DAMAGE, unreadable
from studies.output.output_folder import OutputFolder

FILE = "checkpoint.npz"
SETTINGS = "settings"


@dataclass(frozen=True)
class Settings:
    """What a run was started with besides its scene. sources : hash of the code that its steps are made by."""

    method: str
    resolution: int
    wall: str
    threads: int
    interval: str
    sources: str


@dataclass(frozen=True)
class Spent:
    """What a run had cost when it was written down [s], and how often it had been resumed."""

    wall_s: float = 0.0
    cpu_s: float = 0.0
    resumed: int = 0


@dataclass(frozen=True)
class Saved:
    """A checkpoint that has been read. observers : theirs by class name."""

    settings: Settings
    spent: Spent
    solver: Checkpoint
    observers: dict[str, Checkpoint]


def write_checkpoint(folder: OutputFolder, saved: Saved) -> None:
    """Write the file whole, or leave the one before; raises DiskFull, OutputError."""
    arrays = {SETTINGS: np.array(json.dumps([asdict(saved.settings), asdict(saved.spent)]))}
    arrays |= under("solver", saved.solver)
    for name, checkpoint in saved.observers.items():
        arrays |= under(f"observer.{name}", checkpoint)
    with replacing(folder.file(FILE)) as temporary, open(temporary, "wb") as file:
        np.savez(file, **arrays)


def read_checkpoint(path: Path) -> Saved:
    """The checkpoint in the folder of a run; OutputError if there is none, it is damaged, or the code has changed."""
    try:
        with np.load(path / FILE, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
        settings, spent = json.loads(str(arrays.pop(SETTINGS)))
        saved = Saved(Settings(**settings), Spent(**spent), part_of(arrays, "solver"), _observers(arrays))
    except FileNotFoundError:
        raise OutputError(
            f"{path}: holds no {FILE}, so no run to go on with; start it with matpoint run"
        ) from None
    except DAMAGE as error:
        raise unreadable(
            path / FILE, error, f"remove {path} and run the scene, or resume the comparison, again"
        ) from error
    if saved.settings.sources != source_hash():
        raise OutputError(
            f"{path / FILE}: was written by another version of matpoint, which may go on differently; resume with "
            "that one, or run the scene again"
        )
    return saved


def _observers(arrays: Checkpoint) -> dict[str, Checkpoint]:
    arrays = part_of(arrays, "observer")
    return {name: part_of(arrays, name) for name in {key.partition(".")[0] for key in arrays}}
