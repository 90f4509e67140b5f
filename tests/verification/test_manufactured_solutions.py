"""The manufactured solutions are solutions: checked by differences that share no formula with them."""

import numpy as np
import pytest

from studies.verification.closed_forms import mms_ring
from studies.verification.closed_forms.mms_axis_aligned import AXIS_ALIGNED
from studies.verification.closed_forms.mms_ring import RING
from studies.verification.closed_forms.mms_vortex import VORTEX

EIGHTH_ORDER = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0.0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
COMPLEX_STEP = 1e-30
ANGLES = np.array([0.1, 0.9, 2.3, 4.4])


def polar(radii):
    """Places at some radii and all ANGLES."""
    r, a = (x.ravel() for x in np.meshgrid(radii, ANGLES))
    return np.column_stack([r * np.cos(a), r * np.sin(a)])


CUBE = np.array([[0.11, 0.42, 0.83], [0.5, 0.07, 0.31], [0.93, 0.66, 0.5]])
CASES = {
    "vortex": (VORTEX, polar([0.78, 0.96, 1.0, 1.17]), 0.37),
    "square": (AXIS_ALIGNED, CUBE[:, :2].copy(), 0.0031),
    "cube": (AXIS_ALIGNED, CUBE, 0.0031),
    "ring": (RING, polar([0.41, 0.5, 0.58]), 0.0031),
}


@pytest.fixture(params=CASES)
def case(request):
    """A solution, places inside its body, and a time."""
    return CASES[request.param]


def gradient(solution, positions, time):
    """F in three dimensions by the complex step: free of subtractive error."""
    d = positions.shape[1]
    full = np.tile(np.eye(3), (len(positions), 1, 1))
    for k in range(d):
        step = np.zeros(d, dtype=complex)
        step[k] = 1j * COMPLEX_STEP
        full[:, :d, k] += solution.displacement(positions + step, time).imag / COMPLEX_STEP
    return full


def first_piola(solution, positions, time):
    """P = mu (F - F^-T) + lambda ln J F^-T."""
    full = gradient(solution, positions, time)
    inverse = np.linalg.inv(full).transpose(0, 2, 1)
    logarithm = np.log(np.linalg.det(full))[:, None, None]
    return solution.shear * (full - inverse) + solution.lame * logarithm * inverse


def divergence(solution, positions, time, step):
    """div P by eighth-order differences."""
    d = positions.shape[1]
    found = np.zeros_like(positions)
    for k in range(d):
        for offset, weight in zip(range(-4, 5), EIGHTH_ORDER, strict=True):
            moved = positions + offset * step * np.eye(d)[k]
            found += weight / step * first_piola(solution, moved, time)[:, :d, k]
    return found


def test_velocity_is_the_rate_of_displacement(case):
    """v = du/dt to round-off."""
    solution, positions, time = case
    rate = solution.displacement(positions, time + 1j * COMPLEX_STEP).imag / COMPLEX_STEP
    assert np.allclose(solution.velocity(positions, time), rate, rtol=1e-13, atol=1e-13 * np.abs(rate).max())


def test_momentum_balances(case):
    """div P + rho0 b = rho0 dv/dt to 1e-9 of the largest term, F by the complex step, div P by differences."""
    solution, positions, time = case
    acceleration = solution.velocity(positions, time + 1j * COMPLEX_STEP).imag / COMPLEX_STEP
    force = divergence(solution, positions, time, 2e-3)
    rest = force + solution.density * (solution.body_force(positions, time) - acceleration)
    assert np.abs(rest).max() < 1e-9 * max(np.abs(force).max(), solution.density * np.abs(acceleration).max())


@pytest.mark.parametrize(
    ("solution", "radii"), [(VORTEX, [0.75, 1.25]), (RING, [0.4, 0.6])], ids=["vortex", "ring"]
)
def test_rims_are_free_of_traction(solution, radii):
    """P N = 0 on both rims at every time, so that no load acts there."""
    rim = polar(radii)
    normal = rim / np.linalg.norm(rim, axis=1)[:, None]
    for time in np.array([0.1, 0.35, 0.8, 2.1]) * solution.end:
        traction = np.einsum("nij,nj->ni", first_piola(solution, rim, time)[:, :2, :2], normal)
        assert np.abs(traction).max() < 1e-9 * solution.young


def test_vortex_keeps_volume_and_turns_by_one_radian_at_most():
    """J = 1; at t = 0.5 s the middle circle has turned by 1 rad and the rims not at all; at t = 1 s all is back."""
    places = polar([0.75, 0.9, 1.0, 1.25])
    assert np.allclose(np.linalg.det(gradient(VORTEX, places, 0.5)), 1.0, rtol=1e-12)
    here, there = (x[:, 0] + 1j * x[:, 1] for x in (places, places + VORTEX.displacement(places, 0.5)))
    turns = np.angle(there / here).reshape(4, 4)
    assert np.allclose(turns[:, 2], 1.0) and np.allclose(turns[:, [0, 3]], 0.0)
    assert np.allclose(VORTEX.displacement(places, 1.0), 0.0, atol=1e-14)


def test_square_and_cube_move_within_their_walls():
    """No motion normal to the faces, where the body slides."""
    for place in (np.array([[0.0, 0.3, 1.0]]), np.array([[1.0, 0.0]])):
        fixed = place % 1.0 == 0.0
        assert np.allclose(AXIS_ALIGNED.displacement(place, 0.0013)[fixed], 0.0, atol=1e-16)


def test_ring_has_its_published_constants_and_force():
    """c1, c2, c3, and the body force at one place and time, from an independent calculation with 60 digits."""
    found = (mms_ring.CONSTANT, mms_ring.LINEAR, mms_ring.SQUARE)
    assert np.allclose(found, (6.6666666667, -13.8888888889, 9.2592592593), rtol=1e-10)
    force = RING.body_force(np.array([[0.37, 0.31]]), 0.0031)[0]
    assert force == pytest.approx([-2844.848699, -2383.521883], rel=1e-9)


def test_ring_swings_as_fast_as_it_starts():
    """The displacement's frequency and the initial velocity belong together: du/dt at 0 is v0, for any radii."""
    places = polar([0.5])
    step = 1e-9
    assert np.allclose(RING.displacement(places, step) / step, RING.velocity(places, 0.0), rtol=1e-9)
