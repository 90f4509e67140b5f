"""Closed forms of limit loads and of the cyclic bar."""

import math
from collections.abc import Iterable

CYLINDER, SPHERE = 1, 2
"""Principal directions around: one hoop direction, or two."""


def friction_ratio(friction: float) -> float:
    """N = (1 + sin phi) / (1 - sin phi) of an angle of friction [degree]."""
    s = math.sin(math.radians(friction))
    return (1.0 + s) / (1.0 - s)


def cavity_pressure(
    cohesion: float, friction: float, inner: float, outer: float, around: int = CYLINDER
) -> float:
    """Inner pressure [Pa] at which a thick wall between two radii [m] flows all through, by Mohr-Coulomb.

        p = c cot(phi) {(b / a)^[k (N - 1) / N] - 1},   for phi = 0:  p = 2 k c ln(b / a)

    cohesion : c [Pa]. friction : phi [degree], from 0 to below 90. around : k, `CYLINDER` in plane strain or `SPHERE`.
    With phi = 0 it is Tresca's condition of flow stress 2 c, and von Mises' with 2 c = 2 sigma_y / sqrt(3) in the
    cylinder and sigma_y in the sphere.
    Source: Hill, The Mathematical Theory of Plasticity (1950), chapter 5; Chadwick, Q. J. Mech. Appl. Math. 12
    (1959) 52.
    """
    if friction == 0.0:
        return 2.0 * around * cohesion * math.log(outer / inner)
    ratio = friction_ratio(friction)
    power = around * (ratio - 1.0) / ratio
    return cohesion / math.tan(math.radians(friction)) * ((outer / inner) ** power - 1.0)


def bearing_factor(friction: float) -> float:
    """N_c: limit pressure of a strip footing on weightless ground over its cohesion; friction phi [degree].

        N_c = [N exp(pi tan phi) - 1] cot phi,   for phi = 0:  2 + pi

    Source: Prandtl, Nachr. Ges. Wiss. Göttingen (1920) 74.
    """
    if friction == 0.0:
        return 2.0 + math.pi
    slope = math.tan(math.radians(friction))
    return (friction_ratio(friction) * math.exp(math.pi * slope) - 1.0) / slope


def kinematic_path(
    young: float, yield_stress: float, modulus: float, strains: Iterable[float]
) -> list[float]:
    """Uniaxial stresses [Pa] of a bar with linear kinematic hardening along a path of strains.

        |sigma - alpha| <= sigma_y,   d alpha = C d e_p;   slope of the flowing bar E C / (E + C)

    young : E, modulus : C, yield_stress : sigma_y [Pa].
    """
    stress, back, last, path = 0.0, 0.0, 0.0, []
    for strain in strains:
        stress += young * (strain - last)
        excess = abs(stress - back) - yield_stress
        if excess > 0.0:
            plastic = math.copysign(excess / (young + modulus), stress - back)
            stress -= young * plastic
            back += modulus * plastic
        last = strain
        path.append(stress)
    return path
