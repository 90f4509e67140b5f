"""Drucker-Prager yield condition with dilation, apex and tension cut-off."""

import math
from typing import NamedTuple, Self

from core_models.compilation import beside_kernel, inside_kernel
from core_models.errors import MaterialError
from core_models.names import suggestion
from core_models.tensors import contract, plus, scaled
from core_models.updates.general_problem import (
    ELASTIC,
    Returned,
    allowance,
    mean_stress,
    return_change,
    return_stress,
    second_invariant_root,
    status_of,
    strength,
    unchanged,
    volume_at,
)

MAXIMUM_ITERATIONS = 100
OVER_ROOT_3 = 1.0 / math.sqrt(3.0)
CONE, EDGE, PLANE = (
    1,
    2,
    3,
)  # regimes: the cone, the cone where the mean stress is the largest, that stress alone
FITS = ("compression", "extension", "plane-strain")


class DruckerPrager(NamedTuple):
    """Drucker-Prager: sqrt(J_2) + alpha I_1 <= k, flow along sqrt(J_2) + beta I_1, mean stress <= tension_cutoff.

        k = cohesion_factor sigma_y
        d e_p = dgamma s / (2 sqrt(J_2)),   d v_p = 3 beta dgamma,   d ep = dgamma / sqrt(3)

    sigma_y is the material's flow law: with cohesion_factor 1 it gives k, with that of `from_friction` the cohesion c.
    At the apex m = k / (3 alpha), and at the cut-off, the volume grows as it must. I_1 is the trace of the stress,
    positive in tension.

    Parameters
    ----------
    alpha : friction [-], >= 0. beta : dilation [-], 0 <= beta <= alpha. cohesion_factor : k / sigma_y [-], > 0.
    tension_cutoff : largest mean stress [Pa], > 0; infinite for none.

    Valid with flow laws that feel no rate. Hardening is by the deviatoric plastic strain, as everywhere here.
    Source: Drucker & Prager, Q. Appl. Math. 10 (1952) 157; de Souza Neto, Peric & Owen, Computational Methods for
    Plasticity (2008), section 8.3 (return to cone and apex).
    """

    alpha: float
    beta: float
    cohesion_factor: float = 1.0
    tension_cutoff: float = math.inf

    has_plastic_volume = True

    @classmethod
    def from_friction(
        cls, friction: float, dilation: float, fit: str = "compression", tension_cutoff: float = math.inf
    ) -> Self:
        """The cone that meets Mohr-Coulomb's pyramid in triaxial compression or extension, or in plane strain.

        Parameters
        ----------
        friction, dilation : angles [degree], 0 <= dilation <= friction < 90. fit : 'compression', 'extension' or
        'plane-strain' (the associated failure load). tension_cutoff : [Pa].

        Raises MaterialError outside these ranges.
        """
        if not 0.0 <= dilation <= friction < 90.0:
            raise MaterialError(
                f"friction {friction!r} and dilation {dilation!r} degrees: give 0 <= dilation <= friction < 90"
            )
        if fit not in FITS:
            raise MaterialError(f"unknown fit '{fit}'; {suggestion(fit, FITS)}")
        alpha, factor = _matched(math.radians(friction), fit)
        beta, _factor = _matched(math.radians(dilation), fit)
        return cls(alpha, beta, factor, tension_cutoff)

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if self.beta > self.alpha:
            return (
                f"the dilation beta = {self.beta:g} is above the friction alpha = {self.alpha:g}, which would create "
                "energy: give beta <= alpha"
            )
        return ""


def _matched(angle: float, fit: str) -> tuple[float, float]:
    """alpha and k / c of a friction angle [rad]."""
    s, c = math.sin(angle), math.cos(angle)
    if fit == "plane-strain":
        root = math.sqrt(9.0 + 12.0 * math.tan(angle) ** 2)
        return math.tan(angle) / root, 3.0 / root
    side = 3.0 - s if fit == "compression" else 3.0 + s
    return 2.0 * s * OVER_ROOT_3 / side, 6.0 * c * OVER_ROOT_3 / side


@return_stress.register(DruckerPrager)
def _(yield_condition, model, flow, problem, rows, k):
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    size = second_invariant_root(problem.trial)
    cone = yield_condition.cohesion_factor * strength(flow, problem, 0.0).stress
    if size + 3.0 * yield_condition.alpha * stress <= cone and stress <= yield_condition.tension_cutoff:
        return unchanged(problem, stress, bulk)
    return _search(yield_condition, model, flow, problem, size)


