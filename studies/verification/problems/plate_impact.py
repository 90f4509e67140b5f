"""Plate impact in copper: the state behind the front against Rankine and Hugoniot."""

import numpy as np

from core_models.bulk_viscosity import BulkViscosity
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.flow.perfect import PerfectPlasticity
from core_models.loads import Symmetry
from core_models.material import Material
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.bodies import strip_body
from studies.verification.closed_forms.plate_impact import ShockState, shock_state
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt

EOS = MieGruneisen(8930.0, 3940.0, 2.02, 1.489)
SHEAR, FLOW_STRESS = 45.45e9, 90e6
SPEEDS = (100.0, 500.0, 1000.0)  # m/s, of the particles behind the front
LENGTH = 0.02  # m
CELLS = {False: 200, True: 120}
VISCOSITY = BulkViscosity(0.5, 1.2)
TRAVEL = 0.7  # of the length, by the front, until the state is looked at
PLATEAU = (0.25, 0.8)  # of the way of the front: away from the heated wall and from the front
STATE_TOLERANCE, OVERSHOOT = 0.01, 0.05

VARIANTS = (
    Variant("FEM quad4", FEM, "quad4"),
    Variant("FEM quad4, one point", FEM, "quad4", {"integration": "reduced"}),
    Variant("MPM quadratic, APIC", MPM, "quad4", finer=2),
    Variant("MPM quadratic, FLIP 0.99", MPM, "quad4", {"transfer": "flip"}, finer=2),
)


def copper() -> Material:
    """Hypoelastic copper whose bulk modulus is that of its equation of state, with constant flow stress."""
    moduli = IsotropicElastic(EOS.reference_density * EOS.C_0**2, SHEAR)
    return Material(
        "copper",
        EOS.reference_density,
        HypoelasticPlastic(),
        moduli,
        EOS,
        PerfectPlasticity(FLOW_STRESS),
        VonMises(),
    )


def shot(variant: Variant, speed: float, cells: int) -> dict[str, np.ndarray]:
    """Distance from the wall over the way of the front, axial stress, pressure and density of every row of cells when
    the front has gone most of the length; and the mean speed of the front [m/s].
    """
    exact = shock_state(EOS, SHEAR, FLOW_STRESS, speed)
    size = LENGTH / cells
    solver = variant.solver(
        strip_body(LENGTH, 2.0 * size, along=1),
        copper(),
        size,
        geometry="plane-strain",
        velocity=-speed,
        wall="plane",
        viscosity=VISCOSITY,
        loads=(Symmetry("left"), Symmetry("right")),
    )
    closing = exact.front_speed - speed  # of the front away from the wall
    while solver.time < (end := TRAVEL * LENGTH / exact.front_speed):
        solver.advance(end)
    points = solver.points
    viscous = 0.0 if points.viscous_pressure is None else points.viscous_pressure
    height = _row_means(solver, solver.point_positions()[:, 1], size)
    found = {
        "place": height / (closing * end),
        "stress": _row_means(solver, viscous - points.old.stress[:, 1], size),
        "pressure": _row_means(solver, -points.old.stress[:, :3].mean(axis=1), size),
        "density": EOS.reference_density / _row_means(solver, points.volume_ratio, size),
    }
    found["front_speed"] = speed + _front(height, found["stress"], 0.5 * exact.stress) / end
    return found


def plateau(found: dict[str, np.ndarray]) -> dict[str, float]:
    """Means behind the front, the largest stress over the plateau's, and the speed of the front."""
    inside = (found["place"] > PLATEAU[0]) & (found["place"] < PLATEAU[1])
    means = {name: float(found[name][inside].mean()) for name in ("stress", "pressure", "density")}
    behind = found["place"] > PLATEAU[0]
    return means | {
        "front_speed": float(found["front_speed"]),
        "overshoot": float(found["stress"][behind].max() / means["stress"] - 1.0),
    }


