"""What a solver keeps of itself so that a run goes on from there, bitwise, in another process.

A checkpoint is a dictionary of arrays by name; numbers are arrays without axes. It holds what the steps to come depend
on and what cannot be computed from that again, nothing of what the solver is built from.
"""

from collections.abc import Iterable

import numpy as np

from core_models.errors import SceneError
from core_models.points import MaterialPoints

Checkpoint = dict[str, np.ndarray]


def values_of(owner: object, names: Iterable[str]) -> Checkpoint:
    """Copies of the arrays and numbers that an object has under these names; what is None is left out."""
    found = {name.lstrip("_"): getattr(owner, name) for name in names}
    return {key: np.array(value) for key, value in found.items() if value is not None}


def put_values(owner: object, names: Iterable[str], checkpoint: Checkpoint) -> None:
    """Give an object the values that `values_of` has taken: arrays in place, numbers as what they were."""
    for name in names:
        present = getattr(owner, name)
        if isinstance(present, np.ndarray):
            present[...] = checkpoint[name.lstrip("_")]
        elif present is not None:
            setattr(owner, name, type(present)(checkpoint[name.lstrip("_")]))


def under(prefix: str, checkpoint: Checkpoint) -> Checkpoint:
    """The same with 'prefix.' before every name."""
    return {f"{prefix}.{name}": value for name, value in checkpoint.items()}


def part_of(checkpoint: Checkpoint, prefix: str) -> Checkpoint:
    """What `under` has put under a prefix."""
    start = f"{prefix}."
    return {name[len(start) :]: value for name, value in checkpoint.items() if name.startswith(start)}


POINT_ARRAYS = ("old_deformation_gradient", "viscous_pressure", "lengths", "wave_speed")


def points_checkpoint(points: MaterialPoints) -> Checkpoint:
    """The accepted state of material points, whatever fields it has."""
    state = {name: array.copy() for name, array in points.old._asdict().items() if array is not None}
    return state | values_of(points, POINT_ARRAYS)


def restore_points(points: MaterialPoints, checkpoint: Checkpoint) -> None:
    """Give material points the state that `points_checkpoint` has taken."""
    for name, array in points.old._asdict().items():
        if array is not None:
            array[...] = checkpoint[name]
    put_values(points, POINT_ARRAYS, checkpoint)


def check_fits(own: Checkpoint, given: Checkpoint) -> None:
    """Refuse a checkpoint of another body, material or option; SceneError says what differs.

    own : what the solver would write now.
    """
    for name in sorted(set(own) | set(given)):
        sizes = [str(each[name].shape) if name in each else "none" for each in (given, own)]
        if sizes[0] != sizes[1]:
            raise SceneError(
                f"the checkpoint is of another solver: its {name} has the shape {sizes[0]}, here it is {sizes[1]}; "
                "build the solver with the mesh, material and options that the checkpoint was made with"
            )
