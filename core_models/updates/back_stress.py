"""The back stresses of a point, in the rows of a workspace."""

import math

from core_models.compilation import inside_kernel
from core_models.laws import back_stress_constants, back_stress_count
from core_models.rows import BACK_STRESS, get_symmetric, put_symmetric
from core_models.tensors import congruence, contract, minus, plus, scaled

NO_STRESS = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@inside_kernel
def turn_back_stresses(kinematic_hardening, turn, rows, k):
    """Turn the back stresses of point k by the rotation of the step."""
    for term in range(back_stress_count(kinematic_hardening)):
        row = BACK_STRESS + 6 * term
        put_symmetric(rows, row, k, congruence(turn, get_symmetric(rows, row, k)))


@inside_kernel
def kept(recovery, increment):
    """Part exp(-gamma dp) of a back stress that is left, and what a unit modulus adds: [1 - exp(-gamma dp)] / gamma."""
    left = math.exp(-recovery * increment)
    return left, -math.expm1(-recovery * increment) / recovery if recovery > 0.0 else increment


@inside_kernel
def recovered(kinematic_hardening, increment, rows, k):
    """Sum of alpha exp(-gamma dp), and its slope by dp with the sign changed [Pa]."""
    total, falling = NO_STRESS, NO_STRESS
    for term in range(back_stress_count(kinematic_hardening)):
        recovery = back_stress_constants(kinematic_hardening, term)[1]
        left, _gain = kept(recovery, increment)
        stress = scaled(get_symmetric(rows, BACK_STRESS + 6 * term, k), left)
        total = plus(total, stress)
        falling = plus(falling, scaled(stress, recovery))
    return total, falling


@inside_kernel
def recovered_before(kinematic_hardening, increment, direction, rows, k):
    """What `recovered` gave before `move_back_stresses`."""
    total, falling = NO_STRESS, NO_STRESS
    for term in range(back_stress_count(kinematic_hardening)):
        modulus, recovery = back_stress_constants(kinematic_hardening, term)
        _left, gain = kept(recovery, increment)
        stress = minus(get_symmetric(rows, BACK_STRESS + 6 * term, k), scaled(direction, modulus * gain))
        total = plus(total, stress)
        falling = plus(falling, scaled(stress, recovery))
    return total, falling


@inside_kernel
def reach(kinematic_hardening, increment):
    """Equivalent of what the increment of plastic strain adds to the back stresses, and its slope by dp [Pa]."""
    total, slope = 0.0, 0.0
    for term in range(back_stress_count(kinematic_hardening)):
        modulus, recovery = back_stress_constants(kinematic_hardening, term)
        left, gain = kept(recovery, increment)
        total += modulus * gain
        slope += modulus * left
    return total, slope


@inside_kernel
def move_back_stresses(kinematic_hardening, increment, direction, rows, k):
    """Advance the back stresses of point k by an increment of plastic strain along `direction` = xi / q(xi).

        alpha_1 = alpha exp(-gamma dp) + C [1 - exp(-gamma dp)] / gamma xi / q

    Exact for flow in one direction, whatever the size of the step.

    Returns
    -------
    change of the energy stored, 3 alpha:alpha / (4 C) in each [J/m^3]
    """
    stored = 0.0
    for term in range(back_stress_count(kinematic_hardening)):
        modulus, recovery = back_stress_constants(kinematic_hardening, term)
        left, gain = kept(recovery, increment)
        row = BACK_STRESS + 6 * term
        before = get_symmetric(rows, row, k)
        after = plus(scaled(before, left), scaled(direction, modulus * gain))
        put_symmetric(rows, row, k, after)
        stored += 0.75 * (contract(after, after) - contract(before, before)) / modulus
    return stored
