"""Axis-aligned displacement of a unit square or cube: every component is a standing wave along its own axis."""

import numpy as np

from studies.verification.closed_forms.manufactured import ManufacturedSolution

DENSITY, YOUNG, POISSON = 1.0, 1.0e4, 0.3
AMPLITUDE = 0.05  # m
FREQUENCY = np.pi * np.sqrt(YOUNG / DENSITY)  # rad/s
SHEAR = 0.5 * YOUNG / (1.0 + POISSON)
LAME = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON))
PHASES = {2: np.array([0.0, np.pi]), 3: np.array([0.0, 2.0 * np.pi / 3.0, 4.0 * np.pi / 3.0])}
PERIOD = 2.0 * np.pi / FREQUENCY


def displacement(positions: np.ndarray, time: float) -> np.ndarray:
    """u_i = A sin(pi X_i) sin(c pi t + phi_i) [m]."""
    return AMPLITUDE * np.sin(np.pi * positions) * np.sin(_angles(positions, time))


def velocity(positions: np.ndarray, time: float) -> np.ndarray:
    """v_i = A c pi sin(pi X_i) cos(c pi t + phi_i) [m/s]."""
    return AMPLITUDE * FREQUENCY * np.sin(np.pi * positions) * np.cos(_angles(positions, time))


def body_force(positions: np.ndarray, time: float) -> np.ndarray:
    """b_i = pi^2 u_i [mu/rho0 - c^2 - (lambda (ln J - 1) - mu) / (rho0 F_ii^2)], F_ii = 1 + du_i/dX_i [m/s^2]."""
    stretch = 1.0 + np.pi * AMPLITUDE * np.cos(np.pi * positions) * np.sin(_angles(positions, time))
    logarithm = np.log(np.prod(stretch, axis=1))[:, None]
    elastic = SHEAR - (LAME * (logarithm - 1.0) - SHEAR) / stretch**2
    return displacement(positions, time) * (np.pi**2 * elastic / DENSITY - FREQUENCY**2)


def _angles(positions: np.ndarray, time: float) -> np.ndarray:
    return FREQUENCY * time + PHASES[positions.shape[1]]


AXIS_ALIGNED = ManufacturedSolution(DENSITY, YOUNG, POISSON, PERIOD, displacement, velocity, body_force)
"""Unit square (plane strain, phases 0 and pi) or cube (phases 0, 2 pi/3, 4 pi/3) between smooth walls.

In three dimensions it starts displaced, moving and stressed.
Source: Wallstedt & Guilkey, J. Comput. Phys. 227 (2008) 9628-9642.
"""
