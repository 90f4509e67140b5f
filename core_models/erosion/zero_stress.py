"""Erosion: a failed point carries nothing."""

from typing import NamedTuple

from core_models.laws import eroded_stress


class ZeroStress(NamedTuple):
    """A point whose damage has reached 1 carries no stress.

    Source: Uintah's erosion algorithm `ZeroStress`, without its decay time.
    """


@eroded_stress.register(ZeroStress)
def _(erosion, damage, deviator, mean_stress):
    if damage < 1.0:
        return deviator, mean_stress
    return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), 0.0
