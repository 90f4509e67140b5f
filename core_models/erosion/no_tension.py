"""Erosion: a failed point carries compression only."""

from typing import NamedTuple

from core_models.laws import eroded_stress


class AllowNoTension(NamedTuple):
    """A point whose damage has reached 1 carries no shear and no tension.

    Source: Uintah's erosion algorithm `AllowNoTension`, without its decay time.
    """


@eroded_stress.register(AllowNoTension)
def _(erosion, damage, deviator, mean_stress):
    if damage < 1.0:
        return deviator, mean_stress
    return (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), min(mean_stress, 0.0)
