"""Where particles start, and what each stands for."""

import numpy as np
import pytest

from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from meshes.block import block
from meshes.facets import facet_vectors
from meshes.geometry import volumes_of_revolution
from meshes.kinds import KINDS
from mpm.particles import domain_corners, rim_faces, seed

BRICKS = [name for name, kind in KINDS.items() if not kind.simplex]


@pytest.fixture
def mesh(bar, distorted):
    """A distorted bar."""
    return distorted(bar(4, 6), 0.2)


def distorted_block(kind):
    """A block of volume 6 or 24 and its geometry; linear elements inside are uneven (for others no rule is exact)."""
    d = KINDS[kind].dimension
    counts = (2, 3, 2)[:d]
    body = block((0.0,) * d, (2.0, 3.0, 4.0)[:d], counts, kind, 0.2 * (KINDS[kind].degree == 1))
    return body, PlaneStrain() if d == 2 else Spatial()


def polyhedron_volumes(corners):
    """Areas of quads (n, 4, 2), or volumes of hexahedra (n, 8, 3) with ruled faces, which corners may repeat."""
    if corners.shape[2] == 2:
        x, y = corners[..., 0], corners[..., 1]
        return 0.5 * (x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum(axis=1)
    total = np.zeros(len(corners))
    middle = corners.mean(axis=1)
    for facet in KINDS["hex8"].facets:
        side = corners[:, list(facet)]
        a, b = side[:, 2] - side[:, 0], side[:, 3] - side[:, 1]
        centre = side.mean(axis=1)
        # A ruled face: its flux of x is that of its middle, plus a part that its neighbour takes away again.
        total += 0.5 * np.einsum("ni,ni->n", centre - middle, np.cross(a, b)) / 3.0
    return total


def test_gauss_seeding_is_the_points_of_the_finite_element_method(build, mesh, elastic):
    """Positions, volumes and domains of the particles are those of the FEM points, in the same order."""
    particles, fem = (build(method, mesh, elastic, wall=None) for method in ("mpm", "fem-explicit"))
    size = mesh.points.max()
    assert np.abs(particles.point_positions() - fem.point_positions()).max() < 1e-15 * size
    assert np.allclose(particles.point_volumes(), fem.point_volumes(), rtol=1e-13, atol=0.0)
    assert np.abs(particles.domains() - fem.domains()).max() < 1e-15 * size
    assert particles.mass == pytest.approx(fem.mass, rel=1e-14)


@pytest.mark.parametrize("seeding", ["gauss", "lattice"])
def test_volumes_of_revolution_sum_to_the_body(mesh, seeding):
    """The particles' volumes sum exactly to the body's volume of revolution."""
    exact = volumes_of_revolution(mesh.corners()).sum()
    assert seed(mesh, Axisymmetric(), seeding).volumes.sum() == pytest.approx(exact, rel=1e-14)


@pytest.mark.parametrize("kind", KINDS)
def test_volumes_sum_to_the_body(kind):
    """For every kind of element, points of the full rule carry the whole volume, each some of it."""
    body, geometry = distorted_block(kind)
    particles = seed(body, geometry)
    assert (particles.volumes > 0.0).all()
    assert particles.volumes.sum() == pytest.approx(6.0 if body.dimension == 2 else 24.0, rel=1e-13)
    assert len(particles.positions) == len(particles.volumes) == len(domain_corners(body))


@pytest.mark.parametrize("kind", BRICKS)
def test_a_lattice_fills_the_body(kind):
    """Even parts of quads and hexahedra fill the body."""
    body, geometry = distorted_block(kind)
    exact = 6.0 if body.dimension == 2 else 24.0
    assert seed(body, geometry, "lattice").volumes.sum() == pytest.approx(exact, rel=1e-13)


def test_lattice_volumes_are_those_of_their_domains(mesh):
    """On a lattice each particle has exactly the volume of revolution of its own domain."""
    volumes = seed(mesh, Axisymmetric(), "lattice").volumes
    exact = volumes_of_revolution(domain_corners(mesh, "lattice"))
    assert np.allclose(volumes, exact, rtol=1e-12, atol=0.0)


@pytest.mark.parametrize("kind", [name for name, kind in KINDS.items() if kind.degree == 1])
def test_domains_fill_the_body(kind):
    """The domains of the particles make up the body, without gap or overlap in sum."""
    body, _ = distorted_block(kind)
    exact = 6.0 if body.dimension == 2 else 24.0
    assert polyhedron_volumes(domain_corners(body)).sum() == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_faces_of_particles_make_up_the_boundaries(kind):
    """Their area vectors sum to those of the named sides, outwards, and the rim is closed."""
    body, geometry = distorted_block(kind)
    particles = seed(body, geometry)
    sides = {"left": (0, -1), "right": (0, 1), "bottom": (body.dimension - 1, -1)}
    size = np.ptp(body.points, axis=0)
    for name, (axis, sign) in sides.items():
        faces = particles.faces[name]
        total = facet_vectors(faces.corners).sum(axis=0)
        expected = np.zeros(body.dimension)
        expected[axis] = sign * size.prod() / size[axis]
        assert np.allclose(total, expected, atol=1e-12)
        places = particles.positions[faces.particles][:, None] + faces.corners
        assert np.ptp(places[..., axis]) < 1e-12
    rim = rim_faces(body, geometry, "gauss", particles, ())
    assert np.abs(facet_vectors(rim.corners).sum(axis=0)).max() < 1e-12
    assert len(rim.particles) == sum(len(faces.particles) for faces in particles.faces.values())


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


def test_boundary_positions_hold_every_corner_once(body):
    """In space, the particles' faces on a side meet in the corners of an even lattice."""
    solver = body("spatial", counts=(2, 3, 2))
    found = solver.boundary_positions("top")
    assert len(found) == 5 * 7
    assert np.allclose(found[:, 2], solver.mesh.points[:, 2].max(), rtol=1e-14)
    assert np.allclose(found.max(axis=0), solver.mesh.points.max(axis=0), rtol=1e-14)


def test_an_initial_displacement_stores_the_energy_of_its_stress(body, elastic):
    """A body that starts stretched has the deformation gradient, volume and elastic energy of that."""
    stretch = 1.002
    solver = body(displacement=lambda x: (stretch - 1.0) * x * [1.0, 0.0])
    gradient = np.diag([stretch, 1.0, 1.0])
    assert np.abs(solver.points.fields()["deformation_gradient"].array - gradient).max() < 1e-9
    assert np.allclose(solver.point_volumes(), stretch * solver.points.reference_volumes, rtol=1e-9)
    bulk, shear = elastic.elasticity
    volume = solver.points.reference_volumes.sum()
    exact = 0.5 * (bulk + 4.0 / 3.0 * shear) * (stretch - 1.0) ** 2 * volume
    assert solver.ledger.strain == pytest.approx(exact, rel=5e-3)
    assert solver.ledger.initial == solver.ledger.strain


@pytest.mark.parametrize(
    ("option", "remedy"),
    [
        ({"transfer": "apik"}, "apic"),
        ({"seeding": "gaus"}, "gauss"),
        ({"interpolation": "quadratik"}, "quadratic"),
        ({"geometry": "plane-stress"}, "plane-strain"),
        ({"geometry": "spatial"}, "axisymmetric"),
        ({"cell_size": 0.0}, "cell_size"),
        ({"xpic_order": 2.5, "transfer": "xpic"}, "whole number"),
        ({"velocity": (1.0, 2.0, 3.0)}, "give 2 components"),
        ({"displacement": 3.0}, "function"),
        ({"wall": "plan"}, "plane"),
    ],
)
def test_senseless_options_are_refused(build, bar, elastic, option, remedy):
    """A wrong name or number is refused in one line that tells what to use."""
    with pytest.raises(SceneError, match=remedy) as refusal:
        build("mpm", bar(2, 2), elastic, **option)
    assert "\n" not in str(refusal.value)


def test_a_grid_too_coarse_for_the_body_is_refused(body):
    """Less than two cells across is refused with the numbers; a mirrored half needs one cell only."""
    with pytest.raises(SceneError, match=r"too coarse.*along x.*1\.5 cells"):
        body(counts=(3, 8), cell_size=2.0 * 0.4e-3)
    body(counts=(3, 8), cell_size=2.0 * 0.4e-3, symmetries=["left"])


def test_a_lattice_in_triangles_is_refused(body):
    """There are no even parts of a triangle."""
    with pytest.raises(SceneError, match="quads or hexahedra, not tri3"):
        body(kind="tri3", seeding="lattice")


def test_particles_wider_than_a_cell_are_refused_by_gimp(body):
    """GIMP's three nodes along an axis would not do."""
    with pytest.raises(SceneError, match=r"no wider than a cell.*0\.0002 m.*0\.00015 m"):
        body(kind="quad4", counts=(4, 4), interpolation="gimp", cell_size=0.15e-3, seeding="gauss")
