"""Linear isotropic hardening."""

from typing import NamedTuple

from core_models.laws import flow_stress


class LinearHardening(NamedTuple):
    """Linear isotropic hardening: sigma_y = yield_stress + hardening_modulus ep.

    Parameters
    ----------
    yield_stress : [Pa], > 0. hardening_modulus : d sigma_y / d ep [Pa], >= 0.

    Source: Simo & Hughes, Computational Inelasticity (1998), ch. 1; Uintah's `isotropic_hardening`.
    """

    yield_stress: float
    hardening_modulus: float


@flow_stress.register(LinearHardening)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    stress = flow.yield_stress + flow.hardening_modulus * plastic_strain
    return stress, 0.0, flow.hardening_modulus, 0.0, 0.0
