"""The flow stress of a point that goes on flowing as it does."""

from typing import NamedTuple

from core_models.laws import flow_stress


class ContinuedFlow(NamedTuple):
    """The tangent of a flow law, sigma_y = stress + slope (ep - strain). The points make it; no card names it.

    Parameters
    ----------
    stress, slope : [Pa]. strain : plastic strain where it touches the law [-].
    """

    stress: float
    slope: float
    strain: float

    is_internal = True


@flow_stress.register(ContinuedFlow)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    return flow.stress + flow.slope * (plastic_strain - flow.strain), 0.0, flow.slope, 0.0, 0.0
