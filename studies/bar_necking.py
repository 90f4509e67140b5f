"""The bar necking study: the scene, what is measured while a bar is pulled, and the quantities, by name."""

import math
from dataclasses import dataclass

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.voce import Voce
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises

HYPERELASTIC, HYPOELASTIC = "hyperelastic", "hypoelastic"


@dataclass(frozen=True)
class NeckingScene:
    """A round bar pulled at both ends, of which half is simulated; its ends are free to contract.

    radius, length (of the half), pull (of each end) [m]; taper: radius at the neck over that at the end; duration [s].
    """

    name: str
    material: Material
    radius: float
    length: float
    taper: float
    pull: float
    duration: float = 1.0


def simo_steel(update: str = HYPERELASTIC) -> Material:
    """The steel of the necking bar: E = 206.9 GPa, nu = 0.29, Voce hardening with a linear term.

    Source: Simo, Comput. Methods Appl. Mech. Eng. 99 (1992) 61.
    """
    bulk, shear, flow = 164.206e9, 80.1938e9, Voce(0.45e9, 0.715e9, 16.93, 0.12924e9)
    laws = {
        HYPERELASTIC: (HyperelasticPlastic(), NeoHookean(bulk)),
        HYPOELASTIC: (HypoelasticPlastic(), DefaultHypoelastic(bulk)),
    }
    stress_update, eos = laws[update]
    return Material("steel", 7800.0, stress_update, IsotropicElastic(bulk, shear), eos, flow, VonMises())


NECKING_SIMO = NeckingScene("necking-simo", simo_steel(), 6.413e-3, 26.667e-3, 0.982, 7e-3)


class NeckingHistory:
    """What is measured while the bar is pulled, row by row.

    Columns: elongation of the half and force of the whole bar, neck_radius; centre and surface of the neck's section:
    plastic strain and triaxiality (mean over equivalent stress), flow_stress (equivalent, at the centre); bridgman: the
    flow stress that Bridgman's formula gives for the mean axial stress and the profile of the neck.
    """

    COLUMNS = (
        "elongation", "force", "neck_radius", "centre_plastic_strain", "centre_triaxiality", "surface_plastic_strain",
        "surface_triaxiality", "flow_stress", "bridgman",
    )  # fmt: skip

    def __init__(self, solver) -> None:
        self._start = float(solver.boundary_positions("end")[:, -1].mean())
        places = solver.reference_positions
        edge = np.zeros(places.shape[1])
        edge[0] = solver.boundary_positions("neck")[:, 0].max()
        self._centre = int(np.linalg.norm(places, axis=1).argmin())
        self._surface = int(np.linalg.norm(places - edge, axis=1).argmin())
        self.rows: list[tuple[float, ...]] = []

    def add(self, solver, force: float) -> None:
        """A row for the present state and a force [N] at the end."""
        neck = float(solver.boundary_positions("neck")[:, 0].max())
        mean = force / (math.pi * neck**2)
        state = solver.points.old
        equivalent, triaxiality = _stress_state(state.stress[[self._centre, self._surface]])
        self.rows.append(
            (
                float(solver.boundary_positions("end")[:, -1].mean()) - self._start,
                force,
                neck,
                float(state.equivalent_plastic_strain[self._centre]),
                float(triaxiality[0]),
                float(state.equivalent_plastic_strain[self._surface]),
                float(triaxiality[1]),
                float(equivalent[0]),
                mean * bridgman_factor(neck, neck_curvature(solver.boundary_positions("side"))),
            )  # fmt: skip
        )

    def column(self, name: str) -> np.ndarray:
        """A column by name."""
        return np.array([row[self.COLUMNS.index(name)] for row in self.rows])


def _stress_state(stress: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Equivalent stress (n,) [Pa] and triaxiality (n,) of stresses (n, 6)."""
    mean = stress[:, :3].mean(axis=1)
    deviator = stress[:, :3] - mean[:, None]
    equivalent = np.sqrt(1.5 * (deviator**2).sum(axis=1) + 3.0 * (stress[:, 3:] ** 2).sum(axis=1))
    return equivalent, mean / np.maximum(equivalent, np.finfo(float).tiny)


def neck_curvature(side: np.ndarray) -> float:
    """Curvature [1/m] of a bar's profile (k, 2) at the neck, z = 0: of the parabola through its first half radius."""
    r, z = side[:, 0], side[:, -1]
    near = z <= max(0.5 * r.min(), np.sort(z)[2])
    return max(2.0 * float(np.polyfit(z[near] ** 2, r[near], 1)[0]), 0.0)


def bridgman_factor(radius: float, curvature: float) -> float:
    """Flow stress over mean axial stress in a neck: 1 / [(1 + 2 R / a) ln(1 + a / 2 R)].

    radius : a of the section [m]. curvature : 1 / R of the profile [1/m], >= 0.
    Source: Bridgman, Studies in Large Plastic Flow and Fracture (1952).
    """
    ratio = 0.5 * radius * curvature
    return ratio / ((1.0 + ratio) * math.log1p(ratio)) if ratio > 1e-9 else 1.0


def peak(history: NeckingHistory) -> tuple[float, float]:
    """Elongation of the half [m] at the largest force, and that force [N], on the parabola of the three largest."""
    u, force = history.column("elongation"), history.column("force")
    i = min(max(int(force.argmax()), 1), len(force) - 2)
    a, b, c = np.polyfit(u[i - 1 : i + 2] - u[i], force[i - 1 : i + 2], 2)
    return float(u[i] - 0.5 * b / a), float(c - 0.25 * b * b / a)


def at_elongation(history: NeckingHistory, column: str, elongation: float) -> float | None:
    """Value of a column at an elongation of the half [m]; None where the run did not get there."""
    u = history.column("elongation")
    return (
        float(np.interp(elongation, u, history.column(column)))
        if u[-1] >= elongation * (1.0 - 1e-9)
        else None
    )


def uniform_peak(material: Material, radius: float) -> float:
    """Largest force [N] of a bar that stays a cylinder, in closed form but for a maximum of one variable.

    F = A_0 sigma_y(p) e^(-p - sigma_y / E)           where sigma_y is the Kirchhoff stress (hyperelastic)
    F = A_0 sigma_y(p) e^(-p - 2 nu sigma_y / E)      where it is the Cauchy stress (hypoelastic)
    """
    bulk, shear, flow = material.elasticity.bulk_modulus, material.elasticity.shear_modulus, material.flow
    young = 9.0 * bulk * shear / (3.0 * bulk + shear)
    poisson = young / (2.0 * shear) - 1.0
    p = np.linspace(0.0, 1.0, 100_001)
    stress = flow.saturation_stress + flow.linear_modulus * p
    stress -= (flow.saturation_stress - flow.yield_stress) * np.exp(-flow.saturation_rate * p)
    share = 1.0 if isinstance(material.update, HyperelasticPlastic) else 2.0 * poisson
    return float((math.pi * radius**2 * stress * np.exp(-p - share * stress / young)).max())
