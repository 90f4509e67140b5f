"""How a failed point loses what its erosion takes: at once, or exponentially in time."""

import math

from core_models.compilation import inside_kernel


@inside_kernel
def left_after_failure(decay_time, damage):
    """Share that is left [-]: 1 before failure, then exp(-(t - t_failure) / decay_time), 0 without a decay time.

    Beyond 1 the damage variable counts the time since failure over the decay time.
    """
    if damage < 1.0:
        return 1.0
    return math.exp(1.0 - damage) if decay_time > 0.0 else 0.0


@inside_kernel
def damage_in_decay(decay_time, damage, increment, dt):
    """Damage variable after a step: grown by what the damage law says, counting time after failure."""
    if damage >= 1.0 and decay_time > 0.0:
        return damage + dt / decay_time
    return damage + increment
