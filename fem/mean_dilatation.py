"""Axisymmetric quads with mean dilatation (Q1/P0): kinematics and nodal forces that come from one potential.

The points see Fbar = (theta / J)^(1/3) F, where theta is the mean of J over the element's reference volume. The
virtual work of the stress at Fbar is

    sum_q w_q theta sigma_q : (sym grad du + (div_mean du - div du) / 3)
  = sum_q [w_q theta s_q + w_q J_q pbar 1] : grad du,        pbar = sum_q w_q p_q / sum_q w_q

with div_mean the volume average of div du over the current element, so the forces are the exact gradient of an energy
that depends on Fbar. Source: Simo, Taylor & Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177.
"""

import math

from core_models.bulk_viscosity import damped_step_factor
from core_models.compilation import inside_kernel, kernel
from core_models.state import read, write
from core_models.status import INVERTED, OK
from core_models.tensors import THIRD, cube_root
from fem.space import POINTS

ELEMENT_CHUNK = 64  # elements; fixed, so that results do not depend on the number of threads


@inside_kernel
def point_gradient(tables, x, e, q):
    """Deformation gradient (rr, rz, zr, zz, hoop) of point q of element e at nodal positions x."""
    rr, rz, zr, zz, r = 0.0, 0.0, 0.0, 0.0, 0.0
    for k in range(4):
        node = tables.nodes[e, k]
        gr, gz = tables.gradients[e, q, k, 0], tables.gradients[e, q, k, 1]
        xr, xz = x[node, 0], x[node, 1]
        rr += xr * gr
        rz += xr * gz
        zr += xz * gr
        zz += xz * gz
        r += tables.shape[q, k] * xr
    return rr, rz, zr, zz, r / tables.radius[e, q]


@kernel
def deform(first, last, tables, x, deformation_gradient, volume_ratio, lengths, failures):
    """Fill the mean-dilatation deformation gradient of the points from nodal positions.

    Parameters
    ----------
    first, last : chunks of ELEMENT_CHUNK elements. x : (nodes, 2) [m].
    deformation_gradient : (4 m, 3, 3), written. volume_ratio : (4 m,) J of the unmodified F, written.
    lengths : (4 m,) or None; square root of the element's current area [m], written.
    failures : (chunks, 2) status and point.
    """
    elements = tables.nodes.shape[0]
    for chunk in range(first, last):
        failures[chunk, 0] = OK
        for e in range(chunk * ELEMENT_CHUNK, min((chunk + 1) * ELEMENT_CHUNK, elements)):
            volume, reference = 0.0, 0.0
            for q in range(POINTS):
                i = POINTS * e + q
                rr, rz, zr, zz, hoop = point_gradient(tables, x, e, q)
                ratio = (rr * zz - rz * zr) * hoop
                if not ratio > 0.0 or not hoop > 0.0:
                    failures[chunk, 0] = INVERTED
                    failures[chunk, 1] = i
                    ratio = 1.0
                deformation_gradient[i, 0, 0], deformation_gradient[i, 0, 1] = rr, rz
                deformation_gradient[i, 1, 0], deformation_gradient[i, 1, 1] = zr, zz
                deformation_gradient[i, 2, 2] = hoop
                volume_ratio[i] = ratio
                volume += tables.weights[e, q] * ratio
                reference += tables.weights[e, q]
            theta = volume / reference
            for q in range(POINTS):
                i = POINTS * e + q
                scale = cube_root(theta / volume_ratio[i])
                deformation_gradient[i, 0, 0] *= scale
                deformation_gradient[i, 0, 1] *= scale
                deformation_gradient[i, 1, 0] *= scale
                deformation_gradient[i, 1, 1] *= scale
                deformation_gradient[i, 2, 2] *= scale
            length = math.sqrt(current_area(tables, x, e))
            for q in range(POINTS):
                write(lengths, POINTS * e + q, length)


@inside_kernel
def current_area(tables, x, e):
    """Area of element e in the (r, z) plane [m^2]."""
    a, b, c, d = tables.nodes[e, 0], tables.nodes[e, 1], tables.nodes[e, 2], tables.nodes[e, 3]
    return 0.5 * abs((x[c, 0] - x[a, 0]) * (x[d, 1] - x[b, 1]) - (x[d, 0] - x[b, 0]) * (x[c, 1] - x[a, 1]))


@kernel
def resist(
    first, last, tables, x, volume_ratio, stress, viscous, wave_speed, viscosity, density, shear, corner_mass,
    corner_forces, steps,
):  # fmt: skip
    """Internal forces of the elements and the largest stable step of each chunk.

    Parameters
    ----------
    x : (nodes, 2) positions [m]. volume_ratio (4 m,), stress (4 m, 6) [Pa], viscous (4 m,) [Pa] or None,
    wave_speed (4 m,) [m/s] : of the points. shear : modulus [Pa]. corner_mass : (m, 4) [kg].
    corner_forces : (m, 4, 2) [N], written: - d(energy)/d(position). steps : (chunks,) [s], written.

    The step is 2 / omega with a bound of the element's largest frequency: K times the dilatational mode, which is rank
    one and exact, plus 2 G times a bound of the deviatoric part through the scalar stiffness of the gradients. Nodes on
    the axis cannot move along r, which matters: their mass is small and 1 / r is large.
    """
    elements = tables.nodes.shape[0]
    for chunk in range(first, last):
        steps[chunk] = math.inf
        for e in range(chunk * ELEMENT_CHUNK, min((chunk + 1) * ELEMENT_CHUNK, elements)):
            steps[chunk] = min(
                steps[chunk],
                element_resistance(
                    tables, x, volume_ratio, stress, viscous, wave_speed, viscosity, density, shear, corner_mass,
                    corner_forces, e,
                ),
            )  # fmt: skip


