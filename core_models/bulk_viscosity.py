"""Bulk viscosity: one form, shared by every method."""

import math
from typing import Any, NamedTuple

from core_models.dispatch import generic
from core_models.errors import SceneError


class BulkViscosity(NamedTuple):
    """Artificial bulk viscosity in compression: q = rho h |tr d| (linear c + quadratic^2 h |tr d|) for tr d < 0.

    Parameters
    ----------
    linear, quadratic : coefficients [-], >= 0 (0.06 and 1.2 are usual).

    h is the element's or cell's current size [m], c the wave speed [m/s]. q is a pressure on top of the mean stress;
    its work enters the internal energy of the equation of state; the temperature counts plastic work only.
    Source: von Neumann & Richtmyer, J. Appl. Phys. 21 (1950) 232; Landshoff, LANL LA-1930 (1955).
    """

    linear: float = 0.06
    quadratic: float = 1.2


def check_viscosity(viscosity: Any) -> None:
    """Refuse what is neither a BulkViscosity with finite coefficients from 0 nor None; SceneError."""
    if viscosity is None:
        return
    if not isinstance(viscosity, BulkViscosity):
        raise SceneError(
            f"viscosity = {viscosity!r} is no bulk viscosity: give core_models.bulk_viscosity.BulkViscosity(linear, "
            "quadratic), or None"
        )
    for name, value in viscosity._asdict().items():
        if not (isinstance(value, int | float) and 0.0 <= value < math.inf):
            raise SceneError(f"viscosity: {name} = {value!r} is out of range: give a finite number from 0")


@generic
def viscous_pressure(viscosity, density, length, wave_speed, volume_rate):
    """Viscous pressure [Pa], >= 0, for density [kg/m^3], length [m], wave speed [m/s] and tr d [1/s]."""


@viscous_pressure.register(BulkViscosity)
def _(viscosity, density, length, wave_speed, volume_rate):
    if volume_rate >= 0.0:
        return 0.0
    speed = -volume_rate * length
    return (
        density * speed * (viscosity.linear * wave_speed + viscosity.quadratic * viscosity.quadratic * speed)
    )


@viscous_pressure.register(type(None))
def _(viscosity, density, length, wave_speed, volume_rate):
    return 0.0


@generic
def damped_step_factor(viscosity, relative_pressure):
    """Factor on the stable step of central differences, sqrt(1 + x^2) - x, for the viscosity's damping ratio x.

    `relative_pressure` is the viscous pressure over rho c^2; it tells how fast the compression is.
    """


@damped_step_factor.register(BulkViscosity)
def _(viscosity, relative_pressure):
    square = (
        viscosity.linear * viscosity.linear
        + 4.0 * viscosity.quadratic * viscosity.quadratic * relative_pressure
    )
    ratio = 0.5 * (viscosity.linear + math.sqrt(square))
    return math.sqrt(1.0 + ratio * ratio) - ratio


@damped_step_factor.register(type(None))
def _(viscosity, relative_pressure):
    return 1.0
