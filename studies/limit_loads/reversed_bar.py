"""A bar under reversed strain with Ziegler's kinematic hardening."""

import math

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.flow.perfect import PerfectPlasticity
from core_models.kinematic_hardening.ziegler import Ziegler
from core_models.loads import Load, Prescribed, Symmetry
from core_models.material import Material
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from meshes.block import block
from studies.limit_loads.closed_forms import kinematic_path
from studies.limit_loads.loading import IMPLICIT, IMPLICIT_POINTS, METHODS, STATIC, Body, Pace, Record, record
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem

YOUNG, POISSON, YIELD_STRESS, MODULUS = 200e9, 0.3, 0.2e9, 10e9  # Pa
RADIUS, LENGTH, SIZE = 2e-3, 6e-3, 1e-3  # m
AMPLITUDE = 0.01  # of the true strain
QUARTERS, ROWS = 9, 100  # of the cycle, and rows of each
# Of the root mean square difference, % of the yield stress; of the others 3 %.
TOLERANCE = {IMPLICIT: 0.01, IMPLICIT_POINTS: 0.01}
COARSEST = 3.0


def steel() -> Material:
    """Elastic, with linear kinematic hardening after Ziegler."""
    bulk, shear = YOUNG / (3.0 * (1.0 - 2.0 * POISSON)), YOUNG / (2.0 * (1.0 + POISSON))
    return Material(
        "steel", 7850.0, HypoelasticPlastic(), IsotropicElastic(bulk, shear), DefaultHypoelastic(bulk),
        PerfectPlasticity(YIELD_STRESS), VonMises(), kinematic_hardening=Ziegler(MODULUS),
    )  # fmt: skip


def strain(time: float) -> float:
    """True strain: a sine of amplitude AMPLITUDE and period 4 s, which turns without a jump of the velocity."""
    return AMPLITUDE * math.sin(0.5 * math.pi * time)


def strain_rate(time: float) -> float:
    """Its rate [1/s]."""
    return 0.5 * math.pi * AMPLITUDE * math.cos(0.5 * math.pi * time)


def body() -> Body:
    """Half of the bar; its end is moved so that the true strain is `strain`."""
    mesh = block([0.0, 0.0], [RADIUS, LENGTH], [round(RADIUS / SIZE), round(LENGTH / SIZE)], "quad4")

    def loads(pace: Pace) -> tuple[Load, ...]:
        def speed(_places: np.ndarray, time: float) -> float:
            return pace(time) * LENGTH * math.exp(strain(time)) * strain_rate(time)

        return Symmetry("bottom"), Prescribed("top", 1, speed)

    # A row of the grid's nodes has to lie on the end: they start half a cell off the symmetry plane.
    size = LENGTH / (round(LENGTH / SIZE) + 0.5)
    return Body(mesh, steel(), "axisymmetric", loads, float(QUARTERS), QUARTERS * ROWS, size, 600.0, 0.01)


def cycled(method: str) -> Record:
    """Rows of true strain of the bar at the row's end, and true stress of its end [Pa]: then, or the row's mean."""

    def read(solver, _work: float, reaction: np.ndarray) -> tuple[float, float]:
        length = float(solver.boundary_positions("top")[:, 1].mean())
        radius = float(solver.boundary_positions("right")[:, 0].mean())
        return math.log(length / LENGTH), reaction[1] / (math.pi * radius**2)

    return record(method, body(), "top", read)


def exact(strains: np.ndarray) -> np.ndarray:
    """Stresses [Pa] of the closed form along the strains."""
    return np.array(kinematic_path(YOUNG, YIELD_STRESS, MODULUS, strains))


def compared(found: Record) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Strains, stresses found and those of the closed form [Pa]; of an explicit run in the middle of the rows."""
    ends, stresses = found.values.T
    if found.method in STATIC:
        return ends, stresses, exact(ends)
    middles = 0.5 * (ends + np.concatenate([[0.0], ends[:-1]]))
    both = np.column_stack([middles, ends]).ravel()
    return middles, stresses, exact(both)[::2]


def run(quick: bool) -> Outcome:
    """Two cycles and a quarter by every method; it is always quick."""
    outcome, rows, curves = Outcome(), [], []
    for method in METHODS:
        found = cycled(method)
        strains, stresses, wanted = compared(found)
        differences = 100.0 * np.abs(stresses - wanted) / YIELD_STRESS
        off = float(np.sqrt((differences**2).mean()))
        what = f"root mean square difference from the closed form, {method}, of the yield stress"
        outcome.criteria.append(Criterion(what, off, high=TOLERANCE.get(method, COARSEST), unit="%"))
        ends = 1e-6 * stresses.max(), 1e-6 * stresses.min()
        rows.append((method, *ends, off, float(differences.max()), found.steps, found.seconds))
        family = MPM if method.startswith("mpm") else FEM
        curves.append(Curve(method, tuple(100.0 * strains), tuple(1e-6 * stresses), family))
    path = np.array([strain(t) for t in np.linspace(0.0, QUARTERS, 100 * QUARTERS + 1)])
    curves.insert(0, Curve("closed form", tuple(100.0 * path), tuple(1e-6 * exact(path)), "exact"))
    head = (
        "method", "largest stress [MPa]", "smallest", "difference, root mean square [% of yield stress]", "largest",
        "steps", "processor s",
    )  # fmt: skip
    note = (
        "The closed form's stresses are 285.714 and -285.714 MPa; it flows back at -114.286 MPa. Explicit runs start "
        "from rest, so that their strain is shifted a little: the closed form is taken along the strain that they "
        "have. Material points near the ends begin to flow a little later than those inside, which rounds the knee."
    )
    outcome.tables.append(Table("Reversed bar", head, tuple(rows), note))
    outcome.plots.append(Plot("Loop", "true strain [%]", "true stress [MPa]", tuple(curves)))
    return outcome


PROBLEM = Problem(
    "reversed-bar",
    "Bar under reversed strain",
    "A steel bar is pulled and pushed by a true strain of 1 %, its yield surface moving after Ziegler: it flows back "
    "400 MPa below where it was pulled to (Bauschinger), and the loop is closed after the first cycle. True stress of "
    "the bar's end against the closed form of linear kinematic hardening.",
    "Ziegler, Q. Appl. Math. 17 (1959) 55; closed form of the bilinear bar",
    run,
)
