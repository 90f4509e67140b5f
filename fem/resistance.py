"""Internal forces of the elements: minus the gradient of the energy that the points hold."""

import math

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.state import read
from core_models.tensors import THIRD, load_symmetric
from fem.cures.projection import PRESSURE, PROJECTED, project
from fem.deformation import ELEMENT_CHUNK
from fem.elements import nodes_of, points_of
from fem.geometries import cofactor_of
from fem.stable_step import put_stiffness, stable_step

FORCE = 4  # columns of the scratch: w J sigma F^-T of each point


@kernel
def resist(
    first, last, scratch, geometry, element, cure, tables, metric, gradients, scales, stress, viscous, wave_speed,
    viscosity, density, shear, corner_mass, corner_forces, steps,
):  # fmt: skip
    """Internal forces of the elements and the largest stable step of each chunk.

    Parameters
    ----------
    first, last : chunks of ELEMENT_CHUNK elements. scratch : (MOST_POINTS, columns), the thread's own.
    geometry, element, cure : what the kernel is compiled for. metric : `fem.metric.Metric`.
    gradients (n, 3, 3), scales (n,) or None : of the points, as `deform` left them. stress (n, 6) [Pa],
    viscous (n,) [Pa] or None, wave_speed (n,) [m/s] : of the points. shear : modulus [Pa].
    corner_mass : (m, a) [kg]. corner_forces : (m, a, d) [N], written. steps : (chunks,) [s], written.
    """
    elements = tables.nodes.shape[0]
    for chunk in range(first, last):
        steps[chunk] = math.inf
        for e in range(chunk * ELEMENT_CHUNK, min((chunk + 1) * ELEMENT_CHUNK, elements)):
            for q in range(points_of(element)):
                i = points_of(element) * e + q
                pressure = (stress[i, 0] + stress[i, 1] + stress[i, 2]) * THIRD
                scratch[q, PRESSURE] = pressure - read(viscous, i, 0.0)
            project(cure, element, tables, e, scratch, PRESSURE)
            for q in range(points_of(element)):
                i = points_of(element) * e + q
                scale = read(scales, i, 1.0)
                shrink = 1.0 / scale
                cofactor, theta = cofactor_of(geometry, gradients, i)
                isotropic = scratch[q, PROJECTED + PRESSURE] * (shrink * shrink * shrink)
                weight = tables.weights[e, q]
                put_force(
                    geometry, scratch, q, weight * scale, load_symmetric(stress, i), isotropic, cofactor
                )
                put_stiffness(
                    geometry, metric, scratch, e, q, weight, shrink, cofactor, theta, density, shear,
                    wave_speed[i], read(viscous, i, 0.0),
                )  # fmt: skip
            for a in range(nodes_of(element)):
                put_corner_force(geometry, element, tables, scratch, e, a, corner_forces)
            step = stable_step(
                cure, geometry, element, tables, metric, scratch, e, corner_mass, shear, viscosity
            )
            steps[chunk] = min(steps[chunk], step)


@inside_kernel
def total_stress(stress, isotropic):
    """Stress with another mean stress."""
    change = isotropic - (stress[0] + stress[1] + stress[2]) * THIRD
    return stress[0] + change, stress[1] + change, stress[2] + change, stress[3], stress[4], stress[5]


@generic
def put_force(geometry, scratch, q, weight, stress, isotropic, cofactor):
    """Write weight (dev stress + isotropic 1) cofactor of point q: what the reference gradients of N_a act on [N m]."""


@put_force.register(PlaneStrain)
@put_force.register(Axisymmetric)
def _(geometry, scratch, q, weight, stress, isotropic, cofactor):
    t = total_stress(stress, isotropic)
    rr, zz, hoop, rz = weight * t[0], weight * t[1], weight * t[2], weight * t[3]
    scratch[q, FORCE + 0] = rr * cofactor[0] + rz * cofactor[2]
    scratch[q, FORCE + 1] = rr * cofactor[1] + rz * cofactor[3]
    scratch[q, FORCE + 2] = rz * cofactor[0] + zz * cofactor[2]
    scratch[q, FORCE + 3] = rz * cofactor[1] + zz * cofactor[3]
    scratch[q, FORCE + 4] = hoop * cofactor[4]


@put_force.register(Spatial)
def _(geometry, scratch, q, weight, stress, isotropic, cofactor):
    t = total_stress(stress, isotropic)
    rows = ((t[0], t[3], t[5]), (t[3], t[1], t[4]), (t[5], t[4], t[2]))
    for i in range(3):
        for j in range(3):
            scratch[q, FORCE + 3 * i + j] = weight * (
                rows[i][0] * cofactor[j] + rows[i][1] * cofactor[3 + j] + rows[i][2] * cofactor[6 + j]
            )


@generic
def put_corner_force(geometry, element, tables, scratch, e, a, corner_forces):
    """Write the force of element e on its corner a from what the points have left in the scratch."""


@put_corner_force.register(Axisymmetric)
def _(geometry, element, tables, scratch, e, a, corner_forces):
    force_r, force_z = 0.0, 0.0
    for q in range(points_of(element)):
        gr, gz, gh = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2]
        force_r -= scratch[q, FORCE + 0] * gr + scratch[q, FORCE + 1] * gz + scratch[q, FORCE + 4] * gh
        force_z -= scratch[q, FORCE + 2] * gr + scratch[q, FORCE + 3] * gz
    corner_forces[e, a, 0], corner_forces[e, a, 1] = force_r, force_z


@put_corner_force.register(PlaneStrain)
def _(geometry, element, tables, scratch, e, a, corner_forces):
    force_x, force_y = 0.0, 0.0
    for q in range(points_of(element)):
        gx, gy = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1]
        force_x -= scratch[q, FORCE + 0] * gx + scratch[q, FORCE + 1] * gy
        force_y -= scratch[q, FORCE + 2] * gx + scratch[q, FORCE + 3] * gy
    corner_forces[e, a, 0], corner_forces[e, a, 1] = force_x, force_y


@put_corner_force.register(Spatial)
def _(geometry, element, tables, scratch, e, a, corner_forces):
    force_x, force_y, force_z = 0.0, 0.0, 0.0
    for q in range(points_of(element)):
        gx, gy, gz = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2]
        force_x -= scratch[q, FORCE + 0] * gx + scratch[q, FORCE + 1] * gy + scratch[q, FORCE + 2] * gz
        force_y -= scratch[q, FORCE + 3] * gx + scratch[q, FORCE + 4] * gy + scratch[q, FORCE + 5] * gz
        force_z -= scratch[q, FORCE + 6] * gx + scratch[q, FORCE + 7] * gy + scratch[q, FORCE + 8] * gz
    corner_forces[e, a, 0], corner_forces[e, a, 1], corner_forces[e, a, 2] = force_x, force_y, force_z
