"""Heat conduction in a slab and a cylinder whose surface temperature or flux jumps: Fourier series."""

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


def heated_slab(place: np.ndarray, fourier: float) -> np.ndarray:
    """k (T - T_0) / (q a) of a slab 0 <= x <= a, insulated at 0 and heated by the flux q at a, at x / a and Fo > 0.

        Fo + (3 (x / a)^2 - 1) / 6 - 2 / pi^2 sum_n (-1)^n / n^2 cos(n pi x / a) exp(-n^2 pi^2 Fo)

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 3.8.
    """
    place, n = np.asarray(place), np.arange(1, TERMS)
    weights = 2.0 / np.pi**2 * (-1.0) ** n / n**2 * np.exp(-((n * np.pi) ** 2) * fourier)
    return fourier + (3.0 * place**2 - 1.0) / 6.0 - np.cos(np.multiply.outer(place, n * np.pi)) @ weights


def cylinder(place: np.ndarray, fourier: float) -> np.ndarray:
    """(T - T_s) / (T_0 - T_s) of a long cylinder, at r / a and the Fourier number k t / (rho c a^2) > 0.

        sum_n 2 / (b_n J_1(b_n)) J_0(b_n r / a) exp(-b_n^2 Fo),  J_0(b_n) = 0

    Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959), 7.6.
    """
    b = jn_zeros(0, TERMS)
    weights = 2.0 / (b * j1(b)) * np.exp(-(b**2) * fourier)
    return j0(np.multiply.outer(np.asarray(place), b)) @ weights
