"""Motion of the nodes: central differences with a rigid wall at z = 0."""

from core_models.compilation import kernel

NODE_CHUNK = 256
IMPULSE, CONTACT_WORK = 0, 1


@kernel
def move(
    first, last, start, entries, corner_forces, mass, on_axis, bilateral, dt, dt_middle, x0, v0, held0, x1, v1, held1,
    sums,
):  # fmt: skip
    """Advance nodes of chunks first ... last-1 by one step of central differences.

        v1 = v0 + dt_middle f / m,   x1 = x0 + dt v1;   on the axis v_r = 0;   at the wall z1 >= 0

    Parameters
    ----------
    start, entries : corners of elements round each node. corner_forces : (m, 4, 2) [N]. mass : (n,) [kg].
    on_axis : (n,) bool. bilateral : a node that has touched the wall stays on it (wall `plane`).
    dt, dt_middle : step and mean of this step and the last [s]. x0, v0, held0 : before. x1, v1, held1 : written.
    sums : (chunks, 2) impulse of the wall [N s] and its work [J], written.

    The wall's impulse is what brings a node exactly to z = 0 when it would pass; it can push only, unless bilateral.
    """
    flat = corner_forces.reshape(-1, 2)
    nodes = mass.shape[0]
    for chunk in range(first, last):
        impulse, work = 0.0, 0.0
        for node in range(chunk * NODE_CHUNK, min((chunk + 1) * NODE_CHUNK, nodes)):
            fr, fz = 0.0, 0.0
            for entry in range(start[node], start[node + 1]):
                fr += flat[entries[entry], 0]
                fz += flat[entries[entry], 1]
            vr = v0[node, 0] + dt_middle * fr / mass[node]
            vz = v0[node, 1] + dt_middle * fz / mass[node]
            if on_axis[node]:
                vr = 0.0
            held = held0[node] and bilateral
            height = x0[node, 1] + dt * vz
            if held or height < 0.0:
                stopped = -x0[node, 1] / dt
                push = mass[node] * (stopped - vz)
                impulse += push
                work += push * 0.5 * (stopped + v0[node, 1])
                vz, height = stopped, 0.0
                held = True
            held1[node] = held
            v1[node, 0], v1[node, 1] = vr, vz
            x1[node, 0] = x0[node, 0] + dt * vr
            x1[node, 1] = height
        sums[chunk, IMPULSE] = impulse
        sums[chunk, CONTACT_WORK] = work
