"""Where particles start, and what each stands for."""

import numpy as np
import pytest

from core_models.errors import SceneError
from meshes.geometry import volumes_of_revolution
from mpm.particles import seed


@pytest.fixture
def mesh(bar, distorted):
    """A distorted bar."""
    return distorted(bar(4, 6), 0.2)


def test_gauss_seeding_is_the_points_of_the_finite_element_method(build, mesh, elastic):
    """Positions, volumes and domains of the particles are those of the FEM points, in the same order."""
    particles, fem = build("mpm", mesh, elastic), build("fem-explicit", mesh, elastic)
    size = mesh.points.max()
    assert np.abs(particles.point_positions() - fem.point_positions()).max() < 1e-15 * size
    assert np.allclose(particles.point_volumes(), fem.point_volumes(), rtol=1e-13, atol=0.0)
    assert np.abs(particles.domains() - fem.domains()).max() < 1e-15 * size
    assert particles.mass == pytest.approx(fem.mass, rel=1e-14)


@pytest.mark.parametrize("seeding", ["gauss", "lattice"])
def test_volumes_sum_to_the_body(mesh, seeding):
    """The particles' volumes sum exactly to the body's volume of revolution."""
    exact = volumes_of_revolution(mesh.corners()).sum()
    assert seed(mesh, seeding).volumes.sum() == pytest.approx(exact, rel=1e-14)


def test_lattice_volumes_are_those_of_their_domains(mesh):
    """On a lattice each particle has exactly the volume of revolution of its own domain."""
    particles = seed(mesh, "lattice")
    domains = particles.positions[:, None] + particles.corners
    assert np.allclose(particles.volumes, volumes_of_revolution(domains), rtol=1e-12, atol=0.0)


@pytest.mark.parametrize("seeding", ["gauss", "lattice"])
def test_the_outline_is_the_boundary_of_the_mesh(build, bar, elastic, seeding):
    """Before anything moves, foot, side and rear are the mesh's own lines, in its order."""
    mesh = bar(4, 6, gap=1.0)
    outline = build("mpm", mesh, elastic, seeding=seeding).outline()
    assert list(outline) == ["foot", "side", "rear"]
    for name, line in outline.items():
        pairs = mesh.boundaries[name]
        nodes = mesh.points[np.append(pairs[:, 0], pairs[-1, 1])]
        assert np.allclose(line[::2], nodes, atol=1e-15)


@pytest.mark.parametrize(
    ("option", "remedy"),
    [
        ({"transfer": "apik"}, "apic"),
        ({"seeding": "gaus"}, "gauss"),
        ({"cell_size": 0.0}, "cell_size"),
        ({"wall": "plan"}, "plane"),
    ],
)
def test_senseless_options_are_refused(build, bar, elastic, option, remedy):
    """A wrong transfer, seeding, cell size or wall is refused in one line that tells what to use."""
    with pytest.raises(SceneError, match=remedy) as refusal:
        build("mpm", bar(2, 2), elastic, **option)
    assert "\n" not in str(refusal.value)
