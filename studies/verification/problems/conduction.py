"""Heat conduction into a slab and a cylinder against their series."""

from collections.abc import Callable

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.loads import FixedTemperature
from core_models.material import Material
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from meshes.block import block
from meshes.mesh import Mesh
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.closed_forms.conduction import cylinder, slab
from studies.verification.orders import fitted_order
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt, run_until

DENSITY, SPECIFIC_HEAT, CONDUCTIVITY = 1000.0, 1.0, 1000.0  # a diffusivity of 1 m^2/s
BULK, SHEAR = 1e4 / 3.0, 5e3
START, SURFACE = 400.0, 300.0  # K
FOURIER = 0.2
COUNTS = {False: (4, 8, 16, 32), True: (8, 10, 12, 16)}
LOWEST_ORDER = 1.9

VARIANTS = (
    Variant("FEM quad4", FEM, "quad4"),
    Variant("FEM tri3", FEM, "tri3"),
    Variant("FEM quad8", FEM, "quad8"),
    Variant("MPM quadratic", MPM, "quad4"),
    Variant("MPM cubic", MPM, "quad4", {"interpolation": "cubic"}),
)
CASES: dict[str, tuple[str, Callable]] = {
    "slab": ("plane-strain", slab),
    "cylinder": ("axisymmetric", cylinder),
}


def body(size: float, kind: str) -> Mesh:
    """A strip from the middle, or the axis, to the surface at 1 m, two cells high."""
    return block([0.0, 0.0], [1.0, 2.0 * size], [round(1.0 / size), 2], kind)


def conducting() -> Material:
    """An elastic material that conducts heat; it stays at rest."""
    return Material(
        "conductor",
        DENSITY,
        CompressibleNeoHookean(),
        IsotropicElastic(BULK, SHEAR),
        specific_heat=ConstantSpecificHeat(SPECIFIC_HEAT),
        thermal_conductivity=CONDUCTIVITY,
    )


def temperature_error(variant: Variant, case: str, count: int) -> float:
    """Root-mean-square error of all points' temperatures, relative to the jump at the surface."""
    geometry, series = CASES[case]
    solver = variant.solver(
        body,
        conducting(),
        1.0 / count,
        geometry=geometry,
        temperature=START,
        loads=(FixedTemperature("right", SURFACE),),
        conduction=True,
    )
    run_until(solver, FOURIER * DENSITY * SPECIFIC_HEAT / CONDUCTIVITY)
    exact = SURFACE + (START - SURFACE) * series(solver.reference_positions[:, 0], FOURIER)
    error = solver.points.fields()["temperature"].array - exact
    return float(np.sqrt((error**2).mean()) / (START - SURFACE))


def run(quick: bool) -> Outcome:
    """Slab and cylinder by both methods."""
    counts = COUNTS[quick]
    outcome, rows, curves = Outcome(), [], []
    for case in CASES:
        done, refused = attempt(
            VARIANTS, lambda variant, case=case: [temperature_error(variant, case, count) for count in counts]
        )
        for label, errors in done.items():
            order = fitted_order([1.0 / count for count in counts], errors)
            rows.append((f"{label}, {case}", *errors, order))
            family = FEM if label.startswith("FEM") else MPM
            curves.append(
                Curve(f"{label}, {case}", tuple(1.0 / count for count in counts), tuple(errors), family)
            )
            outcome.criteria.append(Criterion(f"order, {label}, {case}", order, low=LOWEST_ORDER))
        outcome.criteria += [
            Criterion(f"order, {each.variant.label}, {case}", None, low=LOWEST_ORDER, reason=each.reason)
            for each in refused
        ]
    head = ("variant", *(f"h = 1/{count} m" for count in counts), "order")
    note = f"Root mean square over all points at a Fourier number of {FOURIER:g}, relative to the jump at the surface."
    outcome.tables.append(Table("Temperature error", head, tuple(rows), note))
    outcome.plots.append(
        Plot("Convergence", "cell size h [m]", "temperature error", tuple(curves), logarithmic=True)
    )
    return outcome


PROBLEM = Problem(
    "conduction",
    "Heat conduction",
    "A hot slab and a hot cylinder whose surfaces are suddenly cold, at rest: temperatures inside against Fourier's "
    "series when heat has gone half of the way.",
    "Carslaw & Jaeger, Conduction of Heat in Solids (1959), 3.3 and 7.6",
    run,
)
