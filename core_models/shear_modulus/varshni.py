"""Varshni's shear modulus, that of the Mechanical Threshold Stress law."""

from typing import NamedTuple

from core_models.elementary import exponential
from core_models.laws import shear_modulus


class VarshniShearModulus(NamedTuple):
    """Varshni's shear modulus, that of the Mechanical Threshold Stress law: G = mu_0 - D / (exp(T_0 / T) - 1).

    Parameters
    ----------
    mu_0 : modulus at 0 K [Pa], > 0. D : its fall [Pa], >= 0. T_0 : [K], > 0.

    G is not below 1e-6 mu_0. Valid up to melting.
    Source: Varshni, Phys. Rev. B 2 (1970) 3952; Chen & Gray, Metall. Mater. Trans. A 27 (1996) 2994.
    """

    mu_0: float
    D: float
    T_0: float

    uses_temperature = True


SOFTEST = 1e-6  # relative to mu_0
LARGEST_EXPONENT = 100.0  # of T_0 / T: the modulus is that at 0 K
SMALLEST_EXPONENT = 1e-3


@shear_modulus.register(VarshniShearModulus)
def _(law, density_ratio, temperature, pressure, melting):
    warmest = law.T_0 / SMALLEST_EXPONENT
    kelvin = min(max(temperature, law.T_0 / LARGEST_EXPONENT), warmest)
    growth = exponential(law.T_0 / kelvin)
    modulus = law.mu_0 - law.D / (growth - 1.0)
    slope = -law.D * growth * law.T_0 / (kelvin * kelvin * (growth - 1.0) * (growth - 1.0))
    is_free = modulus > SOFTEST * law.mu_0 and kelvin == temperature
    return max(modulus, SOFTEST * law.mu_0), 0.0, slope if is_free else 0.0, 0.0, 0.0
