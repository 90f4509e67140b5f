"""Rigid motions that the supports of a body leave free: with one of these the stiffness is singular."""

import numpy as np

from core_models.geometry import Axisymmetric, Geometry, PlaneStrain

_NAMES = {
    2: ("translation along x", "translation along y", "rotation in the plane"),
    3: (
        "translation along x", "translation along y", "translation along z", "rotation about x", "rotation about y",
        "rotation about z",
    ),
}  # fmt: skip
FREE = 1e-9  # singular values of a held motion, relative to the largest possible one


def free_motion(x: np.ndarray, fixed: np.ndarray, geometry: Geometry) -> str:
    """What a body can do without strain, in words; empty if it is held.

    x (n, d) : positions of the nodes [m]. fixed (n, d) : components that are given.
    """
    modes = rigid_modes(x, geometry)
    held = modes[:, fixed]
    _left, values, right = np.linalg.svd(held @ held.T / len(x))
    free = right[values <= FREE]
    if not len(free):
        return ""
    names = ("translation along z",) if isinstance(geometry, Axisymmetric) else _NAMES[x.shape[1]]
    # The free motions span a space: name those of its members that are rigid modes by themselves.
    part = np.linalg.norm(free, axis=0)
    return ", ".join(name for name, share in zip(names, part, strict=True) if share > 0.5) or "a screw motion"


def rigid_modes(x: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Rigid motions (modes, n, d) of nodes at x (n, d), relative to the body's size; rotations about its middle."""
    d = x.shape[1]
    if isinstance(geometry, Axisymmetric):
        return np.broadcast_to([0.0, 1.0], (1, *x.shape)).copy()
    away = x - x.mean(axis=0)
    away /= max(np.abs(away).max(), np.finfo(float).tiny)
    modes = [np.broadcast_to(axis, x.shape) for axis in np.eye(d)]
    if isinstance(geometry, PlaneStrain):
        modes.append(np.column_stack([-away[:, 1], away[:, 0]]))
    else:
        modes += [np.cross(axis, away) for axis in np.eye(3)]
    return np.stack(modes)
