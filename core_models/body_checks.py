"""Checks of what every solver is built from, in the same words."""

import math
from typing import Any

from core_models.arguments import check_between
from core_models.bulk_viscosity import check_viscosity
from core_models.errors import MaterialError
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
