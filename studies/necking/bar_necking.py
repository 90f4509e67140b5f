"""What is measured while a bar or strip is pulled until it necks, and the quantities of it, by name."""

import math
from collections.abc import Sequence

import numpy as np

from core_models.checkpoint import Checkpoint
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic

FRACTURED, DROPPED = (
    0.1,
    0.5,
)  # of the largest force: what is left when a bar is broken, when its load has dropped


AT_SECTION = 0.05  # of the radius: what is so near to y = 0 lies on it


BROKEN = 0.01  # of the largest force: with less a run ends


class NeckingHistory:
    """What is measured while the body is pulled, row by row.

    Columns: elongation of the half, force and neck_radius (half width of a square bar; of a strip: force on the
    quarter and half width); at centre
    and surface of the neck's section plastic strain and triaxiality (mean over equivalent stress); at the centre
    flow_stress (equivalent), axial_stress, temperature and damage; failed: share of points that have failed, and
    failed_place: distance of the first of them from the axis over the radius there. Of a round bar: bridgman_flow and
    bridgman_axial, the flow stress and the axial stress at the centre by Bridgman's formulas from the mean axial
    stress and the profile of the neck.
    """

    COLUMNS = (
        "elongation", "force", "neck_radius", "centre_plastic_strain", "centre_triaxiality", "surface_plastic_strain",
        "surface_triaxiality", "flow_stress", "axial_stress", "temperature", "damage", "failed", "failed_place",
        "bridgman_flow", "bridgman_axial",
    )  # fmt: skip

    def __init__(self, rows: Sequence[Sequence[float]] = ()) -> None:
        self.rows: list[tuple[float, ...]] = [tuple(row) for row in rows]

    def column(self, name: str) -> np.ndarray:
        """A column by name."""
        return np.array([row[self.COLUMNS.index(name)] for row in self.rows])


class NeckingWatch:
    """Takes the rows of a history from a solver.

    is_round : whether the body is round, so that Bridgman's formulas hold.
    """

    def __init__(self, solver, is_round: bool) -> None:
        self.history = NeckingHistory()
        self._is_round = is_round
        self._start = float(solver.boundary_positions("end")[:, -1].mean())
        places = solver.reference_positions
        edge = np.zeros(places.shape[1])
        edge[0] = solver.boundary_positions("neck")[:, 0].max()
        self._centre = int(np.linalg.norm(places, axis=1).argmin())
        self._surface = int(np.linalg.norm(places - edge, axis=1).argmin())
        self._failed_place = 0.0

    def add(self, solver, force: float) -> None:
        """A row for the present state and a force [N] at the end."""
        neck = float(solver.boundary_positions("neck")[:, 0].max())
        state, centre, surface = solver.points.old, self._centre, self._surface
        axis = solver.reference_positions.shape[1] - 1
        equivalent, triaxiality = _stress_state(state.stress[[centre, surface]])
        none = np.zeros(solver.points.n)
        damage = none if state.damage is None else state.damage
        temperature = none if state.temperature is None else state.temperature
        failed = damage >= 1.0
        if self._failed_place == 0.0 and failed.any():
            places = solver.point_positions()[failed]
            self._failed_place = float(np.median(np.linalg.norm(places[:, :-1], axis=1))) / neck
        self.history.rows.append(
            (
                float(solver.boundary_positions("end")[:, -1].mean()) - self._start,
                force,
                neck,
                float(state.equivalent_plastic_strain[centre]),
                float(triaxiality[0]),
                float(state.equivalent_plastic_strain[surface]),
                float(triaxiality[1]),
                float(equivalent[0]),
                float(state.stress[centre, axis]),
                float(temperature[centre]),
                float(damage[centre]),
                float(failed.mean()),
                self._failed_place,
                *self._bridgman(solver, force, neck),
            )  # fmt: skip
        )

    def checkpoint(self) -> Checkpoint:
        """The rows taken so far, and where the first point has failed."""
        return {"rows": np.array(self.history.rows), "failed_place": np.array(self._failed_place)}

    def restore(self, checkpoint: Checkpoint) -> None:
        """Go on from a checkpoint, watching a solver that was built alike."""
        self.history = NeckingHistory(checkpoint["rows"].tolist())
        self._failed_place = float(checkpoint["failed_place"])

    def _bridgman(self, solver, force: float, neck: float) -> tuple[float, float]:
        if not self._is_round:
            return 0.0, 0.0
        curvature = neck_curvature(solver.boundary_positions("side"))
        flow = force / (math.pi * neck**2) * bridgman_factor(neck, curvature)
        return flow, flow * (1.0 + math.log1p(0.5 * neck * curvature))


