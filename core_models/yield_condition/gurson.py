"""Yield condition of porous metals after Gurson, Tvergaard and Needleman."""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import beside_kernel
from core_models.laws import damage_of_porosity
from core_models.tensors import contract, equivalent_stress, plus, scaled
from core_models.updates.general_problem import (
    ELASTIC,
    Returned,
    mean_stress,
    return_change,
    return_stress,
    status_of,
    strength,
    unchanged,
)
from core_models.yield_condition.gurson_flow import CLOSED, flowing, porosity_of, residual_change, solved
from core_models.yield_condition.gurson_return import search
from core_models.yield_condition.gurson_surface import (
    accelerated_porosity,
    full_porosity,
    largest_effective,
    yield_function,
)

POROUS, POWERLESS = 1, 2  # regimes: plastic flow, a matrix without strength


class Gurson(NamedTuple):
    """Gurson-Tvergaard-Needleman: a matrix of flow stress sigma_y with voids of volume fraction f.

        (q / sigma_y)^2 + 2 q1 f* cosh(3 q2 m / (2 sigma_y)) <= 1 + q3 f*^2
        f* = f up to f_c, f_c + k (f - f_c) beyond;   (1 - f) sigma_y d ep = q d e_q + m d v_p
        d f = (1 - f) d v_p + A(ep) d ep

    with associated flow; q is von Mises' stress, m the mean stress, ep the plastic strain of the matrix, e_q the
    deviatoric one of the body, v_p the plastic change of its volume. A is that of the damage law `VoidNucleation`.

    Parameters
    ----------
    q1, q2, q3 : Tvergaard's constants [-], > 0; usually 1.5, 1, q1^2. k : acceleration of the coalescence [-], >= 1.
    f_c : porosity where it begins [-], 0 < f_c < 1.

    Voids that pressure has closed stay closed. f* is held at 99 % of the porosity at which the surface has shrunk to a
    point, where the damage is 1.
    Source: Gurson, J. Eng. Mater. Technol. 99 (1977) 2; Tvergaard & Needleman, Acta Metall. 32 (1984) 157; the unknowns
    of the return: Aravas, Int. J. Numer. Methods Eng. 24 (1987) 1395.
    """

    q1: float
    q2: float
    q3: float
    k: float
    f_c: float

    has_plastic_volume = True

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        largest = float(full_porosity(self))
        if not self.f_c < largest:
            return f"at f_c = {self.f_c:g} nothing carries any more: give less than {largest:g}"
        return ""


@damage_of_porosity.register(Gurson)
def _(yield_condition, porosity, damage):
    share = accelerated_porosity(yield_condition, porosity) / largest_effective(yield_condition)
    return np.maximum(damage, np.minimum(share, 1.0))


@return_stress.register(Gurson)
def _(yield_condition, model, flow, problem, rows, k):
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    mises = equivalent_stress(problem.trial)
    start = strength(flow, problem, 0.0).stress
    porosity = problem.porosity if problem.porosity > CLOSED else 0.0
    if start > 0.0 and yield_function(yield_condition, mises, stress, start, porosity) <= 0.0:
        return unchanged(problem, stress, bulk)
    return _plastic(yield_condition, model, flow, problem, mises, stress, bulk)


@beside_kernel
def _plastic(law, model, flow, problem, mises, stress, bulk):
    """Return of a trial outside the surface; a matrix without strength, as above its melting point, is a fluid."""
    has_converged, has_strength, now = search(law, model, flow, problem, mises, bulk)
    if not has_strength:
        return Returned(
            status_of(True), POWERLESS, scaled(problem.trial, 0.0), problem.volume, stress, bulk, 0.0,
            problem.hardening_variable, problem.porosity, 0.0,
        )  # fmt: skip
    factor = now.mises / mises if mises > 0.0 else 1.0
    return Returned(
        status_of(has_converged), POROUS, scaled(problem.trial, factor), problem.volume - now.volume,
        now.mean_stress, now.bulk, now.increment, now.variable, porosity_of(now.voids), 0.0,
    )  # fmt: skip


@return_change.register(Gurson)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    if returned.regime == POWERLESS:
        return scaled(trial, 0.0), mean
    return _plastic_change(yield_condition, model, flow, problem, returned, trial, shear, mean)


@beside_kernel
def _plastic_change(law, model, flow, problem, returned, trial, shear, mean):
    """Change of the deviator and of the mean stress, from the slopes of the residuals."""
    size, mises = equivalent_stress(problem.trial), equivalent_stress(returned.deviator)
    shape = (size - mises) / (3.0 * problem.shear)
    now = flowing(model, flow, problem, size, shape, -math.log1p(-returned.porosity), returned.increment)
    size_change = 1.5 * contract(problem.trial, trial) / size if size > 0.0 else 0.0
    bare = size_change - 3.0 * shape * shear
    right = residual_change(law, problem, now, 0.0, 0.0, 0.0, bare, mean)
    change, _is_solved = solved(law, problem, now, right)
    mises_change = bare + 3.0 * problem.shear * change[0]
    mean_change = mean + now.bulk * (change[1] + now.nucleation * change[2])
    factor = mises / size if size > 0.0 else 1.0
    along = (mises_change - factor * size_change) / size if size > 0.0 else 0.0
    return plus(scaled(trial, factor), scaled(problem.trial, along)), mean_change
