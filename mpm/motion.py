"""Motion of the grid: forces, the mirror at the axis and the wall at z = 0."""

from core_models.compilation import inside_kernel, kernel
from mpm.grid import FORCE_R, FORCE_Z, GHOSTS, MASS, MOMENTUM_R, MOMENTUM_Z

BEFORE, AFTER = 0, 1
FAR = 1e300  # m
TOUCHING = 1e-6  # cells: height at which a surface counts as on the wall
HELD_TOUCHING = 0.02  # cells: the same next to a surface that the wall holds


@kernel
def accelerate(first, last, grid, dt, energies):
    """Velocities of the node rows first ... last-1 before and after the forces have acted for dt [s].

    Column 0 is folded into column 1 as its mirror image in the axis: v_r odd, v_z even.
    energies : (rows, 2) kinetic energy before and after [J], written.
    """
    sums, before, after = grid.sums, grid.before, grid.after
    for row in range(first, last):
        energies[row, BEFORE] = 0.0
        energies[row, AFTER] = 0.0
        if grid.first[row] == 0 and grid.last[row] >= 1:
            for k in range(5):
                sign = -1.0 if k in (MOMENTUM_R, FORCE_R) else 1.0
                sums[row, 1, k] += sign * sums[row, 0, k]
                sums[row, 0, k] = 0.0
        for column in range(max(grid.first[row], 1), grid.last[row] + 1):
            m = sums[row, column, MASS]
            if m > 0.0:
                b_r = sums[row, column, MOMENTUM_R] / m
                b_z = sums[row, column, MOMENTUM_Z] / m
                a_r = b_r + dt * sums[row, column, FORCE_R] / m
                a_z = b_z + dt * sums[row, column, FORCE_Z] / m
            else:
                b_r, b_z, a_r, a_z = 0.0, 0.0, 0.0, 0.0
            before[row, column, 0], before[row, column, 1] = b_r, b_z
            after[row, column, 0], after[row, column, 1] = a_r, a_z
            energies[row, BEFORE] += 0.5 * m * (b_r * b_r + b_z * b_z)
            energies[row, AFTER] += 0.5 * m * (a_r * a_r + a_z * a_z)
        mirror(before, row)
        mirror(after, row)


@inside_kernel
def mirror(velocities, row):
    """Set column 0 to the mirror image of column 1 in the axis."""
    velocities[row, 0, 0] = -velocities[row, 1, 0]
    velocities[row, 0, 1] = velocities[row, 1, 1]


@kernel
def meet_wall(grid, dt, gaps, held):
    """Stop the columns of nodes whose material would pass the wall; returns its impulse, work and energy change.

    The velocity of the grid in the wall plane is the mean of the rows on both sides of z = 0. Where the body's surface
    would pass, an impulse shared by both rows changes it to what just closes the gap; it can push only, unless the
    column is held. With the row below the wall the mirror image of the row above, this is the mirror condition,
    switched on by contact. Tangential motion is free.

    gaps : (columns,) height of the surface above the wall [m], FAR where no surface is near. held : (columns,) bool,
    columns whose surface has touched a wall that does not let go.
    """
    low, high = GHOSTS - 1, GHOSTS
    impulse, work, energy = 0.0, 0.0, 0.0
    for column in range(1, grid.sums.shape[1]):
        if gaps[column] == FAR or column < grid.first[low] or column > grid.last[low]:
            continue
        m_low, m_high = grid.sums[low, column, MASS], grid.sums[high, column, MASS]
        if not (m_low > 0.0 and m_high > 0.0):
            continue
        v_low, v_high = grid.after[low, column, 1], grid.after[high, column, 1]
        velocity = 0.5 * (v_low + v_high)
        target = 0.0 if held[column] else -max(gaps[column], 0.0) / dt
        if velocity >= target and not held[column]:
            continue
        push = (target - velocity) / (0.25 / m_low + 0.25 / m_high)
        n_low, n_high = v_low + 0.5 * push / m_low, v_high + 0.5 * push / m_high
        grid.after[low, column, 1], grid.after[high, column, 1] = n_low, n_high
        impulse += push
        work += 0.25 * push * (grid.before[low, column, 1] + grid.before[high, column, 1] + n_low + n_high)
        energy += 0.5 * m_low * (n_low * n_low - v_low * v_low) + 0.5 * m_high * (
            n_high * n_high - v_high * v_high
        )
    mirror(grid.after, low)
    mirror(grid.after, high)
    return impulse, work, energy


@kernel
def measure_gaps(h, positions, deformation_gradient, surface, corners, bilateral, touched, gaps, held):
    """Height of the body's surface above the wall at each column of nodes [m]; FAR where it is far.

    surface : (faces,) particle of each boundary face. corners : (faces, 2, 2) its two ends relative to the particle
    in the reference body [m]. gaps : (columns,), written: the lowest face at the column, or with an end within a
    cell of it.
    bilateral : a face that touches the wall is noted in `touched` (faces,) and holds its columns, `held` (columns,),
    wherever it goes from then on.
    """
    over_h = 1.0 / h
    for column in range(gaps.shape[0]):
        gaps[column] = FAR
        held[column] = False
    for face in range(surface.shape[0]):
        p = surface[face]
        if positions[p, 1] > 3.0 * h:
            continue
        r_low, z_low = face_end(p, positions, deformation_gradient, corners[face, 0, 0], corners[face, 0, 1])
        r_high, z_high = face_end(
            p, positions, deformation_gradient, corners[face, 1, 0], corners[face, 1, 1]
        )
        if r_low > r_high:
            r_low, z_low, r_high, z_high = r_high, z_high, r_low, z_low
        slope = (z_high - z_low) / (r_high - r_low) if r_high > r_low else 0.0
        for column in range(
            max(int(r_low * over_h + 0.5), 1), min(int(r_high * over_h + 0.5) + 2, gaps.shape[0])
        ):
            r = min(max((column - 0.5) * h, r_low), r_high)
            height = z_low + slope * (r - r_low) if r_high > r_low else min(z_low, z_high)
            gaps[column] = min(gaps[column], height)
            touching = HELD_TOUCHING if held[column] else TOUCHING
            touched[face] = touched[face] or (bilateral and height <= touching * h)
            held[column] = held[column] or touched[face]


@inside_kernel
def face_end(p, positions, deformation_gradient, x, z):
    """Radius (not below 0) and height of the end of a face of particle p [m]; (x, z) is where it was from there."""
    r = positions[p, 0] + deformation_gradient[p, 0, 0] * x + deformation_gradient[p, 0, 1] * z
    return max(r, 0.0), positions[p, 1] + deformation_gradient[p, 1, 0] * x + deformation_gradient[
        p, 1, 1
    ] * z
