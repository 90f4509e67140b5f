"""The one kernel that is compiled for each material: advance a range of points by one step."""

import math

from core_models.columns import gather, get_point, put_point, scatter
from core_models.compilation import CHUNK, inside_kernel, material_kernel
from core_models.laws import predict, predict_carefully
from core_models.rows import (
    F0,
    F1,
    LEFT_STRETCH,
    LENGTH,
    ROTATION,
    get,
    get_tensor,
    put_symmetric,
    put_tensor,
)
from core_models.state import load_point, write
from core_models.status import NOT_FINITE, OK, UNSETTLED
from core_models.tensors import load_tensor
from core_models.updates.balance import complete_point, get_balance, put_balance
from core_models.updates.prediction import (
    correct,
    get_correction,
    get_prediction,
    put_correction,
    put_prediction,
    search,
)

WORK, PLASTIC, VISCOUS, SPEED, PRESSURE = 0, 1, 2, 3, 4


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
    first, last : range of chunks of CHUNK points. workspace : the thread's own `Workspace` (core_models.rows).
    model, viscosity : laws. f0, f1 : (n, 3, 3) deformation gradient before and after. dt : [s].
    volumes : (n,) reference volumes [m^3]. lengths : (n,) characteristic lengths [m].
    old, new : `State`. wave_speed (n,) [m/s] and viscous (n,) [Pa] or None are written.
    sums : (chunks, 5) stress work, plastic and viscous dissipation [J], largest wave speed [m/s] and viscous
    pressure [Pa]; failures : (chunks, 2) status and point.
    """
    n = f1.shape[0]
    rows, statuses = workspace
    over_dt = 1.0 / dt
    for chunk in range(first, last):
        start = chunk * CHUNK
        count = min(CHUNK, n - start)
        for k in range(count):
            gather(rows, k, f0, f1, lengths, old, start + k)
        predict_chunk(rows, statuses, count, start, model, f0, f1, old)
        correct_chunk(rows, statuses, count, model, over_dt)
        complete_chunk(rows, count, model, viscosity, dt)
        for column in range(sums.shape[1]):
            sums[chunk, column] = 0.0
        failures[chunk, 0] = OK
        for k in range(count):
            i = start + k
            if statuses[k] == OK:
                balance = get_balance(rows, k)
                scatter(rows, k, new, i)
                wave_speed[i] = balance.wave_speed
                write(viscous, i, balance.viscous_pressure)
                add_balance(sums, chunk, volumes[i], balance)
                if not is_finite(balance, get_point(rows, k)):
                    statuses[k] = NOT_FINITE
            if statuses[k] != OK and failures[chunk, 0] == OK:
                failures[chunk, 0] = statuses[k]
                failures[chunk, 1] = i


@inside_kernel
def predict_chunk(rows, statuses, count, start, model, f0, f1, old):
    """Elastic trials of the points in the rows."""
    for k in range(count):
        statuses[k], prediction, rotation, left_stretch = predict(
            model.update, model, get_tensor(rows, F0, k), get_tensor(rows, F1, k), get_point(rows, k)
        )
        put_trial(rows, k, prediction, rotation, left_stretch)
    for k in range(count):
        if statuses[k] == UNSETTLED:
            i = start + k
            statuses[k], prediction, rotation, left_stretch = predict_carefully(
                model.update, model, load_tensor(f0, i), load_tensor(f1, i), load_point(old, i)
            )
            put_trial(rows, k, prediction, rotation, left_stretch)


@inside_kernel
def put_trial(rows, k, prediction, rotation, left_stretch):
    """Write the results of a first part at point k."""
    put_prediction(rows, k, prediction)
    put_tensor(rows, ROTATION, k, rotation)
    put_symmetric(rows, LEFT_STRETCH, k, left_stretch)


@inside_kernel
def correct_chunk(rows, statuses, count, model, over_dt):
    """Returns to the yield surface of the points in the rows."""
    for k in range(count):
        status, correction = correct(model, get_prediction(rows, k), over_dt, get_point(rows, k))
        put_correction(rows, k, correction)
        statuses[k] = status if statuses[k] == OK else statuses[k]
    for k in range(count):
        if statuses[k] == UNSETTLED:
            statuses[k], correction = search(model, get_prediction(rows, k), over_dt, get_point(rows, k))
            put_correction(rows, k, correction)


@inside_kernel
def complete_chunk(rows, count, model, viscosity, dt):
    """State after the step of the points in the rows."""
    for k in range(count):
        point, balance = complete_point(
            model, viscosity, get_prediction(rows, k), get_correction(rows, k), dt, get(rows, LENGTH, k),
            get_point(rows, k),
        )  # fmt: skip
        put_point(rows, k, point)
        put_balance(rows, k, balance)


@inside_kernel
def is_finite(balance, point):
    """Whether a step has led to numbers: what is not one reaches at least one of these."""
    energies = balance.stress_work + balance.viscous
    history = point.temperature + point.damage + point.equivalent_plastic_strain
    return math.isfinite(energies + balance.wave_speed + history)


@inside_kernel
def add_balance(sums, chunk, volume, balance):
    """Add what a step did at a point of a volume to the sums of its chunk."""
    sums[chunk, WORK] += volume * balance.stress_work
    sums[chunk, PLASTIC] += volume * balance.plastic
    sums[chunk, VISCOUS] += volume * balance.viscous
    sums[chunk, SPEED] = max(sums[chunk, SPEED], balance.wave_speed)
    sums[chunk, PRESSURE] = max(sums[chunk, PRESSURE], balance.viscous_pressure)
