"""The yield surface of porous metals after Gurson, Tvergaard and Needleman, and the porosity that counts in it."""

import math

import numpy as np

from core_models.compilation import inside_kernel

LARGEST_PART = 0.99  # of the porosity at which nothing carries: what f* is held at, so that a surface remains
LARGEST_POROSITY = 0.99  # of which the matrix is taken to have no less than the rest
LARGEST_ARGUMENT = 40.0  # of cosh: voids on the surface have closed to round-off there


@inside_kernel
def full_porosity(law):
    """f* at which the surface has shrunk to a point on the axis of the mean stress, or is the smallest."""
    return (law.q1 - math.sqrt(max(law.q1 * law.q1 - law.q3, 0.0))) / law.q3


@inside_kernel
def largest_effective(law):
    """What f* is held at."""
    return LARGEST_PART * full_porosity(law)


@inside_kernel
def accelerated_porosity(law, porosity):
    """f + (k - 1) max(f - f_c, 0), of numbers or arrays."""
    return porosity + (law.k - 1.0) * np.maximum(porosity - law.f_c, 0.0)


@inside_kernel
def effective_porosity(law, porosity):
    """f*, held at its limit, and its slope by f."""
    effective = accelerated_porosity(law, porosity)
    limit = largest_effective(law)
    slope = law.k if porosity > law.f_c else 1.0
    return min(effective, limit), slope if effective < limit else 0.0


@inside_kernel
def carrying_share(law, porosity):
    """Volume fraction of the matrix 1 - f, not below that at which f* is held; and its slope by f."""
    limit = largest_effective(law)
    last = limit if limit < law.f_c else law.f_c + (limit - law.f_c) / law.k
    last = min(last, LARGEST_POROSITY)
    return 1.0 - min(porosity, last), -1.0 if porosity < last else 0.0


@inside_kernel
def argument(law, stress, flow):
    """3 q2 m / (2 sigma_y), within the largest."""
    return min(max(1.5 * law.q2 * stress / flow, -LARGEST_ARGUMENT), LARGEST_ARGUMENT)


@inside_kernel
def remaining_square(law, stress, flow, porosity):
    """(q / sigma_y)^2 on the surface: 1 + q3 f*^2 - 2 q1 f* cosh(3 q2 m / (2 sigma_y)); below 0 beyond it."""
    f = effective_porosity(law, porosity)[0]
    return 1.0 + law.q3 * f * f - 2.0 * law.q1 * f * math.cosh(argument(law, stress, flow))


@inside_kernel
def yield_function(law, mises, stress, flow, porosity):
    """(q / sigma_y)^2 + 2 q1 f* cosh(3 q2 m / (2 sigma_y)) - 1 - q3 f*^2."""
    return mises * mises / (flow * flow) - remaining_square(law, stress, flow, porosity)
