"""Points between the arrays of a `State` and the columns of a workspace."""

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.rows import (
    DAMAGE,
    ELASTIC,
    ENERGY,
    F0,
    F1,
    HARDENING,
    LEFT_STRETCH,
    LENGTH,
    PLASTIC_STRAIN,
    ROTATION,
    STRESS,
    TEMPERATURE,
    get,
    get_symmetric,
    get_tensor,
    put,
    put_symmetric,
    put_tensor,
)
from core_models.state import PointState, store_point
from core_models.tensors import load_symmetric, load_tensor


@generic
def bring(field, i, rows, row, k):
    """Copy the number of point i to column k of a row; 0 for a field that does not exist, whatever stood there."""


@bring.register(np.ndarray)
def _(field, i, rows, row, k):
    put(rows, row, k, field[i])


@bring.register(type(None))
def _(field, i, rows, row, k):
    put(rows, row, k, 0.0)


@generic
def bring_symmetric(field, i, rows, row, k):
    """Copy the symmetric tensor of point i to column k of six rows, if the field exists."""


@bring_symmetric.register(np.ndarray)
def _(field, i, rows, row, k):
    put_symmetric(rows, row, k, load_symmetric(field, i))


@bring_symmetric.register(type(None))
def _(field, i, rows, row, k):
    return


@generic
def bring_tensor(field, i, rows, row, k):
    """Copy the tensor of point i to column k of nine rows, if the field exists."""


@bring_tensor.register(np.ndarray)
def _(field, i, rows, row, k):
    put_tensor(rows, row, k, load_tensor(field, i))


@bring_tensor.register(type(None))
def _(field, i, rows, row, k):
    return


@inside_kernel
def gather(rows, k, f0, f1, lengths, old, i):
    """Bring point i to column k of the rows."""
    bring_tensor(f0, i, rows, F0, k)
    bring_tensor(f1, i, rows, F1, k)
    bring(lengths, i, rows, LENGTH, k)
    bring_symmetric(old.stress, i, rows, STRESS, k)
    bring_tensor(old.rotation, i, rows, ROTATION, k)
    bring_symmetric(old.left_stretch, i, rows, LEFT_STRETCH, k)
    bring_symmetric(old.elastic_left_cauchy_green, i, rows, ELASTIC, k)
    bring(old.equivalent_plastic_strain, i, rows, PLASTIC_STRAIN, k)
    bring(old.hardening_variable, i, rows, HARDENING, k)
    bring(old.temperature, i, rows, TEMPERATURE, k)
    bring(old.damage, i, rows, DAMAGE, k)
    bring(old.internal_energy, i, rows, ENERGY, k)


@inside_kernel
def scatter(rows, k, new, i):
    """Write column k of the rows to the state of point i."""
    store_point(new, i, get_point(rows, k))


@inside_kernel
def get_point(rows, k):
    """State of point k."""
    return PointState(
        get_symmetric(rows, STRESS, k),
        get_tensor(rows, ROTATION, k),
        get_symmetric(rows, LEFT_STRETCH, k),
        get_symmetric(rows, ELASTIC, k),
        get(rows, PLASTIC_STRAIN, k),
        get(rows, HARDENING, k),
        get(rows, TEMPERATURE, k),
        get(rows, DAMAGE, k),
        get(rows, ENERGY, k),
    )


@inside_kernel
def put_point(rows, k, point):
    """Write the state of point k, but for rotation and stretch, which the prediction writes."""
    put_symmetric(rows, STRESS, k, point.stress)
    put_symmetric(rows, ELASTIC, k, point.elastic_left_cauchy_green)
    put(rows, PLASTIC_STRAIN, k, point.equivalent_plastic_strain)
    put(rows, HARDENING, k, point.hardening_variable)
    put(rows, TEMPERATURE, k, point.temperature)
    put(rows, DAMAGE, k, point.damage)
    put(rows, ENERGY, k, point.internal_energy)
