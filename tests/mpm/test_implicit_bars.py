"""Implicit material points in bodies that are pulled: closed forms, necking, and the cure of locking."""

import math

import numpy as np
import pytest

from core_models.driver import drive_program
from core_models.loading import Deformation, Stress
from core_models.loading_program import Program, Segment
from core_models.loads import Fixed, Prescribed, Symmetry
from meshes.block import block
from tests.mpm.implicit_bodies import LENGTH, MEAN, PULL, RADIUS, H, bar, pulled, solve, steel


@pytest.mark.parametrize("geometry", ["axisymmetric", "spatial"])
def test_uniaxial_tension_is_that_of_a_point(geometry):
    """Drawn to 1.6 times its length through cells that it cuts, a block has the stress of the point driver."""
    d, stretch, steps = 3 if geometry == "spatial" else 2, 1.6, 32
    size = [0.7 * H] * (d - 1) + [2.0 * H]
    mesh = block([0.0] * d, size, [1] * (d - 1) + [2], "hex8" if d == 3 else "quad4")
    sides = ("left", "front") if d == 3 else ()
    loads = (*map(Symmetry, ("bottom", *sides)), Prescribed("top", d - 1, (stretch - 1.0) * size[-1]))
    options = {"interpolation": "linear"} if d == 3 else {"cure": MEAN}
    solver = solve(mesh, loads, 1.0 / steps, cell_size=(*[0.45 * H] * (d - 1), H), **options)
    controls = {"11": Stress(), "22": Stress(), "33": Deformation(stretch)}
    history = drive_program(steel(), Program([Segment(1.0, steps, controls)]))
    axial = solver.points.old.stress[:, d - 1]
    assert axial == pytest.approx(history.stress[-1, 2], rel=1e-7)
    lateral = history.deformation_gradient[-1, 0, 0]
    assert solver.boundary_positions("right")[:, 0] == pytest.approx(lateral * size[0], rel=1e-8)
    area = math.pi * size[0] ** 2 if d == 2 else size[0] ** 2
    assert solver.boundary_force("top")[-1] == pytest.approx(
        area * lateral**2 * history.stress[-1, 2], rel=1e-7
    )
    assert solver.step_count == steps


def test_untapered_bar_reaches_the_largest_uniform_force():
    """79.46 kN in closed form, within 0.1 %, with a rim that cuts the cells."""
    solver = bar(0.02, 2, 2, 1.0, 1.0, cell_size=(0.4 * RADIUS, LENGTH / 2))
    forces = pulled(solver, 0.6)
    assert np.ptp(solver.points.old.equivalent_plastic_strain) < 1e-9
    assert forces.max() == pytest.approx(79.46e3, rel=1e-3)


def test_tapered_bar_necks():
    """On 5 x 20 cells the force peaks at 77.3 kN near 2.8 mm and falls, the neck alone goes on, without a cut."""
    solver = bar(1.0 / 32.0)
    forces = pulled(solver, 1.0)
    peak = int(forces.argmax())
    assert forces[peak] == pytest.approx(77.3e3, rel=1e-3)
    assert PULL * solver.log.increments[peak].time == pytest.approx(2.83e-3, abs=0.2e-3)
    assert solver.log.cuts == [] and forces[-1] < 0.5 * forces[peak]
    assert solver.boundary_positions("neck")[:, 0].max() < 0.5 * RADIUS
    assert solver.boundary_positions("end")[:, 0].max() > 0.9 * RADIUS
    assert solver.ledger.hourglass < 5e-3 * solver.ledger.external


def test_cure_holds_changes_of_volume_within_a_cell():
    """Beyond the largest force no surface wrinkles: cubic splines give the neck of quadratic ones, cured or not."""
    radii = []
    for interpolation, cure in (("quadratic", MEAN), ("cubic", MEAN), ("cubic", None)):
        solver = bar(1.0 / 32.0, interpolation=interpolation, cure=cure)
        pulled(solver, 0.75)
        side = solver.boundary_positions("side")
        radii.append(solver.boundary_positions("neck")[:, 0].max())
        assert (np.diff(side[np.argsort(side[:, 1]), 0])[:10] > 0.0).all()
    assert radii == pytest.approx([radii[0]] * 3, rel=0.01)


def test_cure_frees_linear_functions():
    """A strip clamped at one end and pulled past yield takes the force that it does with splines; uncured 14 % more."""
    mesh = block([0.0, 0.0], [6.0 * H, 2.0 * H], [6, 2])
    loads = (Fixed("left"), Symmetry("bottom"), Prescribed("right", 0, 0.6 * H))
    splines, cured, plain = (
        solve(
            mesh, loads, 0.1, geometry="plane-strain", interpolation=interpolation, cure=cure
        ).boundary_force("right")[0]
        for interpolation, cure in (("quadratic", MEAN), ("linear", MEAN), ("linear", None))
    )
    assert cured == pytest.approx(splines, rel=5e-3)
    assert plain > 1.1 * splines
