"""State of material points: one array per field, `None` for a field that no effect asks for."""

from typing import NamedTuple

import numpy as np

from core_models.dispatch import generic


class State(NamedTuple):
    """Arrays of n points; a field is `None` where the material does not need it.

    stress : Cauchy stress (n, 6) [Pa], components 11, 22, 33, 12, 23, 31.
    rotation (n, 3) : R in F = V R as axis * tan(angle / 4) (hypoelastic update).
    elastic_left_cauchy_green (n, 6) : its isochoric part, determinant 1 (hyperelastic update).
    equivalent_plastic_strain, hardening_variable, temperature [K], damage, internal_energy [J/m^3] : (n,).
    plastic_volume : ln J_p of the plastic part of the volume ratio (n,). porosity : volume fraction of voids (n,).
    back_stress (n, 6 terms) [Pa], deviators of the update's stress measure, those of a sum one after the other.
    """

    stress: np.ndarray
    rotation: np.ndarray | None
    elastic_left_cauchy_green: np.ndarray | None
    equivalent_plastic_strain: np.ndarray | None
    hardening_variable: np.ndarray | None
    temperature: np.ndarray | None
    damage: np.ndarray | None
    internal_energy: np.ndarray | None
    plastic_volume: np.ndarray | None
    porosity: np.ndarray | None
    back_stress: np.ndarray | None


class PointState(NamedTuple):
    """State of one point in registers: tensors and vectors as tuples, an absent scalar as 0."""

    stress: tuple
    rotation: tuple
    elastic_left_cauchy_green: tuple
    equivalent_plastic_strain: float
    hardening_variable: float
    temperature: float
    damage: float
    internal_energy: float


@generic
def read(field, i, absent):
    """Value of a scalar field at point i, or `absent` where the field does not exist."""


@read.register(np.ndarray)
def _(field, i, absent):
    return field[i]


@read.register(type(None))
def _(field, i, absent):
    return absent


@generic
def write(field, i, value):
    """Write a scalar field at point i; nothing where the field does not exist."""


@write.register(np.ndarray)
def _(field, i, value):
    field[i] = value


@write.register(type(None))
def _(field, i, value):
    return
