"""The average of a nonlocal damage is one over a ball of the whole body: rotated, extended and mirrored."""

import numpy as np
import pytest

from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.mirror_images import Plane, mirror_images
from core_models.nonlocal_average import bell_weights, circle_mean

RADIUS = 1.0
MOMENT = RADIUS**2 / 9.0  # mean of x^2 under the bell, in a ball round 0


def grid(*bounds, size):
    """Centres of cells (n, d) that fill a box."""
    lines = [np.arange(low + 0.5 * size, high, size) for low, high in bounds]
    return np.stack([line.ravel() for line in np.meshgrid(*lines, indexing="ij")], axis=1)


def averaged(places, volumes, field, geometry, planes=()):
    """The average of a field (n,) at all places."""
    return bell_weights(places, volumes, RADIUS, geometry, planes) @ field


def test_in_axisymmetry_the_average_is_one_over_a_ball():
    """Of r^2 it is r^2 + 2 R^2 / 9, of z^2 it is z^2 + R^2 / 9, on the axis and off it, as in three dimensions."""
    places = grid((0.0, 3.0), (-1.5, 1.5), size=0.04)
    r, z = places.T
    inside = (r < 1.9) & (np.abs(z) < 0.4)
    for field, more in ((r**2, 2.0), (z**2, 1.0), (z, 0.0)):
        means = averaged(places, r, field, Axisymmetric())
        assert means[inside] == pytest.approx((field + more * MOMENT)[inside], abs=2e-4)


def test_in_plane_strain_the_average_is_one_over_a_ball():
    """Of x^2 it is x^2 + R^2 / 9: the ball reaches out of the plane."""
    places = grid((-1.5, 1.5), (-1.5, 1.5), size=0.05)
    x, y = places.T
    inside = np.hypot(x, y) < 0.4
    means = averaged(places, np.ones(len(places)), x**2, PlaneStrain())
    assert means[inside] == pytest.approx((x**2 + MOMENT)[inside], abs=2e-4)


def test_a_slice_between_two_mirrors_is_in_plane_strain():
    """A sheet of one layer of points, mirrored in front and behind, has the weights of plane strain."""
    flat = grid((0.0, 2.0), (0.0, 2.0), size=0.2)
    sheet = np.column_stack([flat, np.full(len(flat), 0.01)])
    planes = (Plane(2, 0.0, 1), Plane(2, 0.02, -1))
    weights = bell_weights(sheet, np.ones(len(flat)), RADIUS, Spatial(), planes).toarray()
    expected = bell_weights(flat, np.ones(len(flat)), RADIUS, PlaneStrain()).toarray()
    assert weights == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("geometry", [Axisymmetric(), PlaneStrain()])
def test_half_a_body_averages_as_the_whole(geometry):
    """Cut at a symmetry plane, every point has the average that it has in the whole body."""
    whole = grid((0.0, 2.0), (-2.0, 2.0), size=0.1)
    z = whole[:, 1]
    field = np.cos(3.0 * whole[:, 0]) * np.exp(-np.abs(z))
    half = z > 0.0
    volumes = whole[:, 0]
    expected = averaged(whole, volumes, field, geometry)[half]
    means = averaged(whole[half], volumes[half], field[half], geometry, (Plane(1, 0.0, 1),))
    assert means == pytest.approx(expected, rel=1e-12)


def test_images_between_two_mirrors_go_on():
    """A point at 0.3 between 0 and 1 has its images at 2 k + 0.3 and 2 k - 0.3; two axes mirror each other's."""
    places = np.array([[0.3, 0.1]])
    planes = (Plane(0, 0.0, 1), Plane(0, 1.0, -1))
    images, owners = mirror_images(places, planes, 4.0)
    assert sorted(images[:, 0]) == pytest.approx([-3.7, -2.3, -1.7, -0.3, 0.3, 1.7, 2.3, 3.7, 4.3])
    assert np.array_equal(images[0], places[0]) and not owners.any()
    images, owners = mirror_images(places, (Plane(0, 0.0, 1), Plane(1, 0.0, 1)), 4.0)
    assert {(x, y) for x, y in images} == {(sx * 0.3, sy * 0.1) for sx in (1, -1) for sy in (1, -1)}
    assert len(owners) == 4


def test_the_mean_over_a_circle_is_exact():
    """Gauss points on the arc give the closed form of the integral, for whole circles and for arcs."""
    a, b = np.array([1.0, 0.8, 0.5, 0.9]), np.array([0.0, 0.7, 3.0, 40.0])
    end = 2.0 * np.arcsin(np.sqrt(np.minimum(1.0, a / np.maximum(b, a))))
    end[b <= a] = np.pi
    mean, half = a - 0.5 * b, 0.5 * b
    exact = (
        (mean**2 + 0.5 * half**2) * end + 2.0 * mean * half * np.sin(end) + 0.25 * half**2 * np.sin(2.0 * end)
    )
    assert circle_mean(a, b) == pytest.approx(exact / np.pi, rel=1e-9)
