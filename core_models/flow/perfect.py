"""Perfect plasticity."""

from typing import NamedTuple

from core_models.laws import flow_stress


class PerfectPlasticity(NamedTuple):
    """Perfect plasticity: sigma_y = yield_stress.

    Parameters
    ----------
    yield_stress : [Pa], > 0.
    """

    yield_stress: float


@flow_stress.register(PerfectPlasticity)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    return flow.yield_stress, 0.0, 0.0, 0.0, 0.0
