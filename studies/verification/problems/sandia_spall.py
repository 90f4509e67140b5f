"""Spall of a copper plate by voids that grow in tension."""

import numpy as np

from core_models.bulk_viscosity import BulkViscosity
from core_models.damage.sandia import SandiaDamage
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.erosion.no_tension import AllowNoTension
from core_models.flow.linear import LinearHardening
from core_models.loads import Symmetry
from core_models.material import Material
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.bodies import strip_body
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt

EOS = MieGruneisen(8930.0, 3940.0, 2.02, 1.489)
SHEAR = 45.45e9  # Pa
FLOW = LinearHardening(200e6, 300e6)
VOIDS = SandiaDamage(m=2.0, initial_porosity=1e-4, critical_porosity=0.3, coupling=1.0)
FLYER, TARGET = 1e-3, 2e-3  # m
SPEED = 200.0  # m/s, of the flyer
END = 1.2e-6  # s: the waves have met, in the middle of the target, at 0.7 µs
CELLS = {False: 40, True: 20}  # through the flyer
PARTS = 0.1  # of the flyer, within which the spall plane is asked for
VISCOSITY = BulkViscosity(0.2, 1.2)

VARIANTS = (
    Variant("FEM quad4", FEM, "quad4"),
    Variant("MPM quadratic, APIC", MPM, "quad4", finer=2),
)


def copper() -> Material:
    """Hypoelastic copper with Sandia's voids; what has failed carries no tension."""
    moduli = IsotropicElastic(EOS.reference_density * EOS.C_0**2, SHEAR)
    return Material(
        "copper", EOS.reference_density, HypoelasticPlastic(), moduli, EOS, FLOW, VonMises(), damage=VOIDS,
        erosion=AllowNoTension(),
    )  # fmt: skip


def shot(variant: Variant, cells: int) -> dict[str, np.ndarray]:
    """Rows of cells from the flyer's back to the target's: distance from the target's back [m] and damage at the end;
    time [s] and speed of the target's back [m/s], step by step.
    """
    size = FLYER / cells
    solver = variant.solver(
        strip_body(FLYER + TARGET, 2.0 * size, along=1), copper(), size, geometry="plane-strain",
        velocity=lambda X: np.column_stack([0.0 * X[:, 0], np.where(X[:, 1] < FLYER, SPEED, 0.0)]),
        viscosity=VISCOSITY, loads=(Symmetry("left"), Symmetry("right")),
    )  # fmt: skip
    times, places = [0.0], [_back(solver)]
    while solver.time < END:
        solver.advance(END)
        times.append(solver.time)
        places.append(_back(solver))
    rows = (solver.reference_positions[:, 1] / size).astype(int)
    damage = np.bincount(rows, np.minimum(solver.points.old.damage, 1.0)) / np.bincount(rows)
    heights = (np.arange(len(damage)) + 0.5) * size
    return {
        "distance": FLYER + TARGET - heights,
        "damage": damage,
        "time": 0.5 * (np.array(times[1:]) + np.array(times[:-1])),
        "speed": np.diff(places) / np.diff(times),
    }


def spall_plane(found: dict[str, np.ndarray]) -> float:
    """Middle of what has failed, from the target's back [m]; not a number where nothing has."""
    failed = found["damage"] > 0.99
    return float(found["distance"][failed].mean()) if failed.any() else float("nan")


def run(quick: bool) -> Outcome:
    """By both methods."""
    done, refused = attempt(VARIANTS, lambda variant: shot(variant, CELLS[quick]))
    outcome, rows = Outcome(), []
    for label, found in done.items():
        place, pull = spall_plane(found), pull_back(found)
        low, high = (1e3 * FLYER * (1.0 + side * PARTS) for side in (-1.0, 1.0))
        outcome.criteria.append(
            Criterion(f"spall plane from the back, {label}", 1e3 * place, low, high, "mm")
        )
        rows.append((label, 1e3 * place, *pull, int((found["damage"] > 0.99).sum())))
    outcome.criteria += [
        Criterion(f"spall plane, {each.variant.label}", None, reason=each.reason) for each in refused
    ]
    head = (
        "variant",
        "spall plane [mm]",
        "largest speed of the back [m/s]",
        "pull-back [m/s]",
        "failed rows",
    )
    note = (
        f"Copper flyer of {1e3 * FLYER:g} mm at {SPEED:g} m/s on a target of {1e3 * TARGET:g} mm, {CELLS[quick]} cells "
        f"through the flyer. The plane is asked for within {PARTS:.0%} of the flyer's thickness from where releases of "
        "both backs meet first, the flyer's thickness from the target's back. Pull-back: by how much the back slows "
        "down before the spall's signal arrives."
    )
    outcome.tables.append(Table("Spall", head, tuple(rows), note))
    outcome.plots += [
        _plot("Damage", "distance from the back [mm]", "damage", done, "distance", "damage", 1e3),
        _plot("Speed of the target's back", "t [µs]", "speed [m/s]", done, "time", "speed", 1e6),
    ]
    return outcome


def pull_back(found: dict[str, np.ndarray]) -> tuple[float, float]:
    """Largest speed of the back, and its drop to the smallest one afterwards [m/s]."""
    width = max(len(found["speed"]) // 100, 1)
    speed = np.convolve(found["speed"], np.ones(width) / width, "valid")
    top = int(speed.argmax())
    return float(speed[top]), float(speed[top] - speed[top:].min())


def _back(solver) -> float:
    return float(solver.boundary_positions("top")[:, 1].mean())


def _plot(title: str, x_label: str, y_label: str, done: dict, x: str, y: str, scale: float) -> Plot:
    curves = [
        Curve(label, tuple(scale * found[x]), tuple(found[y]), FEM if "FEM" in label else MPM)
        for label, found in done.items()
    ]
    return Plot(title, x_label, y_label, tuple(curves))


PROBLEM = Problem(
    "sandia-spall",
    "Spall of copper",
    "A copper flyer hits a target twice as thick: the release waves of both backs meet in the target, where voids grow "
    "after Bammann, Chiesa and Johnson until it parts. The place of the parting against that where the waves meet.",
    "acoustics: the flyer's thickness from the back of the target; the damage: Cocks & Ashby, Metal Sci. 14 (1980) 395",
    run,
)
