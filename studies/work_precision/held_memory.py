"""Memory that a solver holds, counted from its arrays: the same on every machine, whatever ran before."""

from typing import Any

import numpy as np

OWN = ("core_models", "fem", "meshes", "mpm")


def held_bytes(thing: Any) -> int:
    """Bytes of all NumPy arrays that an object and its parts hold, each once; factors of a matrix are not arrays."""
    seen: dict[int, Any] = {}
    waiting = [thing]
    while waiting:
        each = waiting.pop()
        if isinstance(each, np.ndarray) and isinstance(each.base, np.ndarray):
            each = each.base
        if id(each) in seen:
            continue
        seen[id(each)] = each
        waiting += _parts(each)
    return sum(each.nbytes for each in seen.values() if isinstance(each, np.ndarray))


def _parts(thing: Any) -> list[Any]:
    if isinstance(thing, dict):
        return list(thing.values())
    if isinstance(thing, (list, tuple)):
        return list(thing)
    if type(thing).__module__.partition(".")[0] in OWN:
        return list(getattr(thing, "__dict__", {}).values())
    return []
