"""Perfect plasticity."""

from typing import NamedTuple

from core_models.laws import flow_stress


class PerfectPlasticity(NamedTuple):
    """Perfect plasticity: sigma_y = yield_stress.

    Parameters
    ----------
    yield_stress : [Pa], > 0.

    Source: Prandtl (1924) and Reuss (1930); Simo & Hughes, Computational Inelasticity (1998), section 2.2.
    """

    yield_stress: float


@flow_stress.register(PerfectPlasticity)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    return flow.yield_stress, 0.0, 0.0, 0.0, 0.0
