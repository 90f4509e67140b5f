"""What every manufactured solution gives: a motion, and the body force that makes it a solution."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

Field = Callable[[np.ndarray, float], np.ndarray]


@dataclass(frozen=True)
class ManufacturedSolution:
    """A motion x = X + u(X, t) of a compressible neo-Hookean body, div P + rho0 b = rho0 a.

        P = mu (F - F^-T) + lambda ln J F^-T

    density : rho0 [kg/m^3]. young [Pa], poisson [-]. end : time of comparison [s].
    displacement [m], velocity [m/s], body_force [m/s^2] : functions of reference positions (n, d) [m] and time [s],
    returning (n, d).
    """

    density: float
    young: float
    poisson: float
    end: float
    displacement: Field
    velocity: Field
    body_force: Field

    @property
    def shear(self) -> float:
        """mu [Pa]."""
        return 0.5 * self.young / (1.0 + self.poisson)

    @property
    def lame(self) -> float:
        """lambda [Pa]."""
        return self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))

    @property
    def bulk(self) -> float:
        """K = lambda + 2 mu / 3 [Pa]."""
        return self.lame + 2.0 * self.shear / 3.0
