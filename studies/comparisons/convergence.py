"""Limits of sequences of refinements: f(h) = f0 + a h^p by least squares, and how far to trust them.

Follows L. Eca, M. Hoekstra, "A procedure for the estimation of the numerical uncertainty of CFD calculations
based on grid refinement studies", J. Comput. Phys. 262 (2014) 104-130, with the uncertainty stated about the
extrapolated value instead of about the finest one.
"""

from dataclasses import dataclass

import numpy as np

LOWEST_ORDER = 0.5
HIGHEST_ORDER = 3.0
SURE_FACTOR = 0.5  # share of the gap still doubted when the sequence converges as it should
DOUBTFUL_FACTOR = 2.0  # ... and when it does not: order at a bound, or scatter as large as the changes


@dataclass(frozen=True)
class Estimate:
    """Limit of a sequence: value +- uncertainty, observed order (None: not observable), scatter, and how."""

    value: float
    uncertainty: float | None
    order: float | None
    scatter: float
    basis: str


def extrapolate(resolutions: list[int], values: list[float]) -> Estimate:
    """Limit of the values at infinite resolution.

    With h = 1/resolution: three or more values are fitted by f0 + a h^p, p in [0.5, 3]; two assume first
    order; one has no estimate of its uncertainty. Non-monotone sequences keep the finest value's
    neighbourhood and get an uncertainty of at least their spread.
    """
    order = np.argsort(resolutions)
    h = 1.0 / np.asarray(resolutions, dtype=float)[order]
    f = np.asarray(values, dtype=float)[order]
    if len(f) == 1:
        return Estimate(float(f[0]), None, None, 0.0, "one resolution: no estimate of its error")
    if len(f) == 2:
        return _from_two(h, f)
    return _from_several(h, f)


def _from_two(h: np.ndarray, f: np.ndarray) -> Estimate:
    gap = (f[1] - f[0]) / (h[0] / h[1] - 1.0)
    doubt = max(abs(gap), abs(f[1] - f[0]))
    return Estimate(float(f[1] + gap), float(doubt), None, 0.0, "two resolutions: first order assumed")


def _from_several(h: np.ndarray, f: np.ndarray) -> Estimate:
    spread = float(f.max() - f.min())
    if spread == 0.0:
        return Estimate(float(f[-1]), 0.0, None, 0.0, "all resolutions give the same value")
    limit, order, scatter = _fit(h, f)
    change = spread / (len(f) - 1)
    monotone = bool(np.all(np.diff(f) > 0) or np.all(np.diff(f) < 0))
    at_bound = order in (LOWEST_ORDER, HIGHEST_ORDER)
    gap = abs(limit - f[-1])
    sensitivity = _sensitivity(h, f, limit)
    if monotone and not at_bound and scatter < change:
        doubt = max(SURE_FACTOR * gap, sensitivity) + 2.0 * scatter
        return Estimate(limit, float(doubt), order, scatter, "least-squares order")
    if monotone:
        doubt = DOUBTFUL_FACTOR * gap + sensitivity + 2.0 * scatter
        return Estimate(limit, float(doubt), order, scatter, "order at the end of its range: doubtful")
    limit = float(np.clip(limit, f.min() - change, f.max() + change))
    doubt = max(spread, DOUBTFUL_FACTOR * abs(limit - f[-1])) + 2.0 * scatter
    return Estimate(limit, float(doubt), None, scatter, "not monotone: spread of the values")


def _fit(h: np.ndarray, f: np.ndarray) -> tuple[float, float, float]:
    """Limit, order and standard deviation of the weighted fit (weights 1/h: fine values count more)."""
    orders = np.linspace(LOWEST_ORDER, HIGHEST_ORDER, 251)
    fits = [_fit_at(h, f, p) for p in orders]
    best = int(np.argmin([residual for _, residual in fits]))
    limit, residual = fits[best]
    freedom = max(len(f) - 3, 1)
    return float(limit), float(orders[best]), float(np.sqrt(len(f) * residual / freedom))


def _fit_at(h: np.ndarray, f: np.ndarray, p: float) -> tuple[float, float]:
    weights = (1.0 / h) / (1.0 / h).sum()
    x = h**p
    x_mean, f_mean = weights @ x, weights @ f
    slope = weights @ ((x - x_mean) * (f - f_mean)) / (weights @ (x - x_mean) ** 2)
    limit = f_mean - slope * x_mean
    return limit, float(weights @ (limit + slope * x - f) ** 2)


def _sensitivity(h: np.ndarray, f: np.ndarray, limit: float) -> float:
    """Largest move of the limit when one value is left out (needs four values)."""
    if len(f) < 4:
        return 0.0
    kept = (np.delete(np.arange(len(f)), i) for i in range(len(f)))
    return max(abs(_fit(h[k], f[k])[0] - limit) for k in kept)
