"""Heat conduction into a slab and into a cylinder whose surface temperature jumps: Fourier series."""

import numpy as np
from scipy.special import j0, j1, jn_zeros

TERMS = 200


def slab(place: np.ndarray, fourier: float) -> np.ndarray:
    """(T - T_s) / (T_0 - T_s) of a slab |x| <= a, at x / a and the Fourier number k t / (rho c a^2) > 0.

        sum_n 2 (-1)^n / b_n cos(b_n x / a) exp(-b_n^2 Fo),  b_n = (n + 1/2) pi

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 3.3.
    """
    n = np.arange(TERMS)
    b = (n + 0.5) * np.pi
    weights = 2.0 * (-1.0) ** n / b * np.exp(-(b**2) * fourier)
    return np.cos(np.multiply.outer(np.asarray(place), b)) @ weights


def cylinder(place: np.ndarray, fourier: float) -> np.ndarray:
    """(T - T_s) / (T_0 - T_s) of a long cylinder, at r / a and the Fourier number k t / (rho c a^2) > 0.

        sum_n 2 / (b_n J_1(b_n)) J_0(b_n r / a) exp(-b_n^2 Fo),  J_0(b_n) = 0

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 7.6.
    """
    b = jn_zeros(0, TERMS)
    weights = 2.0 / (b * j1(b)) * np.exp(-(b**2) * fourier)
    return j0(np.multiply.outer(np.asarray(place), b)) @ weights
