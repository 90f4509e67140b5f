"""What every parametrised geometry keeps: closed and outward rim, complete names, known sizes, sane elements."""

from functools import partial
from math import cos, pi, sin

import numpy as np
import pytest

from core_models.errors import MeshError
from meshes.annulus import annulus
from meshes.beam import beam
from meshes.block import block
from meshes.cook import cook
from meshes.disk import disk
from meshes.facets import facet_vectors, find_facets
from meshes.kinds import KINDS
from meshes.measure import measures
from meshes.necking_bar import necking_bar
from meshes.quality import quality
from meshes.square_bar import square_bar
from meshes.taylor_bar import taylor_bar
from meshes.taylor_quarter import taylor_quarter
from meshes.tension_strip import tension_strip

PLANAR = [name for name, kind in KINDS.items() if kind.dimension == 2]
SOLID = [name for name, kind in KINDS.items() if kind.dimension == 3]


def polygon(corners):
    """Area of a regular polygon with so many corners on the unit circle."""
    return 0.5 * corners * sin(2.0 * pi / corners)


FRUSTUM = 0.25 * (1.0 + 0.9 + 0.81)
"""Height 3 / 4 of a quarter, times the mean of the squares of a radius that grows from 0.9 to 1."""

SQUARE_FRUSTUM = 3.0 * (1.0 + 0.9 + 0.81) / 3.0
"""Height 3, times the mean of the squares of a width that grows from 0.9 to 1."""

CASES = [
    *((kind, partial(block, [1, 2], [3, 5], [2, 3]), 6.0, 4) for kind in PLANAR),
    *((kind, partial(block, [1, 2, 3], [3, 5, 4], [2, 3, 1], distortion=0.1), 6.0, 6) for kind in SOLID),
    *((kind, partial(beam, 2.0, 0.1, [8, 2]), 0.2, 4) for kind in PLANAR),
    *((kind, partial(beam, 2.0, 0.1, [4, 1, 2], width=0.5), 0.1, 6) for kind in SOLID),
    *((kind, partial(cook, [3, 4]), 1440e-6, 4) for kind in PLANAR),
    *((kind, partial(cook, [3, 1, 4], thickness=2.0), 2880e-9, 6) for kind in SOLID),
    *((kind, partial(annulus, 1.0, 2.0, [2, 12]), 3.0 * polygon(12), 2) for kind in PLANAR),
    *((kind, partial(annulus, 1.0, 2.0, [2, 3], quarter=True), 0.75 * polygon(12), 4) for kind in PLANAR),
    *((kind, partial(disk, 1.0, 0.25, centre=(5.0, 6.0)), polygon(16), 1) for kind in PLANAR),
    *((kind, partial(taylor_bar, 1.0, 3.0, 2), 3.0, 4) for kind in PLANAR),
    *((kind, partial(taylor_bar, 1.0, 3.0, 4, structured=False), 3.0, 4) for kind in PLANAR),
    *((kind, partial(taylor_quarter, 1.0, 3.0, 4), 0.75 * polygon(16), 5) for kind in SOLID),
    *((kind, partial(necking_bar, 1.0, 3.0, 2, 4, 0.9, 0.5), 2.85, 4) for kind in PLANAR),
    *((kind, partial(necking_bar, 1.0, 3.0, 4, 4, 0.9, 0.5), FRUSTUM * polygon(16), 5) for kind in SOLID),
    *((kind, partial(square_bar, 1.0, 3.0, 2, 4, 0.9, 0.5), SQUARE_FRUSTUM, 6) for kind in SOLID),
    *((kind, partial(tension_strip, 1.0, 3.0, 2, 4, 0.9), 2.85, 4) for kind in PLANAR),
]
"""Kind, geometry, its measure with straight edges, and its number of boundaries."""


