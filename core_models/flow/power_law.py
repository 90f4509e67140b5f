"""Power-law isotropic hardening."""

from typing import NamedTuple

from core_models.laws import flow_stress


class PowerLaw(NamedTuple):
    """Power-law hardening: sigma_y = yield_stress (1 + ep / reference_strain)^exponent.

    Parameters
    ----------
    yield_stress : [Pa], > 0. reference_strain : [-], > 0. exponent : [-], 0 <= exponent <= 1.

    The slope is finite at ep = 0. Source: Needleman, J. Mech. Phys. Solids 20 (1972) 111 (Swift form).
    """

    yield_stress: float
    reference_strain: float
    exponent: float


@flow_stress.register(PowerLaw)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    base = 1.0 + plastic_strain / flow.reference_strain
    stress = flow.yield_stress * base**flow.exponent
    return stress, 0.0, flow.exponent * stress / (base * flow.reference_strain), 0.0, 0.0
