"""Generalized vortex: every circle of an annulus turns to and fro by its own angle, without change of volume."""

import numpy as np

from studies.verification.closed_forms.manufactured import ManufacturedSolution

INNER, OUTER = 0.75, 1.25  # m
DENSITY, YOUNG, POISSON = 1000.0, 1000.0, 0.3
AMPLITUDE = 1.0  # rad
FREQUENCY = np.pi * np.sqrt(YOUNG / DENSITY)  # rad/s
SHEAR = 0.5 * YOUNG / (1.0 + POISSON)


def displacement(positions: np.ndarray, time: float) -> np.ndarray:
    """u = Q(alpha) X - X with alpha = A sin(c pi t) h(R), h = 1 - 32 (R-1)^2 + 256 (R-1)^4 [m]."""
    radius = _radius(positions)
    return _turned(positions, AMPLITUDE * np.sin(FREQUENCY * time) * _bump(radius)) - positions


def velocity(positions: np.ndarray, time: float) -> np.ndarray:
    """v = alpha' e_z x x [m/s]."""
    radius = _radius(positions)
    rate = AMPLITUDE * FREQUENCY * np.cos(FREQUENCY * time) * _bump(radius)
    place = positions + displacement(positions, time)
    return rate[:, None] * _left(place)


def body_force(positions: np.ndarray, time: float) -> np.ndarray:
    """Body force along e_r and e_theta of the *current* place [m/s^2].

    b_r = - R alpha'^2 + R (mu / rho0) (A sin(c pi t) h')^2,  with h' = 64 (R-1) (4R-3) (4R-5)
    b_theta = - A sin(c pi t) [R c^2 pi^2 h + 64 (mu / rho0) (96 R^3 - 240 R^2 + 188 R - 45)]
    """
    radius = _radius(positions)
    swing, rate = AMPLITUDE * np.sin(FREQUENCY * time), AMPLITUDE * FREQUENCY * np.cos(FREQUENCY * time)
    slope = 64.0 * (radius - 1.0) * (4.0 * radius - 3.0) * (4.0 * radius - 5.0)
    cubic = ((96.0 * radius - 240.0) * radius + 188.0) * radius - 45.0
    stiffness = SHEAR / DENSITY
    radial = radius * (stiffness * (swing * slope) ** 2 - (rate * _bump(radius)) ** 2)
    hoop = -swing * (radius * FREQUENCY**2 * _bump(radius) + 64.0 * stiffness * cubic)
    outward = (positions + displacement(positions, time)) / radius[:, None]
    return radial[:, None] * outward + hoop[:, None] * _left(outward)


def _radius(positions: np.ndarray) -> np.ndarray:
    return np.sqrt(positions[:, 0] ** 2 + positions[:, 1] ** 2)


def _bump(radius: np.ndarray) -> np.ndarray:
    square = (radius - 1.0) ** 2
    return 1.0 + square * (256.0 * square - 32.0)


def _left(vectors: np.ndarray) -> np.ndarray:
    """The vectors turned to the left by a right angle."""
    return np.column_stack([-vectors[:, 1], vectors[:, 0]])


def _turned(vectors: np.ndarray, angle: np.ndarray) -> np.ndarray:
    return np.cos(angle)[:, None] * vectors + np.sin(angle)[:, None] * _left(vectors)


VORTEX = ManufacturedSolution(DENSITY, YOUNG, POISSON, 0.25, displacement, velocity, body_force)
"""Annulus 0.75 <= R <= 1.25 m in plane strain, J = 1 everywhere, rims at rest and free of traction; back at t = 1 s.

It is compared at 0.25 s, at 71 % of the largest rotation and a shear of 3.9, where practical sizes converge already.
Source: Kamojjala, Brannon et al., Eng. Comput. 31 (2015) 27-44; Brannon, Kamojjala, Sadeghirad (2011).
"""
