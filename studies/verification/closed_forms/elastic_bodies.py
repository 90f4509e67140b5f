"""Small strains of simple elastic bodies: standing wave in a bar, stress in a spinning disk."""

import numpy as np


def bar_period(length: float, modulus: float, density: float) -> float:
    """Period of the first axial mode of a bar, clamped at one end and free at the other: T = 4 L sqrt(rho / M) [s].

    modulus : M [Pa], Young's for a thin bar, that of uniaxial strain for a layer.
    """
    return 4.0 * length * np.sqrt(density / modulus)


def spinning_disk(
    radii: np.ndarray, radius: float, spin: float, density: float, young: float, poisson: float
):
    """Radial displacement [m], radial and hoop stress [Pa] of a long cylinder that spins, in plane strain.

        s_r = (3 - 2 nu) / (8 (1 - nu)) rho w^2 (R^2 - r^2)
        s_t = rho w^2 / (8 (1 - nu)) [(3 - 2 nu) R^2 - (1 + 2 nu) r^2],  u = r (1 + nu) / E [(1 - nu) s_t - nu s_r]

    radii : r [m], up to `radius`. spin : w [rad/s].
    Source: Timoshenko & Goodier, Theory of Elasticity (1970), sec. 32, with nu / (1 - nu) for nu.
    """
    load = density * spin**2 / (8.0 * (1.0 - poisson))
    radial = load * (3.0 - 2.0 * poisson) * (radius**2 - radii**2)
    hoop = load * ((3.0 - 2.0 * poisson) * radius**2 - (1.0 + 2.0 * poisson) * radii**2)
    strain = (1.0 + poisson) / young * ((1.0 - poisson) * hoop - poisson * radial)
    return radii * strain, radial, hoop
