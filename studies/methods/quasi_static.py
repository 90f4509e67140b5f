"""Quasi-static answers from explicit dynamics: mass scaled to the loading time, kinetic energy watched."""

import math
from dataclasses import replace

from core_models.errors import RunFailure, UnsupportedError
from core_models.loads import Load
from core_models.material import Material
from core_models.specific_heat.constant import ConstantSpecificHeat
from meshes.mesh import Mesh

# Of kinetic energy in what the body has taken up; with 0.5 % a neck is 4 % wider than it is without inertia.
LARGEST_SHARE = 0.002


def slow_enough(
    mesh: Mesh,
    material: Material,
    loads: tuple[Load, ...],
    duration: float,
    periods: float,
    geometry: str | None = None,
) -> Material:
    """The material with its mass scaled so that loading takes so many periods of the body's lowest natural mode.

        density = density_0 (duration w / (2 pi periods))^2

    duration : of the loading [s]. geometry : as the solvers take it. The time step grows as the root of the density, so
    that the number of steps is that of `periods` periods of the real body, while rate-dependent laws see the real
    rates. The heat capacity of the volume stays. Only for laws whose stress does not depend on the density;
    UnsupportedError for a specific heat that varies.
    """
    import fem

    solver = fem.ImplicitSolver(mesh, material, geometry=geometry, loads=loads, increment=duration)
    frequency = solver.lowest_frequency()
    factor = duration * frequency / (2.0 * math.pi * periods)
    heat = material.specific_heat
    if heat is not None:
        if not isinstance(heat, ConstantSpecificHeat):
            raise UnsupportedError(
                f"mass cannot be scaled with the specific heat {type(heat).__name__}: give a constant specific_heat"
            )
        heat = ConstantSpecificHeat(heat.value / factor**2)
    return replace(material, density=material.density * factor**2, specific_heat=heat)


class KineticWatch:
    """The largest share of kinetic energy while loads act, after their start.

    start : time from which it counts [s]: at first everything elastic moves. share : found so far [-].
    """

    def __init__(self, start: float) -> None:
        self._start = start
        self.share = 0.0

    def look(self, solver) -> None:
        """Take the share at the solver's time."""
        ledger = solver.ledger
        taken = ledger.strain + ledger.plastic
        if solver.time >= self._start and taken > 0.0:
            self.share = max(self.share, ledger.kinetic / taken)

    def check(self) -> None:
        """Refuse to call a run quasi-static that moved too fast; RunFailure with the share."""
        if not self.share <= LARGEST_SHARE:
            raise RunFailure(
                f"kinetic energy is up to {100.0 * self.share:.2g} % of what the body has taken up, more than "
                f"{100.0 * LARGEST_SHARE:g} %: the run is not quasi-static; load over more periods, or solve implicitly"
            )
