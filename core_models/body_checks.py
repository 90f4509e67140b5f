"""Checks of what every solver is built from, in the same words."""

import math
from typing import Any

from core_models.arguments import check_between
from core_models.bulk_viscosity import check_viscosity
from core_models.errors import MaterialError
from core_models.geometry import Geometry, Spatial
from core_models.material import Material


def check_body(material: Any, temperature: Any, viscosity: Any) -> None:
    """Refuse what is no material, no temperature above 0 K, or no viscosity; MaterialError or SceneError."""
    if not isinstance(material, Material):
        raise MaterialError(
            f"material = {material!r} is no material: give a core_models.material.Material, for example from a card"
        )
    if temperature is not None:
        check_between("temperature", temperature, 0.0, math.inf, "K")
    check_viscosity(viscosity)


def check_orientation(material: Material, geometry: Geometry) -> None:
    """Refuse directions of a material that would push points out of a two-dimensional body; MaterialError."""
    if isinstance(geometry, Spatial):
        return
    for direction in getattr(getattr(material, "update", None), "directions", ()):
        if direction[2] != 0.0 and (direction[0] != 0.0 or direction[1] != 0.0):
            raise material.error(
                "update",
                f"the direction {direction} is oblique to the plane of a two-dimensional body, which would leave it: "
                "give one in the plane (third component 0) or normal to it, or take a mesh in space",
            )
