"""How far a stress lies outside the yield surface of each condition, in numpy, for tests."""

from functools import singledispatch

import numpy as np

from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.gurson_surface import argument, effective_porosity, yield_function
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises

FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]


def mises(stress):
    """Equivalent stress [Pa] of six components."""
    normal = stress[:3] - stress[:3].mean()
    return np.sqrt(1.5 * (normal @ normal) + 3.0 * (stress[3:] @ stress[3:]))


@singledispatch
def excess(condition, stress, flow, porosity):
    """Distance from the surface [Pa], to first order; negative inside.

    Parameters
    ----------
    stress : (6,) beyond the back stress, in the update's measure [Pa]. flow : flow stress [Pa]. porosity : [-].
    """


@excess.register
def _(condition: VonMises, stress, flow, porosity):
    return mises(stress) - flow


@excess.register
def _(condition: DruckerPrager, stress, flow, porosity):
    mean = stress[:3].mean()
    cone = mises(stress) / np.sqrt(3.0) + 3.0 * condition.alpha * mean - condition.cohesion_factor * flow
    return max(cone, mean - condition.tension_cutoff)


@excess.register
def _(condition: MohrCoulomb, stress, flow, porosity):
    low, _middle, high = np.linalg.eigvalsh(stress[FULL])
    angle = np.radians(condition.friction_angle)
    sheared = high - low + (high + low) * np.sin(angle) - 2.0 * flow * np.cos(angle)
    return max(0.5 * sheared, high - condition.tension_cutoff)


@excess.register
def _(condition: Gurson, stress, flow, porosity):
    size, mean = mises(stress), stress[:3].mean()
    value = yield_function(condition, size, mean, flow, porosity)
    f = effective_porosity(condition, porosity)[0]
    across = 3.0 * condition.q1 * condition.q2 * f * np.sinh(abs(argument(condition, mean, flow)))
    slope = 2.0 * size / flow + across
    return value * flow / slope if slope > 0.0 else -flow
