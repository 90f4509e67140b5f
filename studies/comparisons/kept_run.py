"""A complete run kept in its folder, so that a comparison which was stopped can go on without making it again."""

import json
from dataclasses import asdict
from pathlib import Path

import numpy as np

from core_models.atomic import replacing
from core_models.checkpoint import part_of, under
from studies.bar.taylor_impact import Quantity
from studies.observers.history import History
from studies.output.kept_file import DAMAGE, unreadable
from studies.output.output_folder import OutputFolder
from studies.runs.costs import Cost
from studies.runs.result import FinalState, RunResult
from studies.scenes.scene import Scene

FILE = "result.npz"
PLAIN = ("ended", "points", "resumed", "conservation", "energies", "numerical_fracture")

FINAL = ("domains", "reference", "volumes")


def keep_run(result: RunResult, folder: OutputFolder) -> None:
    """Write all that a comparison needs of a run; raises DiskFull, OutputError."""
    record = {name: getattr(result, name) for name in PLAIN}
    record["cost"] = asdict(result.cost)
    record["quantities"] = {name: asdict(quantity) for name, quantity in result.quantities.items()}
    final = result.final
    arrays = {"record": np.array(json.dumps(record))} | {name: getattr(final, name) for name in FINAL}
    arrays |= under("history", result.history.checkpoint())
    arrays |= under("field", final.fields) | under("outline", final.outline)
    with replacing(folder.file(FILE)) as temporary, open(temporary, "wb") as file:
        np.savez(file, **arrays)


def kept_run(
    path: Path, scene: Scene, method: str, resolution: int, wall: str, threads: int
) -> RunResult | None:
    """The run that was kept in a folder, or None; raises OutputError if it cannot be read."""
    try:
        with np.load(path / FILE, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
        record = json.loads(str(arrays["record"]))
        history = History(None, scene.end.limit(wall))
        history.resume(None, part_of(arrays, "history"))
        cost = Cost(**record.pop("cost"))
        quantities = {name: Quantity(**each) for name, each in record.pop("quantities").items()}
        fields, outline = part_of(arrays, "field"), part_of(arrays, "outline")
        final = FinalState(fields=fields, outline=outline, **{name: arrays[name] for name in FINAL})
    except FileNotFoundError:
        return None
    except DAMAGE as error:
        raise unreadable(path / FILE, error, f"remove {path} and resume again") from error
    return RunResult(
        scene, method, resolution, wall, threads, history, cost, quantities=quantities, final=final, **record
    )
