"""Erosion: a failed point carries pressure only."""

from typing import NamedTuple

from core_models.laws import eroded_stress


class AllowNoShear(NamedTuple):
    """A point whose damage has reached 1 carries no shear; mean stress of either sign stays.

    Source: Uintah's erosion algorithm `AllowNoShear`, without its decay time.
    """


@eroded_stress.register(AllowNoShear)
def _(erosion, damage, deviator, mean_stress):
    if damage < 1.0:
        return deviator, mean_stress
    return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), mean_stress