@pytest.mark.parametrize(("kind", "make", "measure", "names"), CASES)
def test_body_is_closed_whole_and_of_its_size(kind, make, measure, names):
    """Facet vectors of the rim sum to zero and enclose the body's measure; every facet of it has one name."""
    mesh = make(kind=kind)
    facets = find_facets(kind, mesh.points, mesh.cells)
    rim = facets.nodes[facets.rim()][:, : facets.corners]
    vectors = facet_vectors(mesh.points[rim])
    size = np.abs(mesh.points).max()
    assert np.abs(vectors.sum(axis=0)).max() < 1e-14 * size ** (mesh.dimension - 1)
    enclosed = np.einsum("ki,ki->", vectors, mesh.points[rim].mean(axis=1)) / mesh.dimension
    assert enclosed == pytest.approx(measure, rel=1e-12)
    named = np.concatenate([mesh.owners(name) for name in mesh.boundaries])
    assert len(mesh.boundaries) == names
    assert len(np.unique(named, axis=0)) == len(named) == len(rim)
    if KINDS[kind].degree == 1:
        assert measures(mesh).sum() == pytest.approx(measure, rel=1e-12)


@pytest.mark.parametrize(
    "make",
    [
        partial(disk, 1.0, 0.2, "tri6"),
        partial(taylor_bar, 1.0, 3.0, 4, structured=False),
        partial(taylor_quarter, 1.0, 3.0, 2, kind="tet4", structured=False),
        partial(taylor_quarter, 1.0, 3.0, 2, kind="hex27"),
    ],
)
def test_same_parameters_give_the_same_mesh_bitwise(make):
    """A geometry has no hidden state, gmsh's neither."""
    first, second = make(), make()
    assert first.points.tobytes() == second.points.tobytes()
    assert np.array_equal(first.cells, second.cells)


@pytest.mark.parametrize("kind", ["quad9", "quad8", "tri6"])
@pytest.mark.parametrize(
    ("make", "exact"),
    [
        (lambda n, kind: disk(1.0, 1.0 / n, kind), pi),
        (lambda n, kind: annulus(1, 2, [n, 6 * n], kind), 3.0 * pi),
    ],
)
def test_quadratic_elements_follow_the_circle(kind, make, exact):
    """Nodes of the rim lie on the circles, and the area converges with order 4."""
    errors = [measures(make(n, kind)).sum() / exact - 1.0 for n in (4, 8)]
    assert np.log2(errors[0] / errors[1]) > 3.8
    rim = make(4, kind).boundaries["outer"]
    radius = np.linalg.norm(make(4, kind).points[rim], axis=-1)
    assert np.ptp(radius) < 1e-15 * 4


@pytest.mark.parametrize(
    ("kind", "structured"), [*((kind, True) for kind in SOLID), ("tet4", False), ("tet10", False)]
)
def test_quarter_bar_lies_between_its_planes(kind, structured):
    """Foot, rear and symmetry planes are flat and exact, nodes of the side lie on the cylinder, no radius beyond."""
    mesh = taylor_quarter(2.0, 3.0, 3, foot_height=0.5, kind=kind, structured=structured)
    on = {name: mesh.points[np.unique(nodes)] for name, nodes in mesh.boundaries.items()}
    assert sorted(on) == ["foot", "rear", "side", "symmetry_x", "symmetry_y"]
    assert (on["foot"][:, 2] == 0.5).all() and (on["rear"][:, 2] == 3.5).all()
    assert (on["symmetry_x"][:, 0] == 0.0).all() and (on["symmetry_y"][:, 1] == 0.0).all()
    assert np.allclose(np.hypot(*on["side"][:, :2].T), 2.0, rtol=1e-15)
    assert (mesh.points[:, :2] >= 0.0).all()


@pytest.mark.parametrize("kind", SOLID)
def test_volume_of_the_quarter_bar_converges(kind):
    """With order 2 for linear elements, 4 for quadratic ones."""
    errors = [measures(taylor_quarter(1.0, 1.0, n, 2, kind=kind)).sum() / (0.25 * pi) - 1.0 for n in (4, 8)]
    assert np.log2(errors[0] / errors[1]) > 2.0 * KINDS[kind].degree - 0.2


