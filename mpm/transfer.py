"""Transfers between particles and grid: quadratic B-splines, APIC or a blend of FLIP and PIC.

Particles to grid, with x_i - x_p the vector to the node and V the current volume:

    m_i = sum_p m_p N_i,   (m v)_i = sum_p m_p N_i (v_p + C_p (x_i - x_p)),
    f_i = - sum_p V_p (sigma_p grad N_i + hoop stress N_i / r e_r)

Grid to particles: v_p = sum N v, C_p = (4 / h^2) sum N v (x_i - x_p)^T (APIC), or
v_p = alpha (v_p + sum N (v - v_before)) + (1 - alpha) sum N v, C_p = 0 (FLIP/PIC).
Sources: Jiang et al., ACM Trans. Graph. 34 (2015) 51; Steffen et al., Int. J. Numer. Meth. Eng. 76 (2008) 922.
"""

from core_models.compilation import CHUNK, kernel
from core_models.state import read
from mpm.grid import FORCE_R, FORCE_Z, GHOSTS, MASS, MOMENTUM_R, MOMENTUM_Z, slopes, stencil, weights

ENERGY, SPEED = 0, 1


@kernel
def to_grid(
    first, last, parity, grid, order, h, positions, velocities, affine, masses, volumes, volume_ratio,
    stress, viscous,
):  # fmt: skip
    """Add mass, momentum and internal force of the particles to the grid.

    Parameters
    ----------
    first, last : stripes of one parity, counted within that parity; two stripes of one parity share no node.
    grid : `Grid`. order : `Order`. h : cell size [m]. positions, velocities (n, 2), affine (n, 2, 2) [1/s].
    masses (n,) [kg].
    volumes (n,) : reference [m^3], 2 pi r A. volume_ratio (n,). stress (n, 6) [Pa]. viscous (n,) [Pa] or None.
    """
    over_h = 1.0 / h
    sums = grid.sums
    for half in range(first, last):
        stripe = 2 * half + parity
        for place in range(order.start[stripe], order.start[stripe + 1]):
            p = order.particles[place]
            column, dr = stencil(positions[p, 0], over_h, 0)
            row, dz = stencil(positions[p, 1], over_h, GHOSTS - 1)
            nr, nz = weights(dr), weights(dz)
            gr, gz = slopes(dr, over_h), slopes(dz, over_h)
            m = masses[p]
            volume = -volumes[p] * volume_ratio[p]
            q = read(viscous, p, 0.0)
            t_rr, t_zz = volume * (stress[p, 0] - q), volume * (stress[p, 1] - q)
            t_hoop, t_rz = volume * (stress[p, 2] - q) / positions[p, 0], volume * stress[p, 3]
            c_rr, c_rz = affine[p, 0, 0] * h, affine[p, 0, 1] * h
            c_zr, c_zz = affine[p, 1, 0] * h, affine[p, 1, 1] * h
            for b in range(3):
                z = b - 1 - dz
                v_r = velocities[p, 0] + c_rz * z
                v_z = velocities[p, 1] + c_zz * z
                for a in range(3):
                    r = a - 1 - dr
                    n = nr[a] * nz[b]
                    dn_r, dn_z = gr[a] * nz[b], nr[a] * gz[b]
                    mn = m * n
                    sums[row + b, column + a, MASS] += mn
                    sums[row + b, column + a, MOMENTUM_R] += mn * (v_r + c_rr * r)
                    sums[row + b, column + a, MOMENTUM_Z] += mn * (v_z + c_zr * r)
                    sums[row + b, column + a, FORCE_R] += t_rr * dn_r + t_rz * dn_z + t_hoop * n
                    sums[row + b, column + a, FORCE_Z] += t_rz * dn_r + t_zz * dn_z


