"""The one kernel that is compiled for each material: advance a range of points by one step."""

import math

from core_models.compilation import CHUNK, material_kernel
from core_models.laws import advance_point
from core_models.state import load_point, read, store_point, write
from core_models.status import NOT_FINITE, OK
from core_models.tensors import load_tensor

WORK, PLASTIC, VISCOUS, SPEED, PRESSURE = 0, 1, 2, 3, 4


@material_kernel
def advance_points(
    first, last, model, viscosity, f0, f1, dt, volumes, lengths, old, new, wave_speed, viscous, sums, failures
):
    """Advance the points of chunks first ... last-1 and sum their work chunk by chunk.

    Parameters
    ----------
    first, last : range of chunks of CHUNK points.
    model, viscosity : laws. f0, f1 : (n, 3, 3) deformation gradient before and after. dt : [s].
    volumes : (n,) reference volumes [m^3]. lengths : (n,) characteristic lengths [m].
    old, new : `State`. wave_speed (n,) [m/s] and viscous (n,) [Pa] or None are written.
    sums : (chunks, 5) stress work, plastic and viscous dissipation [J], largest wave speed [m/s] and viscous
    pressure [Pa]; failures : (chunks, 2) status and point.
    """
    n = f1.shape[0]
    for chunk in range(first, last):
        work, plastic, viscous_work, fastest, largest = 0.0, 0.0, 0.0, 0.0, 0.0
        failures[chunk, 0] = OK
        for i in range(chunk * CHUNK, min((chunk + 1) * CHUNK, n)):
            status, point, balance = advance_point(
                model.update, model, viscosity, load_tensor(f0, i), load_tensor(f1, i), dt, read(lengths, i, 0.0),
                load_point(old, i),
            )  # fmt: skip
            if status == OK and not math.isfinite(balance.stress_work + balance.viscous + balance.wave_speed):
                status = NOT_FINITE
            if status != OK and failures[chunk, 0] == OK:
                failures[chunk, 0] = status
                failures[chunk, 1] = i
            store_point(new, i, point)
            wave_speed[i] = balance.wave_speed
            write(viscous, i, balance.viscous_pressure)
            work += volumes[i] * balance.stress_work
            plastic += volumes[i] * balance.plastic
            viscous_work += volumes[i] * balance.viscous
            fastest = max(fastest, balance.wave_speed)
            largest = max(largest, balance.viscous_pressure)
        sums[chunk, WORK] = work
        sums[chunk, PLASTIC] = plastic
        sums[chunk, VISCOUS] = viscous_work
        sums[chunk, SPEED] = fastest
        sums[chunk, PRESSURE] = largest
