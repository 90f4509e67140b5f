"""A run as plain data: run.json, and one entry of results.json."""

import json
import platform
from dataclasses import asdict

from studies.decisions.afterwards import decision_entry, verified
from studies.methods.method import find_method
from studies.output.versions import processor, versions
from studies.runs.result import RunResult
from studies.scenes.effects import scene_effects


def run_entry(result: RunResult) -> dict:
    """The run as an entry of `runs` in results.json."""
    return {
        "method": result.method,
        "resolution": result.resolution,
        "resolution_counts": find_method(result.method).unit,
        "wall": result.wall,
        "threads": result.threads,
        "status": result.status,
        "message": "" if result.failure is None else str(result.failure),
        "ended": result.ended,
        "points": result.points,
        "resumed": result.resumed,
        "quantities": {name: quantity.as_json() for name, quantity in result.quantities.items()},
        "cost": asdict(result.cost),
        "conservation": result.conservation,
        "energies": result.energies,
        "numerical_fracture": result.numerical_fracture,
        "decisions": [
            asdict(decision) | {"wanted": decision.wanted} | decision_entry(decision, found)
            for decision, found in verified(result)
        ],
        "effects": [
            effect_entry(effect) for effect in scene_effects(result.scene, result.wall, (result.method,))
        ],
    }


def run_record(result: RunResult) -> dict:
    """The content of run.json: the entry, the scene's name, versions and machine."""
    return {
        "scene": result.scene.name,
        **run_entry(result),
        "unused_tags": list(result.scene.unused),
        "versions": versions(),
        "machine": {"processor": processor(), "system": platform.platform()},
    }


def effect_entry(effect) -> dict:
    """One effect: on, or off and why."""
    return {"name": effect.name, "on": effect.on, "reason": effect.reason}


def to_json(content: dict) -> str:
    """Readable JSON; refuses NaN and infinity, which are not JSON."""
    return json.dumps(content, indent=1, allow_nan=False) + "\n"
