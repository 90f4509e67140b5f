"""The one kernel that is compiled for each material: advance a range of points by one step."""

import math

from core_models.columns import gather, get_point, scatter
from core_models.compilation import CHUNK, inside_kernel, material_kernel
from core_models.rows import BLOCK
from core_models.status import NOT_FINITE, OK
from core_models.updates.balance import get_balance
from core_models.updates.interface import advance_rows

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
    model, viscosity : laws. f0, f1 : (n, 9) deformation gradient before and after. dt : [s].
    volumes : (n,) reference volumes [m^3]. lengths : (n,) characteristic lengths [m].
    old, new : `State`. wave_speed (n,) [m/s] and viscous (n,) [Pa] or None are written.
    sums : (chunks, 5) stress work, plastic and viscous dissipation [J], largest wave speed [m/s] and viscous
    pressure [Pa]; failures : (chunks, 2) status and point.
    """
    n = f1.shape[0]
    rows, statuses = workspace
    for chunk in range(first, last):
        for column in range(sums.shape[1]):
            sums[chunk, column] = 0.0
        failures[chunk, 0] = OK
        end = min((chunk + 1) * CHUNK, n)
        for start in range(chunk * CHUNK, end, BLOCK):
            count = min(BLOCK, end - start)
            gather(rows, start, count, f0, f1, lengths, old)
            advance_rows(model.update, rows, statuses, count, model, viscosity, dt)
            scatter(rows, start, count, new, wave_speed, viscous)
            for k in range(count):
                balance = get_balance(rows, k)
                add_balance(sums, chunk, volumes[start + k], balance)
                if statuses[k] == OK and not is_finite(balance, get_point(rows, k)):
                    statuses[k] = NOT_FINITE
                if statuses[k] != OK and failures[chunk, 0] == OK:
                    failures[chunk, 0] = statuses[k]
                    failures[chunk, 1] = start + k


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
