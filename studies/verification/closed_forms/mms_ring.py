"""Expanding ring: radial breathing of a ring without Poisson's effect, its rims free of traction."""

import numpy as np

from studies.verification.closed_forms.manufactured import ManufacturedSolution

INNER, OUTER = 0.4, 0.6  # m
DENSITY, YOUNG, POISSON = 1000.0, 1.0e7, 0.0
AMPLITUDE = 0.1
FREQUENCY = np.pi * np.sqrt(YOUNG / DENSITY)  # rad/s; free of the rims' radii, unlike some published inputs
SHEAR = 0.5 * YOUNG

_SCALE = OUTER**2 * (OUTER - 3.0 * INNER)
CONSTANT = -6.0 * INNER * OUTER / _SCALE
LINEAR = 3.0 * (OUTER + INNER) / _SCALE  # 1/m
SQUARE = -2.0 / _SCALE  # 1/m^2


def displacement(positions: np.ndarray, time: float) -> np.ndarray:
    """u = X A sin(c pi t) g(R), g = c3 R^2 + c2 R + c1 such that dr/dR = 1 on both rims [m]."""
    radius = _radius(positions)
    return positions * (AMPLITUDE * np.sin(FREQUENCY * time) * _shape(radius))[:, None]


def velocity(positions: np.ndarray, time: float) -> np.ndarray:
    """v = X A c pi cos(c pi t) g(R) [m/s]."""
    radius = _radius(positions)
    return positions * (AMPLITUDE * FREQUENCY * np.cos(FREQUENCY * time) * _shape(radius))[:, None]


def body_force(positions: np.ndarray, time: float) -> np.ndarray:
    """b = a - [dP_rr/dR + (P_rr - P_tt) / R] e_r / rho0, P_ii = mu (F_ii - 1/F_ii), F = (dr/dR, r/R) [m/s^2]."""
    radius = _radius(positions)
    swing = AMPLITUDE * np.sin(FREQUENCY * time)
    hoop = 1.0 + swing * _shape(radius)
    radial = 1.0 + swing * ((3.0 * SQUARE * radius + 2.0 * LINEAR) * radius + CONSTANT)
    curvature = swing * (6.0 * SQUARE * radius + 2.0 * LINEAR)
    gradient = SHEAR * curvature * (1.0 + radial**-2)
    apart = SHEAR * (radial - 1.0 / radial - hoop + 1.0 / hoop)
    acceleration = -(FREQUENCY**2) * swing * _shape(radius)
    return positions * (acceleration - (gradient + apart / radius) / (DENSITY * radius))[:, None]


def _radius(positions: np.ndarray) -> np.ndarray:
    return np.sqrt(positions[:, 0] ** 2 + positions[:, 1] ** 2)


def _shape(radius: np.ndarray) -> np.ndarray:
    return (SQUARE * radius + LINEAR) * radius + CONSTANT


RING = ManufacturedSolution(DENSITY, YOUNG, POISSON, 0.02, displacement, velocity, body_force)
"""Ring 0.4 <= R <= 0.6 m in plane strain, radial displacements up to 4 % of the radius; one period is 0.02 s.

Source: Wallstedt & Guilkey, J. Comput. Phys. 227 (2008) 9628-9642.
"""
