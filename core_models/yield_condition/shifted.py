"""The stress beyond the back stress, whose size a moving yield surface limits.

    xi_trial = s_trial - A(dp),   n = xi_trial / q(xi_trial),   q(xi) = q(xi_trial) - 3 G dp - R(dp)

with A what an increment dp of plastic strain leaves of the back stresses and R what it adds to them along n.
"""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.rotation import slightly_turned
from core_models.tensors import contract, equivalent_stress, minus, plus, scaled
from core_models.updates.back_stress import reach, recovered, recovered_before


class Shifted(NamedTuple):
    """At an increment dp of plastic strain: what is left of the back stresses, q(xi_trial) [Pa], direction n, and
    q(xi_trial) - R with its slope by dp [Pa].
    """

    rest: tuple
    falling: tuple
    size: float
    direction: tuple
    reached: float
    slope: float


@inside_kernel
def shifted(hardening, problem, increment, rows, k):
    """The shifted trial stress of a local problem whose back stresses stand in the rows as they were before."""
    rest, falling = recovered(hardening, increment, rows, k)
    return _seen(hardening, problem, increment, rest, falling)


@inside_kernel
def shifted_before(hardening, problem, deviator, increment, rows, k):
    """The same at the end of a return to a deviator, which has moved the back stresses."""
    direction = scaled(minus(problem.trial, deviator), 1.0 / (3.0 * problem.shear * increment))
    rest, falling = recovered_before(hardening, increment, direction, rows, k)
    return _seen(hardening, problem, increment, rest, falling)


@inside_kernel
def _seen(hardening, problem, increment, rest, falling):
    xi = minus(problem.trial, rest)
    size = equivalent_stress(xi)
    direction = scaled(xi, 1.0 / size if size > 0.0 else 0.0)
    added, added_slope = reach(hardening, increment)
    slope = 1.5 * contract(direction, falling) - added_slope
    return Shifted(rest, falling, size, direction, size - added, slope)


@inside_kernel
def shifted_change(rest, trial, spin):
    """Change of xi_trial at a constant increment, with that of the trial stress and the spin of the back stresses."""
    return minus(trial, scaled(minus(rest, slightly_turned(rest, spin)), 2.0))


@inside_kernel
def change_without_shift(hardening, problem, rows, k, trial, spin):
    """Change of the deviator where xi_trial is 0 and none may be left: what the back stresses take of it."""
    shift = shifted_change(recovered(hardening, 0.0, rows, k)[0], trial, spin)
    stiffness = 3.0 * problem.shear
    return minus(trial, scaled(shift, stiffness / (stiffness + reach(hardening, 0.0)[1])))


@inside_kernel
def deviator_change(now, problem, increment, shift, trial, shear, growth):
    """Change of s = s_trial - 3 G dp n, with that of xi_trial (`shift`), s_trial, G and dp (`growth`)."""
    xi = plus(shift, scaled(now.falling, growth))
    along = 1.5 * contract(now.direction, xi)
    over_size = 1.0 / now.size if now.size > 0.0 else 0.0
    turning = scaled(minus(xi, scaled(now.direction, along)), over_size)
    taken = plus(
        scaled(now.direction, 3.0 * (problem.shear * growth + shear * increment)),
        scaled(turning, 3.0 * problem.shear * increment),
    )
    return minus(trial, taken)
