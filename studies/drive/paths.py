"""The paths that `matpoint drive` knows by name, and how their strain is measured."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core_models import loading_paths
from core_models.errors import SceneError
from core_models.loading_program import Program
from core_models.names import suggestion


@dataclass(frozen=True)
class DrivePath:
    """A path: its program, what its strain is called and how it follows from F (k, 3, 3).

    stress: number of the component of the stress vector (11, 22, 33, 12, 23, 31) that the strain drives.
    """

    make: Callable[..., Program]
    strain: str
    measure: Callable[[np.ndarray], np.ndarray]
    stress: int


def _true_strain(f: np.ndarray) -> np.ndarray:
    return np.log(f[:, 0, 0])


def _shear(f: np.ndarray) -> np.ndarray:
    return f[:, 0, 1]


def _volume_strain(f: np.ndarray) -> np.ndarray:
    return np.log(np.linalg.det(f))


PATHS = {
    "uniaxial-stress": DrivePath(loading_paths.uniaxial_stress, "true strain 11", _true_strain, 0),
    "uniaxial-strain": DrivePath(loading_paths.uniaxial_strain, "true strain 11", _true_strain, 0),
    "plane-strain": DrivePath(loading_paths.plane_strain, "true strain 11", _true_strain, 0),
    "biaxial": DrivePath(loading_paths.biaxial, "true strain 11", _true_strain, 0),
    "simple-shear": DrivePath(loading_paths.simple_shear, "shear 12", _shear, 3),
    "volumetric": DrivePath(loading_paths.volumetric, "ln J", _volume_strain, 0),
    "cyclic": DrivePath(loading_paths.cyclic, "true strain 11", _true_strain, 0),
}


def find_path(name: str) -> DrivePath:
    """The path of that name; raises SceneError naming the nearest one."""
    if name not in PATHS:
        raise SceneError(f"unknown path '{name}'; {suggestion(name, PATHS)}")
    return PATHS[name]