@inside_kernel
def element_means(tables, volume_ratio, stress, viscous, wave_speed, e):
    """Volume [m^3], theta, mean stress net of viscosity [Pa], largest wave speed and viscous pressure of element e."""
    volume, reference, mean, speed, largest_viscous = 0.0, 0.0, 0.0, 0.0, 0.0
    for q in range(POINTS):
        i = POINTS * e + q
        w = tables.weights[e, q]
        viscous_pressure = read(viscous, i, 0.0)
        volume += w * volume_ratio[i]
        reference += w
        mean += w * ((stress[i, 0] + stress[i, 1] + stress[i, 2]) * THIRD - viscous_pressure)
        speed = max(speed, wave_speed[i])
        largest_viscous = max(largest_viscous, viscous_pressure)
    return volume, volume / reference, mean / reference, speed, largest_viscous


@inside_kernel
def point_resistance(tables, x, volume_ratio, stress, theta, mean, e, q):
    """What the corners need of point q: inverse gradient (four), 1 / r, volume, and stress times volume (four)."""
    i = POINTS * e + q
    rr, rz, zr, zz, hoop = point_gradient(tables, x, e, q)
    d = 1.0 / (rr * zz - rz * zr)
    w = tables.weights[e, q] * volume_ratio[i]
    wd = tables.weights[e, q] * theta
    p = (stress[i, 0] + stress[i, 1] + stress[i, 2]) * THIRD
    isotropic = w * mean
    return (
        zz * d, zr * d, rz * d, rr * d, 1.0 / (hoop * tables.radius[e, q]), w,
        wd * (stress[i, 0] - p) + isotropic, wd * (stress[i, 1] - p) + isotropic,
        wd * (stress[i, 2] - p) + isotropic, wd * stress[i, 3],
    )  # fmt: skip


@inside_kernel
def element_resistance(
    tables,
    x,
    volume_ratio,
    stress,
    viscous,
    wave_speed,
    viscosity,
    density,
    shear,
    corner_mass,
    corner_forces,
    e,
):
    """Internal forces of element e; returns its stable step [s]."""
    volume, theta, mean, speed, largest_viscous = element_means(
        tables, volume_ratio, stress, viscous, wave_speed, e
    )
    points = (
        point_resistance(tables, x, volume_ratio, stress, theta, mean, e, 0),
        point_resistance(tables, x, volume_ratio, stress, theta, mean, e, 1),
        point_resistance(tables, x, volume_ratio, stress, theta, mean, e, 2),
        point_resistance(tables, x, volume_ratio, stress, theta, mean, e, 3),
    )
    dilatational, scalar_rr, scalar_zz, scalar_rz = 0.0, 0.0, 0.0, 0.0
    for k in range(4):
        f_r, f_z, b_r, b_z, s_rr, s_zz, s_rz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for q in range(POINTS):
            i_zz, i_zr, i_rz, i_rr, over_r, w, t_rr, t_zz, t_hoop, t_rz = points[q]
            gx, gy = tables.gradients[e, q, k, 0], tables.gradients[e, q, k, 1]
            gr, gz, gt = i_zz * gx - i_zr * gy, i_rr * gy - i_rz * gx, tables.shape[q, k] * over_r
            f_r -= t_rr * gr + t_rz * gz + t_hoop * gt
            f_z -= t_rz * gr + t_zz * gz
            b_r += w * (gr + gt)
            b_z += w * gz
            s_rr += w * (gr * gr + gt * gt)
            s_zz += w * gz * gz
            s_rz += w * gr * gz
        corner_forces[e, k, 0], corner_forces[e, k, 1] = f_r, f_z
        over_m = 1.0 / corner_mass[e, k]
        free = 0.0 if x[tables.nodes[e, k], 0] == 0.0 else over_m  # a node on the axis cannot move along r
        dilatational += free * b_r * b_r + over_m * b_z * b_z
        scalar_rr += free * s_rr
        scalar_zz += over_m * s_zz
        scalar_rz += free * s_rz
    half_sum, half_gap = 0.5 * (scalar_rr + scalar_zz), 0.5 * (scalar_rr - scalar_zz)
    scalar = half_sum + math.sqrt(half_gap * half_gap + scalar_rz * scalar_rz)
    stiffness = density / theta * speed * speed
    bulk = max(stiffness - 4.0 / 3.0 * shear, 0.0)
    frequency = math.sqrt(bulk * dilatational / volume + 2.0 * shear * scalar)
    return 2.0 / frequency * damped_step_factor(viscosity, largest_viscous / stiffness)
