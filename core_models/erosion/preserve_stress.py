"""Erosion: a failed point goes on as it was."""

from typing import NamedTuple

from core_models.laws import eroded_stress


class PreserveStress(NamedTuple):
    """A point whose damage has reached 1 keeps stress and strength: it is marked as failed, by its damage, no more.

    Source: Uintah's erosion algorithm `PreserveStress`.
    """


@eroded_stress.register(PreserveStress)
def _(erosion, damage, deviator, mean_stress):
    return deviator, mean_stress