@beside_kernel
def _search(yield_condition, model, flow, problem, size):
    """Return to the cone; where that ends beyond the largest mean stress, to this, along the cone as far as needed."""
    regime = CONE
    converged, gamma, volume, stress, bulk = _cone(yield_condition, model, flow, problem, size)
    k = yield_condition.cohesion_factor * strength(flow, problem, gamma * OVER_ROOT_3).stress
    if not converged or stress > _largest(yield_condition, k):
        converged, gamma, k = _corner(yield_condition, flow, problem, size)
        regime = EDGE if gamma > 0.0 else PLANE
        scale = allowance(problem, k + size, bulk)
        volume, stress, bulk = volume_at(model.eos, problem, _largest(yield_condition, k), scale)
        converged = converged and abs(stress - _largest(yield_condition, k)) <= scale
    factor = 1.0 if size == 0.0 else max(1.0 - problem.shear * gamma / size, 0.0)
    increment = gamma * OVER_ROOT_3
    return Returned(
        status_of(converged), regime, scaled(problem.trial, factor), volume, stress, bulk, increment,
        strength(flow, problem, increment).variable, problem.porosity, 0.0,
    )  # fmt: skip


@inside_kernel
def _largest(yield_condition, k):
    """Largest mean stress: of the cut-off or the apex."""
    slope = 3.0 * yield_condition.alpha
    return min(yield_condition.tension_cutoff, k / slope if slope > 0.0 else math.inf)


@beside_kernel
def _cone(yield_condition, model, flow, problem, size):
    """Root of sqrt(J_2) - G dgamma + 3 alpha m(ln J_e - 3 beta dgamma) - k(dgamma), which falls with dgamma."""
    a, b = 3.0 * yield_condition.alpha, 3.0 * yield_condition.beta
    low, high = 0.0, size / problem.shear
    gamma = 0.0
    for _iteration in range(MAXIMUM_ITERATIONS):
        volume = problem.volume - b * gamma
        stress, bulk = mean_stress(model.eos, problem, volume)
        now = strength(flow, problem, gamma * OVER_ROOT_3)
        k = yield_condition.cohesion_factor * now.stress
        residual = size - problem.shear * gamma + a * stress - k
        if abs(residual) <= allowance(problem, k + size, bulk):
            return True, gamma, volume, stress, bulk
        slope = -problem.shear - a * b * bulk - yield_condition.cohesion_factor * now.slope * OVER_ROOT_3
        if residual > 0.0:
            low = gamma
        else:
            high = gamma
        if high - low <= 1e-15 * size / problem.shear:
            return False, gamma, volume, stress, bulk
        gamma -= residual / slope
        if not low < gamma < high:
            gamma = 0.5 * (low + high)
    return False, gamma, problem.volume, 0.0, 0.0


@beside_kernel
def _corner(yield_condition, flow, problem, size):
    """Flow where the mean stress is the largest: root of sqrt(J_2) - G dgamma - [k - 3 alpha m]."""
    low, high = 0.0, size / problem.shear
    gamma = 0.0
    for _iteration in range(MAXIMUM_ITERATIONS):
        now = strength(flow, problem, gamma * OVER_ROOT_3)
        k = yield_condition.cohesion_factor * now.stress
        room = k - 3.0 * yield_condition.alpha * _largest(yield_condition, k)
        residual = size - problem.shear * gamma - room
        limit = allowance(problem, k + size, 0.0)
        if abs(residual) <= limit or (gamma == 0.0 and residual <= 0.0):
            return True, gamma, k
        hardening = yield_condition.cohesion_factor * now.slope * OVER_ROOT_3
        slope = -problem.shear - (0.0 if _is_apex(yield_condition, k) else hardening)
        if residual > 0.0:
            low = gamma
        else:
            high = gamma
        gamma -= residual / slope
        if not low < gamma < high:
            gamma = 0.5 * (low + high)
    return False, gamma, 0.0


@inside_kernel
def _is_apex(yield_condition, k):
    """Whether the largest mean stress is that of the apex."""
    return 3.0 * yield_condition.alpha * yield_condition.tension_cutoff >= k


@return_change.register(DruckerPrager)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    if returned.regime == PLANE:
        return trial, 0.0
    size = second_invariant_root(problem.trial)
    size_change = 0.5 * contract(problem.trial, trial) / size
    gamma = returned.increment / OVER_ROOT_3
    now = strength(flow, problem, returned.increment)
    hardening = yield_condition.cohesion_factor * now.slope * OVER_ROOT_3
    a, b = 3.0 * yield_condition.alpha, 3.0 * yield_condition.beta
    if returned.regime == CONE:
        gamma_change = size_change - gamma * shear + a * mean
        gamma_change /= problem.shear + a * b * returned.bulk + hardening
        mean_change = mean - returned.bulk * b * gamma_change
    else:
        is_apex = _is_apex(yield_condition, yield_condition.cohesion_factor * now.stress)
        gamma_change = (size_change - gamma * shear) / (problem.shear + (0.0 if is_apex else hardening))
        mean_change = hardening * gamma_change / a if is_apex else 0.0
    factor = 1.0 - problem.shear * gamma / size
    taken = shear * gamma + problem.shear * (gamma_change - gamma * size_change / size)
    return plus(scaled(trial, factor), scaled(problem.trial, -taken / size)), mean_change