@pytest.mark.parametrize("across", [2, 3, 4, 5, 7, 8, 16])
def test_core_and_outer_patches_are_well_shaped(across):
    """No corner of the quarter bar's elements is sharper than sin = 0.79, no edge shorter than half the size."""
    figures = quality(taylor_quarter(1.0, 1.0, across))
    assert figures.min_scaled_jacobian > 0.79
    assert figures.min_edge > 0.5 / across and figures.max_aspect_ratio < 2.4


@pytest.mark.parametrize("kind", ["tet4", "tet10"])
def test_irregular_tetrahedra_are_no_slivers(kind):
    """gmsh's tetrahedra keep a distance from collapse that explicit steps can live with."""
    figures = quality(taylor_quarter(1.0, 2.0, 3, kind=kind, structured=False))
    assert figures.min_scaled_jacobian > 0.15 and figures.min_edge > 0.25 / 3


@pytest.mark.parametrize("kind", PLANAR)
def test_irregular_bar_is_graded_and_its_rim_exact(kind):
    """So many elements stand on the foot, more on the rear by the grading; the rim is straight to the last digit."""
    mesh = taylor_bar(2.0, 8.0, 4, grading=2.0, foot_height=1.0, kind=kind, structured=False)
    counts = {name: len(nodes) for name, nodes in mesh.boundaries.items()}
    assert (counts["foot"], counts["rear"]) == (4, 8) and counts["side"] > 16
    on = {name: mesh.points[np.unique(nodes)] for name, nodes in mesh.boundaries.items()}
    assert (on["axis"][:, 0] == 0.0).all() and (on["side"][:, 0] == 2.0).all()
    assert (on["foot"][:, 1] == 1.0).all() and (on["rear"][:, 1] == 9.0).all()
    assert quality(mesh).min_scaled_jacobian > 0.4


@pytest.mark.parametrize("kind", SOLID)
def test_layers_of_the_quarter_bar_are_graded(kind):
    """`grading` is the height of the elements at the foot by that at the rear, in geometric progression."""
    mesh = taylor_quarter(1.0, 3.0, 2, 4, grading=8.0, kind=kind)
    corners = np.unique(mesh.cells[:, : KINDS[kind].corners])
    sizes = np.diff(np.unique(mesh.points[corners, 2]))
    assert np.allclose(sizes[:-1] / sizes[1:], 2.0, rtol=1e-12)


def test_cook_has_its_corners():
    """(0, 0), (48, 44), (48, 60), (0, 44) mm, and the free end's middle at 52 mm."""
    mesh = cook([2, 2])
    right = mesh.points[np.unique(mesh.boundaries["right"])]
    left = mesh.points[np.unique(mesh.boundaries["left"])]
    assert np.allclose(np.sort(right[:, 1]), [44e-3, 52e-3, 60e-3]) and np.allclose(right[:, 0], 48e-3)
    assert np.allclose(np.sort(left[:, 1]), [0.0, 22e-3, 44e-3])


