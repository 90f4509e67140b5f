"""A bound of the stable step of central differences, 2 / omega, from each element by itself.

The largest frequency of a body is at most that of its worst element. An element's mass is dealt out to its points,
m_a = sum_q m_aq, and no Rayleigh quotient of a sum exceeds the largest of its parts, so that, point by point,

    omega^2 <= max_q [K tr h + 2 G min(lambda, 2/3 tr h)],   <= max_q [max(3 K, 2 G) lambda]
    h = sum_a w J g_a g_a^T / m_aq = J F^-T H F^-1,   lambda its largest eigenvalue, tr h its trace

where g_a are the current gradients of the shape functions and H is fixed in the reference body. The dilatation of a
point is that of a projection, which cannot raise this; for the mean dilatation its part is of rank one, and exact.
Any shares m_aq are right; `fem.metric` takes such that make the points of an element much alike, which is close: for
slender elements within 5 % of the step that the whole body allows, for squares and cubes of linear kinds within 60 %.
"""

import math

from core_models.bulk_viscosity import damped_step_factor
from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.state import read
from core_models.tensors import congruence
from fem.elements import points_of

# Columns of the scratch, behind those of the forces; from SPREAD on w J F^-T.
STIFFNESS, TRACE, EIGENVALUE, VISCOUS, VOLUME, SPREAD = 13, 14, 15, 16, 17, 18
SCRATCH_COLUMNS = 27


@inside_kernel
def put_stiffness(
    geometry, metric, scratch, e, q, weight, shrink, cofactor, theta, density, shear, speed, viscous
):
    """Write what `stable_step` needs of point q; shrink : (J / theta)^(1/3)."""
    over_theta = 1.0 / theta
    trace, eigenvalue = spread(geometry, metric, e, q, cofactor)
    over, share = shrink * over_theta, weight * shrink * shrink
    scratch[q, STIFFNESS] = density * over_theta * speed * speed
    scratch[q, TRACE] = over * trace
    scratch[q, EIGENVALUE] = over * eigenvalue
    scratch[q, VISCOUS] = viscous
    scratch[q, VOLUME] = share * shrink * theta
    for k in range(len(cofactor)):
        scratch[q, SPREAD + k] = share * cofactor[k]


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
def bulk_part(scratch, q, shear):
    """Bulk modulus of point q [Pa], from its stiffness in uniaxial strain."""
    return max(scratch[q, STIFFNESS] - 4.0 / 3.0 * shear, 0.0)


@inside_kernel
def shear_part(scratch, q, shear):
    """Largest square frequency of the deviatoric part of point q [1/s^2]; 0 for a point without waves."""
    shear = min(shear, 3.0 / 4.0 * scratch[q, STIFFNESS])
    return 2.0 * shear * min(scratch[q, EIGENVALUE], 2.0 / 3.0 * scratch[q, TRACE])


@generic
def square_frequency(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear):
    """Bound of the largest square frequency of element e [1/s^2]."""


@square_frequency.otherwise
def _(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear):
    largest = 0.0
    for q in range(points_of(element)):
        bulk = bulk_part(scratch, q, shear)
        apart = bulk * scratch[q, TRACE] + shear_part(scratch, q, shear)
        largest = max(largest, min(apart, max(3.0 * bulk, 2.0 * shear) * scratch[q, EIGENVALUE]))
    return largest


@inside_kernel
def stable_step(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear, viscosity):
    """Stable step of element e [s]."""
    square = square_frequency(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear)
    viscous, stiffness = 0.0, math.inf
    for q in range(points_of(element)):
        viscous = max(viscous, scratch[q, VISCOUS])
        has_waves = scratch[q, STIFFNESS] > 0.0
        stiffness = min(stiffness, scratch[q, STIFFNESS] if has_waves else math.inf)
    frequency = math.sqrt(square + read(metric.hourglass, e, 0.0))
    return 2.0 / frequency * damped_step_factor(viscosity, viscous / stiffness)
