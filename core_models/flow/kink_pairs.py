"""Rate-dependent part of the Steinberg-Lund flow stress: kink pairs on dislocations against the Peierls stress."""

import math

from core_models.compilation import inside_kernel
from core_models.elementary import exponential, logarithm

LOWEST_RATE = 1e-10  # 1/s; below it the stress is some 1e-6 Pa and a straight line
LOWEST_TEMPERATURE = 1.0  # K
SMALLEST = 1e-12  # keeps a division from failing whose result is not used
STEPS = 8  # to round-off at the worst; the error of S is at most 1 at the start
CLOSE = 1e-8  # relative, of the last step: the next would be its square


@inside_kernel
def kink_pair_stress(flow, plastic_rate, temperature):
    """Stress that drives kink pairs at a plastic rate, and its slopes in rate and temperature.

    Solves  rate {exp[a (1 - x)^2] / C1 + D / x} = S(x) = 1  for x = sigma_T / sigma_P in [0, 1], with
    a = 2 U_k / (k T) and D = C2 / sigma_P; x = 1 where the rate is too high for any root.

    `flow` holds C1 [1/s], C2 [Pa s], energy_to_form_kink_pair and Boltzmann_constant (one unit of energy), and
    Peierls_stress [Pa] > 0.
    """
    rate = max(plastic_rate, LOWEST_RATE)
    temperature = max(temperature, LOWEST_TEMPERATURE)
    a = 2.0 * flow.energy_to_form_kink_pair / (flow.Boltzmann_constant * temperature)
    drag = flow.C2 / flow.Peierls_stress
    # Each of the two terms alone gives a lower bound of the root. From there the tangent of the first, with the second
    # as it is, gives the next: the first is convex, so that no step can overshoot.
    activated = 1.0 - math.sqrt(max(logarithm(flow.C1 / rate), 0.0) / a)
    x = min(max(activated, drag * rate), 1.0)
    for _step in range(STEPS):
        kinks = rate / flow.C1 * exponential(a * (1.0 - x) * (1.0 - x))
        tangent = 2.0 * a * (1.0 - x) * kinks
        b = 1.0 - kinks - tangent * x
        root = math.sqrt(b * b + 4.0 * tangent * rate * drag)
        root = 2.0 * rate * drag / (b + root) if b > 0.0 else (root - b) / max(2.0 * tangent, SMALLEST)
        before, x = x, min(root, 1.0)
        if x - before <= CLOSE * x:
            break
    is_free = rate / flow.C1 + rate * drag < 1.0
    x = x if is_free else 1.0
    kinks = rate / flow.C1 * exponential(a * (1.0 - x) * (1.0 - x))
    slowing = rate * drag / x
    fall = 2.0 * a * (1.0 - x) * kinks + slowing / x
    by_rate = flow.Peierls_stress / (rate * fall) if is_free else 0.0
    by_temperature = (
        -flow.Peierls_stress * a * (1.0 - x) * (1.0 - x) * kinks / (temperature * fall) if is_free else 0.0
    )
    stress = flow.Peierls_stress * x
    is_straight = plastic_rate < LOWEST_RATE
    share = plastic_rate / rate
    return (
        stress * share if is_straight else stress,
        stress / rate if is_straight else by_rate,
        by_temperature * share if is_straight else by_temperature,
    )
