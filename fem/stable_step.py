"""A bound of the stable step of central differences, 2 / omega, from each element by itself.

The largest frequency of a body is at most that of its worst element. An element's mass is dealt out to its points,
m_a = sum_q m_aq, and no Rayleigh quotient of a sum exceeds the largest of its parts, so that, point by point,

    omega^2 <= max_q [K tr h + 2 G min(lambda, 2/3 tr h)],   <= max_q [max(3 K, 2 G) lambda]
    h = sum_a w J g_a g_a^T / m_aq = J F^-T H F^-1,   lambda its largest eigenvalue, tr h its trace

where g_a are the current gradients of the shape functions and H is fixed in the reference body. The dilatation of a
point is that of a projection, which cannot raise this; for the mean dilatation its part is of rank one, and exact.
Any shares m_aq are right; those in proportion to w |grad N_a| make the bound close: 5.3 instead of 4 for a cube.
"""

import math

from core_models.bulk_viscosity import damped_step_factor
from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.state import read
from core_models.tensors import congruence
from fem.cures.mean_dilatation import MeanDilatation
from fem.elements import nodes_of, points_of

BULK, TRACE, EIGENVALUE, DAMPED, VOLUME, SPREAD = (
    13,
    14,
    15,
    16,
    17,
    18,
)  # columns of the scratch; w J F^-T from SPREAD on
SCRATCH_COLUMNS = 27


@inside_kernel
def put_stiffness(
    geometry, metric, scratch, e, q, reference_weight, scale, cofactor, theta, density, shear, speed, viscous
):
    """Write what `stable_step` needs of point q."""
    stiffness = density / theta * speed * speed
    trace, eigenvalue = spread(geometry, metric, e, q, cofactor)
    over = 1.0 / (scale * theta)
    scratch[q, BULK] = max(stiffness - 4.0 / 3.0 * shear, 0.0)
    scratch[q, TRACE] = over * trace
    scratch[q, EIGENVALUE] = over * eigenvalue
    scratch[q, DAMPED] = viscous / stiffness
    scratch[q, VOLUME] = reference_weight * theta / (scale * scale * scale)
    weight = reference_weight / (scale * scale)
    for k in range(len(cofactor)):
        scratch[q, SPREAD + k] = weight * cofactor[k]


@inside_kernel
def trace_and_bound(h):
    """Trace of a symmetric tensor and a bound of its largest eigenvalue: exact if two eigenvalues are equal."""
    third = (h[0] + h[1] + h[2]) / 3.0
    a, b, c = h[0] - third, h[1] - third, h[2] - third
    square = a * a + b * b + c * c + 2.0 * (h[3] * h[3] + h[4] * h[4] + h[5] * h[5])
    return 3.0 * third, third + math.sqrt(square * (2.0 / 3.0))


@generic
def spread(geometry, metric, e, q, cofactor):
    """Trace and largest eigenvalue of cofactor H cofactor^T."""


@spread.register(Spatial)
def _(geometry, metric, e, q, cofactor):
    t = metric.tensors
    reference = (t[e, q, 0], t[e, q, 1], t[e, q, 2], t[e, q, 3], t[e, q, 4], t[e, q, 5])
    return trace_and_bound(congruence(cofactor, reference))


@inside_kernel
def flat_congruence(t, e, q, c):
    """The part of cofactor H cofactor^T in the plane: 11, 22, 12."""
    rr, zz, rz = t[e, q, 0], t[e, q, 1], t[e, q, 3]
    return (
        c[0] * c[0] * rr + 2.0 * c[0] * c[1] * rz + c[1] * c[1] * zz,
        c[2] * c[2] * rr + 2.0 * c[2] * c[3] * rz + c[3] * c[3] * zz,
        c[0] * c[2] * rr + (c[0] * c[3] + c[1] * c[2]) * rz + c[1] * c[3] * zz,
    )


@spread.register(PlaneStrain)
def _(geometry, metric, e, q, cofactor):
    rr, zz, rz = flat_congruence(metric.tensors, e, q, cofactor)
    half_sum, half_gap = 0.5 * (rr + zz), 0.5 * (rr - zz)
    return rr + zz, half_sum + math.sqrt(half_gap * half_gap + rz * rz)


