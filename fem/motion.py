"""Motion of the nodes: central differences with supports, damping, and a rigid wall with friction."""

import math

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from core_models.walls import PLANE, Wall
from fem.geometries import dimension_of

NODE_CHUNK = 256
IMPULSE, CONTACT, FRICTION, DAMPING, EXTERNAL = 0, 1, 2, 3, 4
SUMS = 5
NO_WALL, LETS_GO, HOLDS = 0, 1, 2


def wall_mode(wall: Wall | None) -> int:
    """The wall's kind as kernels see it."""
    if wall is None:
        return NO_WALL
    return HOLDS if wall.kind == PLANE else LETS_GO


@kernel
def move(
    first, last, geometry, start, entries, corner_forces, loads, mass, fixed, given, wall, friction, damping, dt,
    middle, x0, v0, held0, x1, v1, held1, reactions, sums,
):  # fmt: skip
    """Advance nodes of chunks first ... last-1 by one step of central differences.

        m (v1 - v0) / middle = f - damping m (v0 + v1) / 2,   x1 = x0 + dt v1;   supported components: v1 is given

    Parameters
    ----------
    start, entries : corners of elements round each node. corner_forces : (m a, d), loads : (n, d) or None [N].
    mass : (n,) [kg]. fixed : (n, d) supported components, given : (n, d) their velocities [m/s]. wall : NO_WALL,
    LETS_GO or HOLDS, with its coefficient of friction. damping : [1/s].
    dt, middle : step and mean of this step and the last [s]. x0, v0, held0 : before. x1, v1, held1 : written.
    reactions : (n, d) impulses of the supports [N s], written, or None.
    sums : (chunks, SUMS) normal impulse of the wall [N s]; what it, friction, damping and everything outside have done
    to the body [J], written.

    The wall's impulse is what brings a node exactly to the wall when it would pass; it can push only, unless it holds.
    """
    d = dimension_of(geometry)
    nodes = mass.shape[0]
    slowing = 0.5 * damping * middle
    for chunk in range(first, last):
        for k in range(SUMS):
            sums[chunk, k] = 0.0
        external, damped = 0.0, 0.0
        for node in range(chunk * NODE_CHUNK, min((chunk + 1) * NODE_CHUNK, nodes)):
            for i in range(d):
                force = component(loads, node, i)
                for entry in range(start[node], start[node + 1]):
                    force += corner_forces[entries[entry], i]
                free = ((1.0 - slowing) * v0[node, i] + middle * force / mass[node]) / (1.0 + slowing)
                v1[node, i] = given[node, i] if fixed[node, i] else free
                reaction = (1.0 + slowing) * mass[node] * (v1[node, i] - free)
                put_component(reactions, node, i, reaction)
                external += 0.5 * reaction * (v0[node, i] + v1[node, i])
            held1[node] = False
            if wall != NO_WALL and not fixed[node, d - 1]:
                meet_wall(
                    d, wall, friction, dt, node, mass[node], fixed, x0, v0, held0, v1, held1, sums, chunk
                )
            for i in range(d):
                average = 0.5 * (v0[node, i] + v1[node, i])
                external += middle * component(loads, node, i) * average
                damped -= damping * middle * mass[node] * average * average
                x1[node, i] = x0[node, i] + dt * v1[node, i]
            if held1[node]:
                x1[node, d - 1] = 0.0
        sums[chunk, EXTERNAL] = external
        sums[chunk, DAMPING] = damped


@generic
def component(array, node, i):
    """array[node, i], or 0 where there is no array."""


@component.otherwise
def _(array, node, i):
    return array[node, i]


@component.register(type(None))
def _(array, node, i):
    return 0.0


@generic
def put_component(array, node, i, value):
    """Write array[node, i] where there is an array."""


@put_component.otherwise
def _(array, node, i, value):
    array[node, i] = value


@put_component.register(type(None))
def _(array, node, i, value):
    return


@inside_kernel
def meet_wall(d, wall, friction, dt, node, mass, fixed, x0, v0, held0, v1, held1, sums, chunk):
    """Stop a node that would pass the wall, and let friction act on it."""
    n = d - 1
    held = held0[node] and wall == HOLDS
    if not (held or x0[node, n] + dt * v1[node, n] < 0.0):
        return
    stopped = -x0[node, n] / dt
    push = mass * (stopped - v1[node, n])
    sums[chunk, IMPULSE] += push
    sums[chunk, CONTACT] += push * 0.5 * (stopped + v0[node, n])
    v1[node, n] = stopped
    held1[node] = True
    if friction > 0.0 and push > 0.0:
        rub(d, friction * push, node, mass, fixed, v0, v1, sums, chunk)


@inside_kernel
def rub(d, limit, node, mass, fixed, v0, v1, sums, chunk):
    """Coulomb friction: an impulse against the sliding, as large as stops it, but not above the limit [N s]."""
    square = 0.0
    for i in range(d - 1):
        if not fixed[node, i]:
            square += v1[node, i] * v1[node, i]
    sliding = math.sqrt(square)
    if sliding == 0.0:
        return
    kept = max(0.0, 1.0 - limit / (mass * sliding))
    for i in range(d - 1):
        if not fixed[node, i]:
            after = kept * v1[node, i]
            sums[chunk, FRICTION] += mass * (after - v1[node, i]) * 0.5 * (after + v0[node, i])
            v1[node, i] = after
