"""Logarithm, exponential and power in plain arithmetic, for laws in the loops over points.

A call of the C library keeps the compiler from treating several points at once; these are straight lines of IEEE
operations, within 2 units in the last place, and give the same bits one by one and side by side.
Source: splittings, and the polynomial of the logarithm, of fdlibm (Sun Microsystems, 1993), e_log.c and e_exp.c.
"""

import numpy as np

from core_models.compilation import inside_kernel

SMALLEST, LARGEST = 1e-300, 1e300
LARGEST_EXPONENT = 690.0
LN2_HIGH, LN2_LOW = 6.93147180369123816490e-01, 1.90821492927058770002e-10
OVER_LN2 = 1.44269504088896338700
ROUNDER = 6755399441055744.0  # 1.5 * 2^52: adding it rounds to an integer, which then lies in the lowest bits
TWO_52 = 4503599627370496.0
TWO_52_BITS = 0x4330000000000000
HALF_ROOT_BITS = 0x3FE6A09E667F3BCD  # of sqrt(1/2)
MANTISSA = 0x000FFFFFFFFFFFFF
ONE_BITS = 0x3FF0000000000000


@inside_kernel
def logarithm(x):
    """Natural logarithm of x, as if x were in [1e-300, 1e300] where it is not."""
    # x = 2^k m with m in [sqrt(1/2), sqrt(2)): k is counted up from that of sqrt(1/2), and shifted to be positive
    offset = np.float64(min(max(x, SMALLEST), LARGEST)).view(np.int64) - HALF_ROOT_BITS + ONE_BITS
    k = np.int64((offset >> 52) | TWO_52_BITS).view(np.float64) - (TWO_52 + 1023.0)
    f = np.int64((offset & MANTISSA) + HALF_ROOT_BITS).view(np.float64) - 1.0
    s = f / (2.0 + f)
    z = s * s
    w = z * z
    even = w * (0.3999999999940941908 + w * (0.2222219843214978396 + w * 0.1531383769920937332))
    odd = z * (
        0.6666666666666735130
        + w * (0.2857142874366239149 + w * (0.1818357216161805012 + w * 0.1479819860511658591))
    )
    half_square = 0.5 * f * f
    return k * LN2_HIGH - ((half_square - (s * (half_square + (even + odd)) + k * LN2_LOW)) - f)


@inside_kernel
def exponential(x):
    """Exponential of x, as if x were in [-690, 690] where it is not."""
    x = min(max(x, -LARGEST_EXPONENT), LARGEST_EXPONENT)
    shifted = x * OVER_LN2 + ROUNDER
    k = shifted - ROUNDER
    r = (x - k * LN2_HIGH) - k * LN2_LOW
    # Taylor's series on |r| <= ln(2)/2, in pairs of terms: these do not wait for each other as nested ones would
    s = r * r
    q = s * s
    series = (
        ((1 / 2 + r * (1 / 6)) + s * (1 / 24 + r * (1 / 120)))
        + q * ((1 / 720 + r * (1 / 5040)) + s * (1 / 40320 + r * (1 / 362880)))
        + q * q * ((1 / 3628800 + r * (1 / 39916800)) + s * (1 / 479001600 + r * (1 / 6227020800)))
    )
    y = 1.0 + (r + s * series)
    return y * np.int64((np.float64(shifted).view(np.int64) << 52) + ONE_BITS).view(np.float64)


@inside_kernel
def power(x, exponent):
    """x^exponent for x >= 0 and exponent > 0; relative error some 1e-16 (1 + |exponent ln x|)."""
    value = exponential(exponent * logarithm(x))
    return value if x > 0.0 else 0.0