@spread.register(Axisymmetric)
def _(geometry, metric, e, q, cofactor):
    t, c = metric.tensors, cofactor
    rr, zz, rz = flat_congruence(t, e, q, c)
    hoop_z = c[4] * (c[2] * t[e, q, 5] + c[3] * t[e, q, 4])
    hoop_r = c[4] * (c[0] * t[e, q, 5] + c[1] * t[e, q, 4])
    return trace_and_bound((rr, zz, c[4] * c[4] * t[e, q, 2], rz, hoop_z, hoop_r))


@inside_kernel
def shear_part(shear, trace, eigenvalue):
    """Largest square frequency of the deviatoric part: 2 G times that of grad u, less what is volumetric."""
    return 2.0 * shear * min(eigenvalue, 2.0 / 3.0 * trace)


@generic
def square_frequency(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear):
    """Bound of the largest square frequency of element e [1/s^2]."""


@square_frequency.otherwise
def _(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear):
    largest = 0.0
    for q in range(points_of(element)):
        bulk, trace, eigenvalue = scratch[q, BULK], scratch[q, TRACE], scratch[q, EIGENVALUE]
        apart = bulk * trace + shear_part(shear, trace, eigenvalue)
        largest = max(largest, min(apart, max(3.0 * bulk, 2.0 * shear) * eigenvalue))
    return largest


@square_frequency.register(MeanDilatation)
def _(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear):
    bulk, deviatoric = 0.0, 0.0
    for q in range(points_of(element)):
        bulk = max(bulk, scratch[q, BULK])
        deviatoric = max(deviatoric, shear_part(shear, scratch[q, TRACE], scratch[q, EIGENVALUE]))
    return (
        bulk * mean_dilatation_mode(geometry, element, tables, metric, scratch, e, corner_mass) + deviatoric
    )


@generic
def mean_divergence(geometry, element, tables, scratch, e, a):
    """Volume times the mean gradient of the shape function of corner a, with what a radius adds: (d,) [m^2]."""


@mean_divergence.register(Axisymmetric)
def _(geometry, element, tables, scratch, e, a):
    r, z = 0.0, 0.0
    for q in range(points_of(element)):
        gr, gz, gh = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2]
        r += scratch[q, SPREAD] * gr + scratch[q, SPREAD + 1] * gz + scratch[q, SPREAD + 4] * gh
        z += scratch[q, SPREAD + 2] * gr + scratch[q, SPREAD + 3] * gz
    return r, z


@mean_divergence.register(PlaneStrain)
def _(geometry, element, tables, scratch, e, a):
    x, y = 0.0, 0.0
    for q in range(points_of(element)):
        gx, gy = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1]
        x += scratch[q, SPREAD] * gx + scratch[q, SPREAD + 1] * gy
        y += scratch[q, SPREAD + 2] * gx + scratch[q, SPREAD + 3] * gy
    return x, y


@mean_divergence.register(Spatial)
def _(geometry, element, tables, scratch, e, a):
    x, y, z = 0.0, 0.0, 0.0
    for q in range(points_of(element)):
        g0, g1, g2 = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2]
        x += scratch[q, SPREAD] * g0 + scratch[q, SPREAD + 1] * g1 + scratch[q, SPREAD + 2] * g2
        y += scratch[q, SPREAD + 3] * g0 + scratch[q, SPREAD + 4] * g1 + scratch[q, SPREAD + 5] * g2
        z += scratch[q, SPREAD + 6] * g0 + scratch[q, SPREAD + 7] * g1 + scratch[q, SPREAD + 8] * g2
    return x, y, z


@inside_kernel
def mean_dilatation_mode(geometry, element, tables, metric, scratch, e, corner_mass):
    """Square frequency of the mean dilatation of element e for a bulk modulus of 1 [1/(s^2 Pa)]."""
    total, volume = 0.0, 0.0
    for q in range(points_of(element)):
        volume += scratch[q, VOLUME]
    for a in range(nodes_of(element)):
        mode = mean_divergence(geometry, element, tables, scratch, e, a)
        square = metric.free[tables.nodes[e, a]] * mode[0] * mode[0]
        for i in range(1, len(mode)):
            square += mode[i] * mode[i]
        total += square / corner_mass[e, a]
    return total / volume


@inside_kernel
def stable_step(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear, viscosity):
    """Stable step of element e [s]."""
    square = square_frequency(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear)
    relative = 0.0
    for q in range(points_of(element)):
        relative = max(relative, scratch[q, DAMPED])
    frequency = math.sqrt(square + read(metric.hourglass, e, 0.0))
    return 2.0 / frequency * damped_step_factor(viscosity, relative)