def test_quarter_of_a_ring_has_its_symmetry_planes_exactly():
    """x = centre on symmetry_x, y = centre on symmetry_y."""
    mesh = annulus(1.0, 2.0, [2, 5], quarter=True)
    assert (mesh.points[mesh.boundaries["symmetry_x"], 0] == 0.0).all()
    assert (mesh.points[mesh.boundaries["symmetry_y"], 1] == 0.0).all()
    assert mesh.points[mesh.boundaries["outer"][0, 0]].tolist() == [2.0, 0.0]
    middle = mesh.points[mesh.boundaries["inner"]].mean(axis=(0, 1))
    assert middle @ [cos(pi / 4), sin(pi / 4)] > 0.85


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda: annulus(2.0, 1.0, [2, 8]), "outer is 1, inner 2"),
        (lambda: annulus(0.0, 1.0, [2, 8]), "inner is 0"),
        (lambda: annulus(1.0, np.inf, [2, 8]), "outer is inf"),
        (lambda: annulus(1.0, 2.0, [2, 2]), "counts around is 2"),
        (lambda: annulus(1.0, 2.0, [2, 8], "hex8"), "no kind of element 'hex8' in 2-D"),
        (lambda: annulus(1.0, 2.0, [2, 8], centre=(1, 2, 3)), "centre is .*; give 2 finite"),
        (lambda: disk(-1.0, 0.1), "radius is -1"),
        (lambda: disk(1.0, 2.0), "size is 2, the radius 1"),
        (lambda: disk(1.0, 0.1, "tet4"), "in 2-D"),
        (lambda: disk(1.0, 0.1, centre=(np.nan, 0)), "centre is"),
        (lambda: beam(1.0, 0.1, [4, 2], "hex8"), "give 3 numbers for hex8"),
        (lambda: beam(1.0, 0.0, [4, 2]), "height is 0"),
        (lambda: beam(1.0, 0.1, [4, 2], width=1.0), "width is for 3-D"),
        (lambda: cook([4, 0]), "counts is"),
        (lambda: cook([4, 4], unit=np.nan), "unit is nan"),
        (lambda: cook([4, 4], thickness=2.0), "thickness is for 3-D"),
        (lambda: taylor_bar(1.0, 2.0, 4, kind="hex8"), "in 2-D"),
        (lambda: taylor_bar(1.0, 2.0, 4, 8, structured=False), "elements_along is for structured"),
        (lambda: taylor_bar(1.0, 2.0, 5, structured=False), "even number for irregular quads, such as 6"),
        (lambda: taylor_quarter(1.0, 2.0, 4, kind="quad4"), "in 3-D"),
        (lambda: taylor_quarter(1.0, 2.0, 1), "elements_across is 1; give a whole number of at least 2"),
        (lambda: taylor_quarter(1.0, 2.0, 4, structured=False), "irregular hex8 elements are not offered"),
        (
            lambda: taylor_quarter(1.0, 2.0, 4, 8, kind="tet4", structured=False),
            "elements_along is for struct",
        ),
        (lambda: taylor_quarter(1.0, 2.0, 4, grading=0.0), "grading is 0"),
        (lambda: taylor_quarter(0.0, 2.0, 4), "radius is 0"),
        (lambda: necking_bar(1.0, 2.0, 4, taper=1.1), "taper is 1.1; give a number from 0.5 to 1"),
        (lambda: square_bar(1.0, 2.0, 4, 4, taper=0.1), "taper is 0.1"),
        (lambda: square_bar(1.0, 2.0, 4, 4, grading=0.0), "grading is 0"),
        (lambda: square_bar(1.0, 2.0, 4, 4, kind="quad4"), "in 3-D"),
        (lambda: tension_strip(1.0, 2.0, 4, 4, taper=0.1), "taper is 0.1"),
        (lambda: tension_strip(1.0, 2.0, 4, 4, kind="hex8"), "in 2-D"),
        (lambda: taylor_quarter(1.0, np.nan, 4), "length is nan"),
        (lambda: taylor_bar(1.0, 2.0, "8"), "elements_across is 8; give a whole number"),
        (lambda: taylor_bar(1.0, 0.1, 4, structured=False), "gmsh cannot mesh it .1D mesh cannot be divided"),
        (lambda: taylor_bar(1.0, 1e9, 4), "makes some 1.6e.10 elements"),
        (lambda: disk(1.0, 1e-8), "makes some 3e.16 elements"),
        (lambda: block([0, 0], [1, 1], [10**6, 10**6]), "makes some 1e.12 elements"),
    ],
)
def test_senseless_parameters_are_refused_by_name(make, told):
    """A parameter outside its range is a one-line MeshError that names it and its value."""
    with pytest.raises(MeshError, match=told) as caught:
        make()
    assert "\n" not in str(caught.value)