def run(quick: bool) -> Outcome:
    """Three speeds by both methods."""
    done, refused = attempt(
        VARIANTS, lambda variant: {speed: shot(variant, speed, CELLS[quick]) for speed in SPEEDS}
    )
    outcome, rows = Outcome(), []
    for label, shots in done.items():
        for speed, found in shots.items():
            exact = shock_state(EOS, SHEAR, FLOW_STRESS, speed)
            state = plateau(found)
            off = {name: 100.0 * (state[name] / getattr(exact, name) - 1.0) for name in _JUDGED}
            rows.append((label, speed, state["stress"] / 1e9, *off.values(), 100.0 * state["overshoot"]))
            worst = max(off.values(), key=abs)
            outcome.criteria += [
                Criterion(
                    f"state at {speed:g} m/s, {label}",
                    worst,
                    -100.0 * STATE_TOLERANCE,
                    100.0 * STATE_TOLERANCE,
                    "%",
                ),
                Criterion(
                    f"overshoot at {speed:g} m/s, {label}",
                    100.0 * state["overshoot"],
                    high=100.0 * OVERSHOOT,
                    unit="%",
                ),
            ]
    outcome.criteria += [
        Criterion(f"state, {each.variant.label}", None, high=0.0, unit="%", reason=each.reason)
        for each in refused
    ]
    head = (
        "variant",
        "u [m/s]",
        "stress [GPa]",
        "stress off by [%]",
        "pressure",
        "density",
        "front",
        "overshoot [%]",
    )
    outcome.tables += [
        _exact_table(),
        Table("State behind the front", head, tuple(rows), _note(CELLS[quick])),
    ]
    outcome.plots = [_profile(done, speed) for speed in SPEEDS]
    return outcome


_JUDGED = ("stress", "pressure", "density", "front_speed")


def _row_means(solver, values: np.ndarray, size: float) -> np.ndarray:
    """Means over the points that began in one row of cells, from the wall upwards."""
    rows = (solver.reference_positions[:, 1] / size).astype(int)
    volumes = solver.points.reference_volumes
    return np.bincount(rows, values * volumes) / np.bincount(rows, volumes)


def _front(height: np.ndarray, stress: np.ndarray, level: float) -> float:
    """Height at which the stress falls through the level, outermost, between rows [m]."""
    last = int(np.flatnonzero(stress > level)[-1])
    share = (stress[last] - level) / (stress[last] - stress[last + 1])
    return float(height[last] + share * (height[last + 1] - height[last]))


def _note(cells: int) -> str:
    return (
        f"{cells} cells along {LENGTH * 1e3:g} mm, bulk viscosity {VISCOSITY.linear:g} linear and "
        f"{VISCOSITY.quadratic:g} quadratic. Means over {PLATEAU[0]:.0%} to {PLATEAU[1]:.0%} of the front's way from "
        "the wall; the rest is the heated wall and the front itself. The overshoot is the largest stress beyond the "
        "heated wall."
    )


def _exact_table() -> Table:
    def row(speed: float, state: ShockState) -> tuple:
        return speed, state.stress / 1e9, state.pressure / 1e9, state.density, state.front_speed

    rows = tuple(row(speed, shock_state(EOS, SHEAR, FLOW_STRESS, speed)) for speed in SPEEDS)
    head = ("u [m/s]", "stress [GPa]", "pressure [GPa]", "density [kg/m³]", "front [m/s]")
    return Table(
        "Rankine and Hugoniot",
        head,
        rows,
        "Across the elastic precursor, where there is one, and the plastic front.",
    )


def _profile(done: dict, speed: float) -> Plot:
    exact = shock_state(EOS, SHEAR, FLOW_STRESS, speed)
    level = exact.stress / 1e9
    curves = [Curve("exact", (0.0, 1.0, 1.0, 1.4), (level, level, 0.0, 0.0), "exact")]
    curves += [
        Curve(
            label,
            tuple(shots[speed]["place"]),
            tuple(shots[speed]["stress"] / 1e9),
            FEM if "FEM" in label else MPM,
        )
        for label, shots in done.items()
    ]
    return Plot(
        f"Impact at {speed:g} m/s", "distance from the wall / way of the front", "stress [GPa]", tuple(curves)
    )


PROBLEM = Problem(
    "plate-impact",
    "Plate impact in copper",
    "A layer of copper meets a rigid wall, which is half of a symmetric impact at twice the speed: elastic precursor "
    "and plastic shock at 100 and 500 m/s, one shock at 1,000 m/s. Stress, pressure, density and the front's speed "
    "against the jump conditions.",
    "Rankine-Hugoniot with Mie-Grüneisen (C0 3940 m/s, S 1.489, Gamma0 2.02) and a flow stress of 90 MPa",
    run,
)
