"""Symmetry planes: a half or quarter model is the whole one, in every geometry and for every interpolation."""

import numpy as np
import pytest

from core_models.loads import Symmetry
from core_models.walls import Wall
from meshes.block import block
from mpm import Solver
from tests.mpm.conftest import CELL

STEPS = 12


def flow(centre, rates):
    """A smooth velocity field that planes through the centre mirror."""
    return lambda x: rates * (x - centre) * (1.0 - 0.2 * ((x - centre) / CELL) ** 2)


def start(solver, centre, rates):
    """Give the particles that field's affine velocities to the last digit, which differences do not."""
    square = ((solver.reference_positions - centre) / CELL) ** 2
    solver.affine[:] = np.eye(len(rates)) * (rates * (1.0 - 0.6 * square))[:, None, :]


def assert_same(part, whole, inside):
    """Particles of the part move and deform as those of the whole that lie in it."""
    assert inside.sum() == len(part.positions)
    order = [
        np.lexsort(np.round(s.reference_positions[w] / CELL, 6).T)
        for s, w in ((part, slice(None)), (whole, inside))
    ]
    for name in ("positions", "velocities"):
        a, b = getattr(part, name)[order[0]], getattr(whole, name)[inside][order[1]]
        assert np.abs(a - b).max() < 1e-11 * np.abs(b).max(), name
    stress = part.points.old.stress[order[0]], whole.points.old.stress[inside][order[1]]
    assert np.abs(stress[1]).max() > 1e6
    assert np.abs(stress[0] - stress[1]).max() < 1e-9 * np.abs(stress[1]).max()


@pytest.mark.parametrize("interpolation", ["quadratic", "linear", "gimp", "cubic"])
def test_a_quarter_is_the_whole(elastic, interpolation):
    """Two planes in the plane: all steps agree to round-off; the planes hold what the other half would push with."""
    counts, rates = np.array([6, 8]), np.array([2e4, -3e4])
    lower = CELL * np.array([2.0, -1.0])
    centre = lower + 0.5 * CELL * counts
    options = {"cell_size": CELL, "geometry": "plane-strain", "interpolation": interpolation}
    whole = Solver(
        block(lower, lower + CELL * counts, counts), elastic, velocity=flow(centre, rates), **options
    )
    part = Solver(
        block(centre, lower + CELL * counts, counts // 2),
        elastic,
        velocity=flow(centre, rates),
        loads=(Symmetry("left"), Symmetry("bottom")),
        **options,
    )
    start(whole, centre, rates)
    start(part, centre, rates)
    # Nodes lie half a cell off the planes: those of the whole body's grid as well, its corner being a corner of cells.
    for _ in range(STEPS):
        whole.advance()
        part.advance()
    assert_same(part, whole, (whole.reference_positions > centre).all(axis=1))
    assert part.boundary_force("left")[0] != 0.0


def test_planes_may_lie_on_the_high_side(elastic):
    """A body to the left of and below its planes is the mirror image of one to the right of and above them."""
    rates = np.array([2e4, -3e4])
    low = Solver(
        block((0.0, 0.0), (3 * CELL, 4 * CELL), (3, 4)), elastic, cell_size=CELL, geometry="plane-strain",
        velocity=flow(np.zeros(2), rates), loads=(Symmetry("left"), Symmetry("bottom")),
    )  # fmt: skip
    high = Solver(
        block((-3 * CELL, -4 * CELL), (0.0, 0.0), (3, 4)), elastic, cell_size=CELL, geometry="plane-strain",
        velocity=flow(np.zeros(2), rates), loads=(Symmetry("right"), Symmetry("top")),
    )  # fmt: skip
    for _ in range(STEPS):
        low.advance()
        high.advance()
    order = (
        np.lexsort(np.round(-high.reference_positions / CELL, 6).T),
        np.lexsort(np.round(low.reference_positions / CELL, 6).T),
    )
    assert np.allclose(-high.positions[order[0]], low.positions[order[1]], rtol=1e-12, atol=0.0)
    assert high.boundary_force("right")[0] == pytest.approx(-low.boundary_force("left")[0], rel=1e-9)


def test_an_eighth_is_the_whole_in_space(elastic):
    """Three planes."""
    counts, rates = np.array([4, 6, 4]), np.array([2e4, -3e4, 1e4])
    lower = -0.5 * CELL * counts
    options = {"cell_size": CELL, "velocity": flow(np.zeros(3), rates)}
    whole = Solver(block(lower, -lower, counts, "hex8"), elastic, **options)
    planes = (Symmetry("left"), Symmetry("front"), Symmetry("bottom"))
    part = Solver(block(np.zeros(3), -lower, counts // 2, "hex8"), elastic, loads=planes, **options)
    start(whole, 0.0, rates)
    start(part, 0.0, rates)
    for _ in range(STEPS):
        whole.advance()
        part.advance()
    assert_same(part, whole, (whole.reference_positions > 0.0).all(axis=1))


def test_space_between_two_planes_is_plane_strain(j2):
    """An extruded block between planes moves like its section, wall and friction included."""
    options = {"cell_size": CELL, "velocity": -150.0, "wall": Wall("unilateral", 0.3)}
    flat = Solver(block((0.0, 0.0), (4 * CELL, 6 * CELL), (4, 6)), j2, geometry="plane-strain", **options)
    deep = Solver(
        block((0.0, 0.0, 0.0), (4 * CELL, 3 * CELL, 6 * CELL), (4, 3, 6), "hex8"),
        j2,
        loads=(Symmetry("front"), Symmetry("back")),
        **options,
    )
    for _ in range(40):
        flat.advance()
        deep.advance()
    depth = 3 * CELL
    assert deep.time == pytest.approx(flat.time, rel=1e-12)
    assert deep.wall_impulse == pytest.approx(depth * flat.wall_impulse, rel=1e-9)
    assert deep.ledger.friction == pytest.approx(depth * flat.ledger.friction, rel=1e-6)
    assert flat.ledger.friction > 0.0
    assert deep.boundary_positions("right")[:, 0].max() == pytest.approx(
        flat.boundary_positions("right")[:, 0].max(), rel=1e-10
    )
