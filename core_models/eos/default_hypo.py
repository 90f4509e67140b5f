"""The founding document's default hypoelastic equation of state."""

import math
from typing import NamedTuple

from core_models.laws import is_beyond_eos, pressure


class DefaultHypoelastic(NamedTuple):
    """Default hypoelastic equation of state: dp/dt = K tr(d), that is p = K ln J (tension positive).

    Source: the founding document's eq. (5), in closed form: tr(d) dt summed over any path is ln J, so nothing drifts.

    Parameters
    ----------
    bulk_modulus : K [Pa], > 0.

    Valid for every J > 0. It has no stored-energy partner in the hyperelastic update, which refuses it.
    """

    bulk_modulus: float


@pressure.register(DefaultHypoelastic)
def _(eos, volume_ratio, energy):
    return eos.bulk_modulus * math.log(volume_ratio), eos.bulk_modulus / volume_ratio, 0.0


@is_beyond_eos.register(DefaultHypoelastic)
def _(eos, volume_ratio):
    return False
