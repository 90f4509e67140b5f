"""Erosion: a failed point carries pressure only."""

from typing import NamedTuple

from core_models.erosion.decay import damage_in_decay, left_after_failure
from core_models.laws import damage_after, eroded_stress
from core_models.tensors import scaled


class AllowNoShear(NamedTuple):
    """A point whose damage has reached 1 carries no shear; mean stress of either sign stays.

    Parameters
    ----------
    decay_time : what is lost decays as exp(-(t - t_failure) / decay_time) [s]; 0: at once.

    Strength decays, that is the flow stress: what a point carries already never grows.
    Source: Uintah's erosion algorithm `AllowNoShear`, where shear is lost at once.
    """

    decay_time: float = 0.0


@eroded_stress.register(AllowNoShear)
def _(erosion, damage, deviator, mean_stress):
    left = left_after_failure(erosion.decay_time, damage)
    return scaled(deviator, left), mean_stress


@damage_after.register(AllowNoShear)
def _(erosion, damage, increment, dt):
    return damage_in_decay(erosion.decay_time, damage, increment, dt)
