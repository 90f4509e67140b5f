"""Deformation paths for the bare driver: arrays (k, 3, 3) of deformation gradients."""

import numpy as np
from numpy.typing import ArrayLike


def simple_shear(gamma: ArrayLike) -> np.ndarray:
    """Simple shear along x in planes normal to y: F = 1 + gamma e_x e_y; gamma (k,) [-]."""
    gamma = np.asarray(gamma, dtype=np.float64)
    path = np.tile(np.eye(3), (len(gamma), 1, 1))
    path[:, 0, 1] = gamma
    return path


def uniaxial_strain(stretch: ArrayLike) -> np.ndarray:
    """Stretch along x without lateral strain: F = diag(stretch, 1, 1); stretch (k,) [-], > 0."""
    stretch = np.asarray(stretch, dtype=np.float64)
    return principal_stretches(stretch, np.ones_like(stretch), np.ones_like(stretch))


def isochoric_tension(stretch: ArrayLike) -> np.ndarray:
    """Stretch along x at constant volume: F = diag(s, s^-1/2, s^-1/2); its logarithm is the equivalent strain."""
    stretch = np.asarray(stretch, dtype=np.float64)
    return principal_stretches(stretch, stretch**-0.5, stretch**-0.5)


def principal_stretches(first: ArrayLike, second: ArrayLike, third: ArrayLike) -> np.ndarray:
    """Stretches along fixed axes x, y, z: F = diag(first, second, third); each (k,) [-], > 0."""
    stretches = np.stack([first, second, third], axis=-1).astype(np.float64)
    return stretches[:, :, None] * np.eye(3)


def rotations(axis: ArrayLike, angles: ArrayLike) -> np.ndarray:
    """Rotations about an axis (3,) by angles (k,) [rad]: Q = 1 + sin(a) W + (1 - cos(a)) W^2 (Rodrigues)."""
    x, y, z = np.asarray(axis, dtype=np.float64) / np.linalg.norm(axis)
    w = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angles = np.asarray(angles, dtype=np.float64)[:, None, None]
    return np.eye(3) + np.sin(angles) * w + (1.0 - np.cos(angles)) * (w @ w)


def turned(path: np.ndarray, rotation: np.ndarray) -> np.ndarray:
    """The path as an observer sees it who turns: Q F; path and rotation (k, 3, 3)."""
    return rotation @ path
