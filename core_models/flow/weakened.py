"""A flow law of which damage has left a share."""

from typing import NamedTuple

from core_models.laws import evolve_hardening, flow_stress, weakened


class WeakenedFlow(NamedTuple):
    """A share of a flow law's strength: sigma_y = share sigma_y(law). The points make it; no card names it.

    Parameters
    ----------
    law : the flow law. share : in [0, 1] [-].
    """

    law: tuple
    share: float

    is_internal = True


@weakened.otherwise
def _(cause, flow, share):
    return WeakenedFlow(flow, share)


@flow_stress.register(WeakenedFlow)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    stress, by_variable, by_strain, by_rate, by_temperature = flow_stress(
        flow.law, hardening_variable, plastic_strain, plastic_rate, temperature
    )
    share = flow.share
    return stress * share, by_variable * share, by_strain * share, by_rate * share, by_temperature * share


@evolve_hardening.register(WeakenedFlow)
def _(flow, hardening_variable, strain_increment, plastic_rate, temperature):
    return evolve_hardening(flow.law, hardening_variable, strain_increment, plastic_rate, temperature)
