"""Points between the arrays of a `State` and the columns of a workspace."""

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.rows import (
    BACK_STRESS,
    BALANCE,
    DAMAGE,
    ELASTIC,
    ENERGY,
    F0,
    F1,
    HARDENING,
    LENGTH,
    PLASTIC_STRAIN,
    PLASTIC_VOLUME,
    POROSITY,
    ROTATION_0,
    ROTATION_1,
    STRESS,
    TEMPERATURE,
    get,
    get_symmetric,
    get_vector,
    put,
    put_symmetric,
)
from core_models.state import PointState

TOGETHER = 8  # points that are brought together: their numbers share a cache line of each row


@generic
def bring(field, start, count, rows, row):
    """Copy the numbers of points start ... to a row; 0 for a field that does not exist, whatever stood there."""


@bring.register(np.ndarray)
def _(field, start, count, rows, row):
    for k in range(count):
        put(rows, row, k, field[np.uint64(start + k)])


@bring.register(type(None))
def _(field, start, count, rows, row):
    for k in range(count):
        put(rows, row, k, 0.0)


@generic
def bring_if_any(field, start, count, rows, row):
    """Copy the numbers of points start ... to a row, if the field exists."""


@bring_if_any.register(np.ndarray)
def _(field, start, count, rows, row):
    bring(field, start, count, rows, row)


@bring_if_any.register(type(None))
def _(field, start, count, rows, row):
    return


@generic
def components(field):
    """Numbers of a point in a field of tensors; 0 if it does not exist."""


@components.register(np.ndarray)
def _(field):
    return field.shape[1]


@components.register(type(None))
def _(field):
    return 0


@generic
def bring_tensors(field, start, count, rows, row, size):
    """Copy tensors, or vectors, of points start ... to as many rows as they have components, if the field exists."""


@bring_tensors.register(np.ndarray)
def _(field, start, count, rows, row, size):
    whole = count - count % TOGETHER
    for first in range(0, whole, TOGETHER):
        for j in range(size):
            for k in range(TOGETHER):
                put(rows, row + j, first + k, field[np.uint64(start + first + k), np.uint64(j)])
    for k in range(whole, count):
        for j in range(size):
            put(rows, row + j, k, field[np.uint64(start + k), np.uint64(j)])


@bring_tensors.register(type(None))
def _(field, start, count, rows, row, size):
    return


@generic
def take(field, start, count, rows, row):
    """Copy a row to the numbers of points start ...; nothing where the field does not exist."""


@take.register(np.ndarray)
def _(field, start, count, rows, row):
    for k in range(count):
        field[np.uint64(start + k)] = get(rows, row, k)


@take.register(type(None))
def _(field, start, count, rows, row):
    return


@generic
def take_tensors(field, start, count, rows, row, size):
    """Copy rows to the tensors, or vectors, of points start ...; nothing where the field does not exist."""


@take_tensors.register(np.ndarray)
def _(field, start, count, rows, row, size):
    for k in range(count):
        for j in range(size):
            field[np.uint64(start + k), np.uint64(j)] = get(rows, row + j, k)


@take_tensors.register(type(None))
def _(field, start, count, rows, row, size):
    return


@inside_kernel
def gather(rows, start, count, f0, f1, lengths, old):
    """Bring points start ... to the rows: deformation gradients (n, 9), lengths (n,) and state before the step."""
    bring_tensors(f0, start, count, rows, F0, 9)
    bring_tensors(f1, start, count, rows, F1, 9)
    bring(lengths, start, count, rows, LENGTH)
    bring_tensors(old.stress, start, count, rows, STRESS, 6)
    bring_tensors(old.rotation, start, count, rows, ROTATION_0, 3)
    bring_tensors(old.elastic_left_cauchy_green, start, count, rows, ELASTIC, 6)
    bring(old.equivalent_plastic_strain, start, count, rows, PLASTIC_STRAIN)
    bring(old.hardening_variable, start, count, rows, HARDENING)
    bring(old.temperature, start, count, rows, TEMPERATURE)
    bring(old.damage, start, count, rows, DAMAGE)
    bring(old.internal_energy, start, count, rows, ENERGY)
    bring_if_any(old.plastic_volume, start, count, rows, PLASTIC_VOLUME)
    bring_if_any(old.porosity, start, count, rows, POROSITY)
    bring_tensors(old.back_stress, start, count, rows, BACK_STRESS, components(old.back_stress))


@inside_kernel
def scatter(rows, start, count, new, wave_speed, viscous):
    """Write the rows to points start ...: state after the step, wave speed (n,) and viscous pressure (n,)."""
    take_tensors(new.stress, start, count, rows, STRESS, 6)
    take_tensors(new.rotation, start, count, rows, ROTATION_1, 3)
    take_tensors(new.elastic_left_cauchy_green, start, count, rows, ELASTIC, 6)
    take(new.equivalent_plastic_strain, start, count, rows, PLASTIC_STRAIN)
    take(new.hardening_variable, start, count, rows, HARDENING)
    take(new.temperature, start, count, rows, TEMPERATURE)
    take(new.damage, start, count, rows, DAMAGE)
    take(new.internal_energy, start, count, rows, ENERGY)
    take(new.plastic_volume, start, count, rows, PLASTIC_VOLUME)
    take(new.porosity, start, count, rows, POROSITY)
    take_tensors(new.back_stress, start, count, rows, BACK_STRESS, components(new.back_stress))
    take(wave_speed, start, count, rows, BALANCE)
    take(viscous, start, count, rows, BALANCE + 1)


@inside_kernel
def get_point(rows, k):
    """State of point k; its rotation is that before the step."""
    return PointState(
        get_symmetric(rows, STRESS, k),
        get_vector(rows, ROTATION_0, k),
        get_symmetric(rows, ELASTIC, k),
        get(rows, PLASTIC_STRAIN, k),
        get(rows, HARDENING, k),
        get(rows, TEMPERATURE, k),
        get(rows, DAMAGE, k),
        get(rows, ENERGY, k),
    )


@inside_kernel
def put_point(rows, k, point):
    """Write the state of point k, but for its rotation, which the prediction writes."""
    put_symmetric(rows, STRESS, k, point.stress)
    put_symmetric(rows, ELASTIC, k, point.elastic_left_cauchy_green)
    put(rows, PLASTIC_STRAIN, k, point.equivalent_plastic_strain)
    put(rows, HARDENING, k, point.hardening_variable)
    put(rows, TEMPERATURE, k, point.temperature)
    put(rows, DAMAGE, k, point.damage)
    put(rows, ENERGY, k, point.internal_energy)
