"""Heat conduction: what both methods have in common.

Fourier's law in the current configuration, q = - k grad T, changes the temperatures of the points and nothing else: the
internal energy of an equation of state is that of the mechanical work, as if no heat were conducted. With N_i the shape
functions of the nodes, m c the heat capacities of the points and V their current volumes,

    C_i = sum_p m_p c_p N_i,   dT_i = dt [- sum_p V_p k (grad T)_p . grad N_i + Q_i] / C_i,   T_p += sum_i N_i dT_i

where Q_i comes in through boundaries. Points take increments, so without conductivity they are exactly adiabatic.
What the points hold beyond what nodes can tell apart, T_p - sum_i N_i T_i, does not flow between nodes; it decays at
the rate of conduction over a cell, k / (rho c h^2), by which it keeps its heat within the nodes round it.
"""

import logging
import math

import numpy as np

from core_models.arguments import check_between
from core_models.compilation import CHUNK, material_kernel
from core_models.errors import MaterialError, SceneError
from core_models.laws import heat_capacity
from core_models.loads import FixedTemperature, HeatFlux, Load, at_time
from core_models.material import Material
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.von_mises import VonMises

LEAST_OF_METALS = 5.0  # W/(m K); alloys of titanium have 6 to 7

log = logging.getLogger(__name__)


def missing_tags(material: Material) -> list[str]:
    """Tags that the material's card lacks for conduction."""
    needed = {
        "thermal_conductivity": material.thermal_conductivity,
        "specific_heat": material.specific_heat,
    }
    return [tag for tag, value in needed.items() if value is None]


def check_conduction(material: Material) -> None:
    """Refuse a material that cannot conduct heat; MaterialError naming the tags that its card lacks.

    Of a metal whose conductivity is none of a metal's it warns.
    """
    missing = " and ".join(f"<{tag}>" for tag in missing_tags(material))
    if missing:
        raise MaterialError(
            f"{material.name}: conduction needs {missing}, which the card lacks: add it, or turn conduction off"
        )
    if flows_as_metal(material) and material.thermal_conductivity < LEAST_OF_METALS:
        log.warning(
            "%s: a thermal_conductivity of %g W/(m K) is less than that of any metal (%g and more; copper 386): check "
            "the card",
            material.name,
            material.thermal_conductivity,
            LEAST_OF_METALS,
        )


def flows_as_metal(material: Material) -> bool:
    """Whether a material yields as metals do, by von Mises' or Gurson's condition."""
    return isinstance(material.yield_condition, VonMises | Gurson)


def thermal_loads(loads: tuple[Load, ...]) -> tuple[list[FixedTemperature], list[HeatFlux]]:
    """The fixed temperatures and the fluxes among the loads.

    Raises SceneError for a temperature that is not above 0 K at the start, a flux that is no number, and for more than
    one of either on the same boundary.
    """
    held = [load for load in loads if isinstance(load, FixedTemperature)]
    fluxes = [load for load in loads if isinstance(load, HeatFlux)]
    for load in held:
        held_temperature(load, 0.0)
    for load in fluxes:
        check_between(f"HeatFlux on {load.boundary!r}", at_time(load.flux, 0.0), -math.inf, math.inf, "W/m^2")
    names = [load.boundary for load in (*held, *fluxes)]
    for name in dict.fromkeys(names):
        if names.count(name) > 1:
            raise SceneError(
                f"boundary {name!r} is given {names.count(name)} temperatures or fluxes: give one "
                "(the sum, if several fluxes act)"
            )
    return held, fluxes


def held_temperature(load: FixedTemperature, time: float) -> float:
    """Temperature [K] of a boundary at a time [s]; SceneError for one that is not above 0 K."""
    what = f"FixedTemperature on {load.boundary!r} at t = {time:.6g} s"
    return check_between(what, at_time(load.temperature, time), 0.0, math.inf, "K")


@material_kernel
def fill_capacities(first, last, law, density, volumes, temperature, capacities):
    """Heat capacities m c(T) (n,) [J/K] of the points of chunks first ... last-1, of CHUNK each.

    law : specific heat. density : [kg/m^3] and volumes (n,) [m^3] of the reference body. temperature : (n,) [K].
    """
    for i in range(first * CHUNK, min(last * CHUNK, capacities.shape[0])):
        capacities[i] = density * volumes[i] * heat_capacity(law, temperature[i])


class Capacities:
    """Heat capacities (n,) [J/K] of points, brought up to date by `fill`."""

    def __init__(self, points) -> None:
        self._points = points
        self.values = np.zeros(points.n)

    def fill(self, temperature: np.ndarray) -> np.ndarray:
        """The capacities at temperatures (n,) [K]."""
        points = self._points
        points.threads.run(
            fill_capacities, -(-points.n // CHUNK), points.material.specific_heat, points.material.density,
            points.reference_volumes, temperature, self.values,
        )  # fmt: skip
        return self.values
