"""Elastica: a slender cantilever under a dead transverse force at its end."""

from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc


class TipState(NamedTuple):
    """Of the tip: deflection along the force and shortening along the axis, over the length; angle [rad]."""

    deflection: float
    shortening: float
    angle: float


def tip_state(load: float) -> TipState:
    """Tip of the inextensible cantilever under alpha = P L^2 / (E I), 0 < alpha.

        k^2 = (1 + sin phi) / 2, sin s = 1 / (k sqrt 2):  sqrt(alpha) = K(k) - F(s, k)
        v / L = 1 - 2 [E(k) - E(s, k)] / sqrt(alpha),  u / L = 1 - sqrt(2 sin phi / alpha)

    phi is the angle of the tip, K, F and E are elliptic integrals.
    Source: Bisshopp & Drucker, Quart. Appl. Math. 3 (1945) 272-275.
    """
    angle = brentq(lambda phi: _load(phi) - load, 1e-9, 0.5 * np.pi - 1e-12, xtol=1e-14)
    modulus, start = _modulus_and_start(angle)
    root = np.sqrt(load)
    deflection = 1.0 - 2.0 * (ellipe(modulus) - ellipeinc(start, modulus)) / root
    return TipState(float(deflection), float(1.0 - np.sqrt(2.0 * np.sin(angle) / load)), angle)


def _load(angle: float) -> float:
    modulus, start = _modulus_and_start(angle)
    return float(ellipk(modulus) - ellipkinc(start, modulus)) ** 2


def _modulus_and_start(angle: float) -> tuple[float, float]:
    """k^2, as scipy's elliptic integrals take it, and the amplitude s at the clamp."""
    square = 0.5 * (1.0 + np.sin(angle))
    return square, float(np.arcsin(np.sqrt(0.5 / square)))
