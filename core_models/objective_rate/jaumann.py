"""The rate of Zaremba and Jaumann."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.rotation import asymmetry
from core_models.tensors import congruence, plus, symmetric_part, transposed
from core_models.updates.corotation import (
    corotated,
    corotated_change,
    gradient_change,
    half_spin,
    half_turned,
    stretch_gradient,
    turned_back,
    whole_spin,
)


class Jaumann(NamedTuple):
    """The rate of Zaremba and Jaumann: the stress turns with the spin W of the material. A negative control.

        s_trial = Q H [H s_n H^T + 2 G dev(d)] H^T Q^T,   H = cay(W / 2),   d + W = 2 (U - V_0) (U + V_0)^-1

    with d and W the symmetric and the other part, in the frame before the step, and Q that of `HypoelasticPlastic`.

    In simple shear the stress oscillates, s_12 = G sin(gamma): use it to see that, not to compute with it.
    Valid for any rotation in a step. Source: Zaremba (1903), Jaumann (1911); Dienes, Acta Mech. 32 (1979) 217.
    """


@inside_kernel
def _half(vector):
    return (0.5 * vector[0], 0.5 * vector[1], 0.5 * vector[2])


@corotated.register(Jaumann)
def _(objective_rate, before, after, increment):
    gradient = stretch_gradient(before, after)
    turn, whole = half_turned(_half(asymmetry(gradient)), increment)
    return congruence(transposed(turn), symmetric_part(gradient)), whole


@corotated_change.register(Jaumann)
def _(objective_rate, before, after, over_sum, change, spin):
    gradient, moved = stretch_gradient(before, after), gradient_change(before, over_sum, change)
    vector = _half(asymmetry(gradient))
    turn = half_turned(vector, (1.0, 0.0, 0.0, 0.0))[0]
    half = half_spin(vector, _half(asymmetry(moved)))
    strain = congruence(transposed(turn), symmetric_part(gradient))
    strain_change = plus(congruence(transposed(turn), symmetric_part(moved)), turned_back(strain, half))
    return strain_change, whole_spin(turn, spin, half)
