"""Static answers from explicit dynamics: a body under loads that stay is damped until it rests."""

import math
from collections.abc import Callable
from typing import Any

from core_models.errors import RunFailure
from core_models.loads import Damping, Load
from core_models.material import Material
from meshes.mesh import Mesh

AT_REST = 1e-6  # share of kinetic energy in what the body has taken up
START = 0.5  # periods of the lowest natural mode before a body can pass for resting
LONGEST = 20.0  # periods


def relaxed(
    mesh: Mesh,
    material: Material,
    loads: tuple[Load, ...],
    make: Callable[[tuple[Load, ...]], Any],
    geometry: str | None = None,
    share: float = AT_REST,
) -> Any:
    """An explicit solver of either method whose body has come to rest under its loads.

        m a = f - 2 w m v

    with w the lowest natural angular frequency of the body on its supports, [rad/s]: damping that is critical for its
    slowest motion. Plastic strain keeps what the overshoot before has made of it: ramp the loads of a body that yields.

    make : takes the loads, damping included, and returns the solver, at rest and at time 0. geometry : as solvers take
    it. share : of kinetic energy in strain energy and plastic work at rest, in (0, 1).
    Raises RunFailure if it does not rest within LONGEST periods, SingularStiffness if nothing holds it.
    Source: Underwood, Dynamic relaxation, in Computational Methods for Transient Analysis (1983).
    """
    import fem

    still = fem.ImplicitSolver(mesh, material, geometry=geometry, loads=loads, increment=1.0)
    frequency = still.lowest_frequency()
    period = 2.0 * math.pi / frequency
    solver = make((*loads, Damping(2.0 * frequency)))
    found = math.inf
    while solver.time < LONGEST * period:
        solver.advance(LONGEST * period)
        taken = solver.ledger.strain + solver.ledger.plastic
        found = solver.ledger.kinetic / taken if taken > 0.0 else 0.0
        if solver.time >= START * period and found <= share:
            return solver
    raise RunFailure(
        f"the body does not come to rest within {LONGEST:g} periods of its lowest mode: kinetic energy is still "
        f"{100.0 * found:.2g} % of what it has taken up; loads that stay constant, or a larger 'share', may let it"
    )
