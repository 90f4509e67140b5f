"""Hourglass control of one-point elements."""

from itertools import product

import numpy as np
import pytest

MODES = {"quad4": [(0, 1)], "hex8": [(0, 1), (1, 2), (0, 2), (0, 1, 2)]}
SIZE = 1e-3  # of the element: how far the corners move


@pytest.fixture(params=[("plane-strain", "quad4"), ("axisymmetric", "quad4"), ("spatial", "hex8")])
def one_point(request, element, straight):
    """Make a single one-point element displaced by a function, with a coefficient of the control."""
    geometry, kind = request.param

    def make(displacement=None, **options):
        mesh = straight(
            kind, [1] * (3 if kind == "hex8" else 2), lower=0.7 if geometry == "axisymmetric" else 0.0
        )
        return element((geometry, kind, "reduced", "none"), displacement, mesh, **options)

    return make


def patterns(solver):
    """All hourglass displacements of a single element (k, a, d): one pattern along one axis each."""
    signs = np.where(solver.mesh.points > solver.mesh.points.mean(axis=0), 1.0, -1.0)
    for which, axis in product(MODES[solver.mesh.kind], range(solver.mesh.dimension)):
        pattern = np.zeros_like(signs)
        pattern[:, axis] = signs[:, which].prod(axis=1)
        yield pattern


def test_every_hourglass_mode_is_resisted(one_point):
    """2 modes of a quad, 12 of a hexahedron: forces against each, and an energy that grows with its square."""
    modes = list(patterns(one_point()))
    assert len(modes) == (2 if len(modes[0]) == 4 else 12)
    for mode in modes:
        solver, twice = one_point(lambda x, m=mode: SIZE * m), one_point(lambda x, m=mode: 2.0 * SIZE * m)
        assert (solver.nodal_forces() * mode).sum() < 0.0
        assert solver.ledger.hourglass > 0.0
        assert twice.ledger.hourglass == pytest.approx(4.0 * solver.ledger.hourglass, rel=1e-9)


def test_the_control_is_as_stiff_as_its_coefficient(one_point):
    """The energy of a mode is in proportion to the coefficient."""
    mode = next(patterns(one_point()))
    energies = [one_point(lambda x: SIZE * mode, hourglass=c).ledger.hourglass for c in (0.1, 0.2)]
    assert energies[1] == pytest.approx(2.0 * energies[0], rel=1e-12)


def test_the_ledger_closes_with_the_control_at_work(one_point):
    """An element that starts in a mode swings, and its energy stays: kinetic, strain, and that of the control."""
    mode = next(patterns(one_point()))
    solver = one_point(lambda x: SIZE * mode, hourglass=0.1, safety=0.2)
    held, largest = [], 0.0
    for _ in range(600):
        solver.advance()
        held.append(solver.ledger.hourglass)
        largest = max(largest, abs(solver.ledger.relative_error))
    assert min(held) < 0.1 * max(held)
    assert largest < 5e-3
