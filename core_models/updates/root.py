"""The next guess of a root within a bracket."""

import math

from core_models.compilation import inside_kernel


@inside_kernel
def next_guess(guess, residual, slope, low, high):
    """Newton's next guess of the root of a residual that falls with a positive unknown, kept between low and high.

    A residual that is steep near 0, as of a flow stress that grows with the logarithm of the rate, is negative right of
    the root: there a step in the logarithm of the unknown does not overshoot. A guess out of the bracket halves it.
    """
    step = -residual / slope
    better = guess + step if residual > 0.0 else guess * math.exp(min(step / guess, 0.0))
    return better if low < better < high else 0.5 * (low + high)
