"""Erosion: a failed point is out of the simulation."""

from typing import NamedTuple

from core_models.erosion.decay import damage_in_decay, left_after_failure
from core_models.laws import damage_after, eroded_stress, is_out
from core_models.tensors import scaled


class DeletePoint(NamedTuple):
    """A point whose damage has reached 1, and what was left of its stress has decayed, is out of the simulation.

    Parameters
    ----------
    decay_time : what is lost decays as exp(-(t - t_failure) / decay_time) [s]; 0: at once.

    It carries no stress ever again, has no wave speed that could limit the step, and no deformation stops it; a finite
    element that turns inside out still ends the run. Its mass stays as debris, so that mass and momentum are kept.
    With a decay time it is out once less than 1e-6 is left.
    Source: element deletion as in explicit finite element codes; Uintah deletes such particles.
    """

    decay_time: float = 0.0


SMALLEST_SHARE = 1e-6


@eroded_stress.register(DeletePoint)
def _(erosion, damage, deviator, mean_stress):
    left = left_after_failure(erosion.decay_time, damage)
    return scaled(deviator, left), mean_stress * left


@damage_after.register(DeletePoint)
def _(erosion, damage, increment, dt):
    return damage_in_decay(erosion.decay_time, damage, increment, dt)


@is_out.register(DeletePoint)
def _(erosion, damage):
    return damage >= 1.0 and left_after_failure(erosion.decay_time, damage) < SMALLEST_SHARE
