"""The one kernel that is compiled for each material: advance a range of points by one step."""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import CHUNK, inside_kernel, material_kernel
from core_models.laws import predict
from core_models.state import load_point, read, store_after, write, write_symmetric, write_tensor
from core_models.status import NOT_FINITE, OK
from core_models.tensors import load_tensor
from core_models.updates.balance import complete_point
from core_models.updates.prediction import (
    CORRECTION_SIZE,
    PREDICTION_SIZE,
    correct,
    load_correction,
    load_prediction,
    store_prediction,
)

WORK, PLASTIC, VISCOUS, SPEED, PRESSURE = 0, 1, 2, 3, 4


class Workspace(NamedTuple):
    """What the parts of a step leave for each other: one row per point of a chunk."""

    predictions: np.ndarray
    corrections: np.ndarray
    statuses: np.ndarray


def make_workspace() -> Workspace:
    """A workspace for one thread."""
    return Workspace(
        np.zeros((CHUNK, PREDICTION_SIZE)),
        np.zeros((CHUNK, CORRECTION_SIZE)),
        np.zeros(CHUNK, dtype=np.int64),
    )


@material_kernel
def advance_points(
    first,
    last,
    workspace,
    model,
    viscosity,
    f0,
    f1,
    dt,
    volumes,
    lengths,
    old,
    new,
    wave_speed,
    viscous,
    sums,
    failures,
):
    """Advance the points of chunks first ... last-1 and sum their work chunk by chunk.

    Parameters
    ----------
    first, last : range of chunks of CHUNK points. workspace : the thread's own `Workspace`.
    model, viscosity : laws. f0, f1 : (n, 3, 3) deformation gradient before and after. dt : [s].
    volumes : (n,) reference volumes [m^3]. lengths : (n,) characteristic lengths [m].
    old, new : `State`. wave_speed (n,) [m/s] and viscous (n,) [Pa] or None are written.
    sums : (chunks, 5) stress work, plastic and viscous dissipation [J], largest wave speed [m/s] and viscous
    pressure [Pa]; failures : (chunks, 2) status and point.
    """
    n = f1.shape[0]
    predictions, corrections, statuses = workspace
    over_dt = 1.0 / dt
    for chunk in range(first, last):
        start = chunk * CHUNK
        count = min(CHUNK, n - start)
        for k in range(count):
            i = start + k
            statuses[k], prediction, rotation, left_stretch = predict(
                model.update, model, load_tensor(f0, i), load_tensor(f1, i), load_point(old, i)
            )
            store_prediction(predictions, k, prediction)
            write_tensor(new.rotation, i, rotation)
            write_symmetric(new.left_stretch, i, left_stretch)
        for k in range(count):
            if statuses[k] == OK:
                statuses[k] = correct(model, predictions, corrections, k, over_dt, old, start + k)
        for column in range(sums.shape[1]):
            sums[chunk, column] = 0.0
        failures[chunk, 0] = OK
        for k in range(count):
            i = start + k
            if statuses[k] == OK:
                point, balance = complete_point(
                    model, viscosity, load_prediction(predictions, k), load_correction(corrections, k), dt,
                    read(lengths, i, 0.0), load_point(old, i),
                )  # fmt: skip
                store_after(new, i, point)
                add_balance(sums, chunk, volumes[i], balance)
                wave_speed[i] = balance.wave_speed
                write(viscous, i, balance.viscous_pressure)
                energies = balance.stress_work + balance.viscous
                if not math.isfinite(energies + balance.wave_speed + point.temperature + point.damage):
                    statuses[k] = NOT_FINITE
            if statuses[k] != OK and failures[chunk, 0] == OK:
                failures[chunk, 0] = statuses[k]
                failures[chunk, 1] = i


@inside_kernel
def add_balance(sums, chunk, volume, balance):
    """Add what a step did at a point of a volume to the sums of its chunk."""
    sums[chunk, WORK] += volume * balance.stress_work
    sums[chunk, PLASTIC] += volume * balance.plastic
    sums[chunk, VISCOUS] += volume * balance.viscous
    sums[chunk, SPEED] = max(sums[chunk, SPEED], balance.wave_speed)
    sums[chunk, PRESSURE] = max(sums[chunk, PRESSURE], balance.viscous_pressure)
