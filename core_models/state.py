"""State of material points: one array per field, `None` for a field that no effect asks for."""

from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.tensors import IDENTITY, load_symmetric, load_tensor, store_symmetric, store_tensor


class State(NamedTuple):
    """Arrays of n points; a field is `None` where the material does not need it.

    stress : Cauchy stress (n, 6) [Pa], components 11, 22, 33, 12, 23, 31.
    rotation (n, 3, 3), left_stretch (n, 6) : R and V in F = V R (hypoelastic update).
    elastic_left_cauchy_green (n, 6) : its isochoric part, determinant 1 (hyperelastic update).
    equivalent_plastic_strain, hardening_variable, temperature [K], damage, internal_energy [J/m^3] : (n,).
    """

    stress: np.ndarray
    rotation: np.ndarray | None
    left_stretch: np.ndarray | None
    elastic_left_cauchy_green: np.ndarray | None
    equivalent_plastic_strain: np.ndarray | None
    hardening_variable: np.ndarray | None
    temperature: np.ndarray | None
    damage: np.ndarray | None
    internal_energy: np.ndarray | None


class PointState(NamedTuple):
    """State of one point in registers: tensors as tuples, an absent field as its neutral value."""

    stress: tuple
    rotation: tuple
    left_stretch: tuple
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


@generic
def read_symmetric(field, i):
    """Symmetric tensor at point i, the identity where the field does not exist."""


@read_symmetric.register(np.ndarray)
def _(field, i):
    return load_symmetric(field, i)


@read_symmetric.register(type(None))
def _(field, i):
    return (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)


@generic
def write_symmetric(field, i, value):
    """Write a symmetric tensor at point i; nothing where the field does not exist."""


@write_symmetric.register(np.ndarray)
def _(field, i, value):
    store_symmetric(field, i, value)


@write_symmetric.register(type(None))
def _(field, i, value):
    return


@generic
def read_tensor(field, i):
    """Tensor at point i, the identity where the field does not exist."""


@read_tensor.register(np.ndarray)
def _(field, i):
    return load_tensor(field, i)


@read_tensor.register(type(None))
def _(field, i):
    return IDENTITY


@generic
def write_tensor(field, i, value):
    """Write a tensor at point i; nothing where the field does not exist."""


@write_tensor.register(np.ndarray)
def _(field, i, value):
    store_tensor(field, i, value)


@write_tensor.register(type(None))
def _(field, i, value):
    return


@inside_kernel
def load_point(state, i):
    """State of point i."""
    return PointState(
        load_symmetric(state.stress, i),
        read_tensor(state.rotation, i),
        read_symmetric(state.left_stretch, i),
        read_symmetric(state.elastic_left_cauchy_green, i),
        read(state.equivalent_plastic_strain, i, 0.0),
        read(state.hardening_variable, i, 0.0),
        read(state.temperature, i, 0.0),
        read(state.damage, i, 0.0),
        read(state.internal_energy, i, 0.0),
    )


@inside_kernel
def store_point(state, i, point):
    """Write the state of point i."""
    store_symmetric(state.stress, i, point.stress)
    write_tensor(state.rotation, i, point.rotation)
    write_symmetric(state.left_stretch, i, point.left_stretch)
    write_symmetric(state.elastic_left_cauchy_green, i, point.elastic_left_cauchy_green)
    write(state.equivalent_plastic_strain, i, point.equivalent_plastic_strain)
    write(state.hardening_variable, i, point.hardening_variable)
    write(state.temperature, i, point.temperature)
    write(state.damage, i, point.damage)
    write(state.internal_energy, i, point.internal_energy)
