"""Rigid rotation of a stressed point: a thousand turns through every update."""

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.linear import LinearHardening
from core_models.material import Material
from core_models.points import MaterialPoints
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from studies.report.parts import Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem

TURNS = 1000
STEPS_PER_TURN = {False: 36, True: 7}
POINTS = 16
STEP = 1e-6  # s
ROUND_OFF = 1e-9  # of the stress; 36,000 steps of round-off
DENSITY, BULK, SHEAR = 8930.0, 130e9, 43.333e9


def materials() -> dict[str, Material]:
    """One material for each update; the first two have yielded before they turn."""
    moduli, flow = IsotropicElastic(BULK, SHEAR), LinearHardening(0.4e9, 0.1e9)
    eos = MieGruneisen(DENSITY, 3940.0, 2.02, 1.489)
    return {
        "hypoelastic-plastic": Material(
            "copper", DENSITY, HypoelasticPlastic(), moduli, eos, flow, VonMises()
        ),
        "hyperelastic-plastic": Material(
            "copper", DENSITY, HyperelasticPlastic(), moduli, NeoHookean(BULK), flow, VonMises()
        ),
        "compressible neo-Hookean": Material("rubber", DENSITY, CompressibleNeoHookean(), moduli),
    }


def stressed(material: Material) -> MaterialPoints:
    """Points under different stresses, by strains of up to a few per cent in small steps."""
    points = MaterialPoints(material, np.ones(POINTS))
    strain = np.random.default_rng(1).uniform(-0.03, 0.03, (POINTS, 3, 3))
    for share in np.linspace(0.02, 1.0, 50):
        points.deformation_gradient[:] = np.eye(3) + share * strain
        points.advance(STEP)
        points.accept()
    return points


def turned_stress(points: MaterialPoints, turns: int, steps_per_turn: int) -> tuple[float, float]:
    """Turn all points about an oblique axis; largest change of the stress's invariants and, after whole turns, of
    the stress itself, both relative to the equivalent stress.
    """
    start, before = points.old_deformation_gradient.copy(), _tensors(points.old.stress)
    size = np.sqrt(1.5 * (_deviators(before) ** 2).sum(axis=(1, 2)))
    worst = 0.0
    for step in range(1, turns * steps_per_turn + 1):
        points.deformation_gradient[:] = _rotation(2.0 * np.pi * step / steps_per_turn) @ start
        points.advance(STEP)
        points.accept()
        if step % steps_per_turn == steps_per_turn // 2:
            worst = max(worst, _change_of_invariants(before, _tensors(points.old.stress), size))
    back = np.abs(_tensors(points.old.stress) - before).max(axis=(1, 2)) / size
    return worst, float(back.max())


def run(quick: bool) -> Outcome:
    """A thousand turns, of 36 steps or, quickly, of 7."""
    outcome, rows = Outcome(), []
    for name, material in materials().items():
        invariants, stress = turned_stress(stressed(material), TURNS, STEPS_PER_TURN[quick])
        rows.append((name, invariants, stress))
        outcome.criteria += [
            Criterion(f"change of the invariants, {name}", invariants, high=ROUND_OFF),
            Criterion(f"stress after whole turns, {name}", stress, high=ROUND_OFF),
        ]
    head = ("update", "change of invariants", "stress after whole turns")
    note = f"{TURNS} turns of {STEPS_PER_TURN[quick]} steps, relative to the equivalent stress."
    outcome.tables.append(Table("Largest changes", head, tuple(rows), note))
    return outcome


def _rotation(angle: float) -> np.ndarray:
    axis = np.array([1.0, 2.0, 3.0]) / np.sqrt(14.0)
    cross = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross


def _tensors(stress: np.ndarray) -> np.ndarray:
    """Symmetric tensors (n, 3, 3) from their six components xx, yy, zz, xy, yz, xz."""
    return stress[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]


def _deviators(tensors: np.ndarray) -> np.ndarray:
    return tensors - np.trace(tensors, axis1=1, axis2=2)[:, None, None] / 3.0 * np.eye(3)


def _change_of_invariants(before: np.ndarray, after: np.ndarray, size: np.ndarray) -> float:
    """Largest change of the principal stresses: they hold all invariants."""
    return float((np.abs(np.linalg.eigvalsh(after) - np.linalg.eigvalsh(before)).max(axis=1) / size).max())


PROBLEM = Problem(
    "rotation",
    "Rigid rotation of a stressed body",
    "Points under different stresses turn a thousand times about an oblique axis. Principal stresses must not "
    "change, and after whole turns the stress must be back, for every update of the stress.",
    "objectivity",
    run,
)