@kernel
def to_particles(
    first, last, grid, h, dt, flip, positions, velocities, masses, deformation_gradient, new_positions,
    new_velocities, new_affine, new_gradient, new_ratio, sums,
):  # fmt: skip
    """Move the particles with the grid's velocity and deform them with its gradient.

    Parameters
    ----------
    first, last : chunks of CHUNK particles. flip : FLIP's share alpha, or a negative number for APIC.
    The new_ arrays are written; new_ratio is J = det F. sums : (chunks, 2) kinetic energy [J] (affine part included)
    and largest squared speed [m^2/s^2].
    """
    over_h = 1.0 / h
    scale = 4.0 * over_h
    before, after = grid.before, grid.after
    for chunk in range(first, last):
        energy, fastest = 0.0, 0.0
        for p in range(chunk * CHUNK, min((chunk + 1) * CHUNK, positions.shape[0])):
            column, dr = stencil(positions[p, 0], over_h, 0)
            row, dz = stencil(positions[p, 1], over_h, GHOSTS - 1)
            nr, nz = weights(dr), weights(dz)
            gr, gz = slopes(dr, over_h), slopes(dz, over_h)
            v_r, v_z, o_r, o_z = 0.0, 0.0, 0.0, 0.0
            l_rr, l_rz, l_zr, l_zz = 0.0, 0.0, 0.0, 0.0
            b_rr, b_rz, b_zr, b_zz = 0.0, 0.0, 0.0, 0.0
            for b in range(3):
                z = b - 1 - dz
                for a in range(3):
                    r = a - 1 - dr
                    n = nr[a] * nz[b]
                    u_r, u_z = after[row + b, column + a, 0], after[row + b, column + a, 1]
                    dn_r, dn_z = gr[a] * nz[b], nr[a] * gz[b]
                    v_r += n * u_r
                    v_z += n * u_z
                    l_rr += dn_r * u_r
                    l_rz += dn_z * u_r
                    l_zr += dn_r * u_z
                    l_zz += dn_z * u_z
                    if flip < 0.0:
                        b_rr += n * u_r * r
                        b_rz += n * u_r * z
                        b_zr += n * u_z * r
                        b_zz += n * u_z * z
                    else:
                        o_r += n * before[row + b, column + a, 0]
                        o_z += n * before[row + b, column + a, 1]
            hoop = 1.0 + dt * v_r / positions[p, 0]
            new_positions[p, 0] = positions[p, 0] * hoop
            new_positions[p, 1] = positions[p, 1] + dt * v_z
            f_rr, f_rz = deformation_gradient[p, 0, 0], deformation_gradient[p, 0, 1]
            f_zr, f_zz = deformation_gradient[p, 1, 0], deformation_gradient[p, 1, 1]
            new_gradient[p, 0, 0] = f_rr + dt * (l_rr * f_rr + l_rz * f_zr)
            new_gradient[p, 0, 1] = f_rz + dt * (l_rr * f_rz + l_rz * f_zz)
            new_gradient[p, 1, 0] = f_zr + dt * (l_zr * f_rr + l_zz * f_zr)
            new_gradient[p, 1, 1] = f_zz + dt * (l_zr * f_rz + l_zz * f_zz)
            new_gradient[p, 2, 2] = deformation_gradient[p, 2, 2] * hoop
            new_ratio[p] = new_gradient[p, 2, 2] * (
                new_gradient[p, 0, 0] * new_gradient[p, 1, 1] - new_gradient[p, 0, 1] * new_gradient[p, 1, 0]
            )
            if flip >= 0.0:
                v_r = flip * (velocities[p, 0] + v_r - o_r) + (1.0 - flip) * v_r
                v_z = flip * (velocities[p, 1] + v_z - o_z) + (1.0 - flip) * v_z
            new_velocities[p, 0], new_velocities[p, 1] = v_r, v_z
            new_affine[p, 0, 0], new_affine[p, 0, 1] = scale * b_rr, scale * b_rz
            new_affine[p, 1, 0], new_affine[p, 1, 1] = scale * b_zr, scale * b_zz
            square = v_r * v_r + v_z * v_z
            # D = h^2 / 4 and C = (4 / h^2) B with B in cells times h: D |C|^2 = 4 |b|^2.
            spread = 4.0 * (b_rr * b_rr + b_rz * b_rz + b_zr * b_zr + b_zz * b_zz)
            energy += 0.5 * masses[p] * (square + spread)
            fastest = max(fastest, square)
        sums[chunk, ENERGY] = energy
        sums[chunk, SPEED] = fastest
