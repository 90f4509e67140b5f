"""Geometries: what the coordinates of a mesh mean. Kernels are compiled for one of them."""

from typing import NamedTuple

from core_models.errors import SceneError
from core_models.names import suggestion


class Axisymmetric(NamedTuple):
    """Coordinates (r, z), a body of revolution; tensors in the order r, z, hoop; volumes carry 2 pi r."""


class PlaneStrain(NamedTuple):
    """Coordinates (x, y), no motion along z; volumes are those of a body 1 m thick."""


class Spatial(NamedTuple):
    """Coordinates (x, y, z)."""


GEOMETRIES = {"axisymmetric": Axisymmetric(), "plane-strain": PlaneStrain(), "spatial": Spatial()}
DIMENSIONS = {"axisymmetric": 2, "plane-strain": 2, "spatial": 3}

AXES = "xyz"

Geometry = Axisymmetric | PlaneStrain | Spatial


def axis_names(geometry: Geometry) -> str:
    """Names of the coordinates, one letter each."""
    return "rz" if isinstance(geometry, Axisymmetric) else AXES


def find_geometry(name: str | None, dimension: int) -> Geometry:
    """The geometry of that name for a mesh of that dimension; by default axisymmetric in 2-D, spatial in 3-D.

    Raises SceneError for an unknown name, or one that does not go with the mesh.
    """
    if name is None:
        name = "axisymmetric" if dimension == 2 else "spatial"
    if name not in GEOMETRIES:
        raise SceneError(f"no geometry is called {name!r}; {suggestion(name, GEOMETRIES)}")
    if DIMENSIONS[name] != dimension:
        fitting = [other for other in GEOMETRIES if DIMENSIONS[other] == dimension]
        raise SceneError(
            f"geometry {name!r} needs a mesh of dimension {DIMENSIONS[name]}, this one has {dimension}: "
            f"give {' or '.join(fitting)}"
        )
    return GEOMETRIES[name]