def _stress_state(stress: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Equivalent stress (n,) [Pa] and triaxiality (n,) of stresses (n, 6)."""
    mean = stress[:, :3].mean(axis=1)
    deviator = stress[:, :3] - mean[:, None]
    equivalent = np.sqrt(1.5 * (deviator**2).sum(axis=1) + 3.0 * (stress[:, 3:] ** 2).sum(axis=1))
    return equivalent, mean / np.maximum(equivalent, np.finfo(float).tiny)


def neck_curvature(side: np.ndarray) -> float:
    """Curvature [1/m] of a bar's profile at the neck, z = 0: of the parabola through its first half radius.

    side : positions (k, 2) [m] on the profile, or (k, 3) on the quarter of the surface, of which it is that at y = 0.
    """
    if side.shape[1] == 3:
        side = side[side[:, 1] < AT_SECTION * side[:, 0].max()]
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
    """Elongation of the half [m] at the largest force, and that force [N], on the parabola through it and its
    neighbours; of fewer than three rows the largest itself.
    """
    u, force = history.column("elongation"), history.column("force")
    if len(force) < 3:
        return float(u[force.argmax()]), float(force.max())
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


def is_broken(history: NeckingHistory) -> bool:
    """Whether next to nothing is left of the largest force: what the halves do then is of no interest."""
    force = history.column("force")
    return bool(len(force)) and bool(force[-1] < BROKEN * force.max())


def fall_to(history: NeckingHistory, share: float) -> float | None:
    """Elongation [m] at which the force has fallen to a share of the largest; None where it has not."""
    u, force = history.column("elongation"), history.column("force")
    largest = int(force.argmax())
    wanted = share * force[largest]
    low = np.flatnonzero(force[largest:] < wanted)
    if not len(low):
        return None
    i = largest + int(low[0])
    part = (force[i - 1] - wanted) / (force[i - 1] - force[i])
    return float(u[i - 1] + part * (u[i] - u[i - 1]))


def first_failure(history: NeckingHistory) -> tuple[float | None, float | None]:
    """Elongation [m] at which a point has failed first, and its distance from the axis over the neck's radius."""
    rows = np.flatnonzero(history.column("failed") > 0.0)
    if not len(rows):
        return None, None
    return float(history.column("elongation")[rows[0]]), float(history.column("failed_place")[rows[0]])


def quantity(history: NeckingHistory, name: str, at: float | None = None) -> float | None:
    """A quantity by name: one of QUANTITIES, or a column at an elongation [m]; None where there is no value."""
    if at is not None:
        return at_elongation(history, name, at)
    return QUANTITIES[name](history)


QUANTITIES = {
    "peak_force": lambda history: peak(history)[1],
    "elongation_at_peak": lambda history: peak(history)[0],
    "force_at_end": lambda history: float(history.column("force")[-1]),
    "neck_radius_at_end": lambda history: float(history.column("neck_radius")[-1]),
    "fracture_elongation": lambda history: fall_to(history, FRACTURED),
    "load_drop": lambda history: fall_to(history, DROPPED),
    "first_failure": lambda history: first_failure(history)[0],
    "place_of_first_failure": lambda history: first_failure(history)[1],
}
"""Quantities of a whole history by name, in SI; place_of_first_failure: 0 at the axis, 1 at the surface."""


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
