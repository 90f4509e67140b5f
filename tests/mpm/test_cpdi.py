"""Convected particle domains: exact for linear fields however they are deformed, and limited in a way that is told."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import RunFailure, SceneError
from core_models.loads import Symmetry
from meshes.block import block
from meshes.kinds import KINDS
from mpm import Solver
from mpm.interpolation.cpdi import ConvectedDomain, extents, half_edges
from mpm.particles import domain_corners, parts_of
from tests.mpm.conftest import CELL, stir

PLANES = {
    "plane-strain": ["left", "bottom"],
    "axisymmetric": ["bottom"],
    "spatial": ["left", "front", "bottom"],
}
RATES = np.array([300.0, -500.0, 200.0])
STRAINS = np.array([1.5, -0.3, 0.2])


@pytest.fixture(params=["plane-strain", "axisymmetric", "spatial"])
def deformed(request, elastic):
    """A distorted block in the corner of symmetry planes, stretched to 2.5 times its width, and without stress."""
    geometry = request.param
    d = 3 if geometry == "spatial" else 2
    counts = (4, 5, 3)[:d]
    mesh = block([0.0] * d, CELL * np.array(counts), counts, "quad4" if d == 2 else "hex8", distortion=0.2)
    solver = Solver(
        mesh,
        elastic,
        cell_size=CELL,
        geometry=geometry,
        interpolation="cpdi",
        loads=tuple(Symmetry(name) for name in PLANES[geometry]),
        displacement=lambda x: x * STRAINS[:d],
    )
    solver.points.old.stress[:] = 0.0
    return solver


def test_a_linear_velocity_field_survives_exactly(deformed):
    """In stretched domains, at axis and symmetry planes: velocity, affine velocity and F come back as they were."""
    d = deformed.mesh.dimension
    rates, start, before = (
        RATES[:d],
        deformed.positions.copy(),
        deformed.points.old_deformation_gradient.copy(),
    )
    deformed.velocities[:], deformed.affine[:] = rates * start, np.diag(rates)
    dt = deformed.time_step
    deformed.advance()
    hoop = 0.0 if d == 3 or before[0, 2, 2] == 1.0 else rates[0]
    change = np.diag(1.0 + dt * np.append(rates, [hoop])[:3])
    assert np.allclose(deformed.velocities, rates * start, rtol=1e-12, atol=1e-12)
    assert np.abs(deformed.affine - np.diag(rates)).max() < 1e-9 * 500.0
    assert np.allclose(deformed.positions, (1.0 + dt * rates) * start, rtol=1e-13)
    assert np.abs(deformed.points.old_deformation_gradient - change @ before).max() < 1e-13


def test_nodal_forces_do_the_power_of_the_stress(deformed, nodes):
    """Forces times velocities of the nodes are minus stress times rate of the particles."""
    random = np.random.default_rng(0)
    stress = deformed.points.old.stress
    stress[:] = random.normal(scale=1e8, size=stress.shape)
    if deformed.mesh.dimension == 2:
        stress[:, 4:] = 0.0
    stir(deformed)
    old, volumes = deformed.points.old_deformation_gradient.copy(), deformed.point_volumes()
    stress, dt = stress.copy(), deformed.time_step
    deformed.advance()
    gradient = (deformed.points.old_deformation_gradient @ np.linalg.inv(old) - np.eye(3)) / dt
    symmetric = 0.5 * (gradient + gradient.transpose(0, 2, 1))
    rates = symmetric[:, [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]
    powers = volumes[:, None] * stress * rates * [1.0, 1.0, 1.0, 2.0, 2.0, 2.0]
    at = nodes(deformed)
    assert (at.force * at.after).sum() == pytest.approx(-powers.sum(), abs=1e-11 * np.abs(powers).sum())


@pytest.mark.parametrize("options", [{"transfer": "xpic"}, {"update": "musl"}], ids=["xpic", "musl"])
def test_every_transfer_conserves_momentum(body, options):
    """Also those that visit the grid more than once."""
    solver = body(interpolation="cpdi", **options)
    stir(solver)
    momentum = solver.momentum
    scale = float(solver.particle_mass @ np.linalg.norm(solver.velocities, axis=1))
    for _ in range(5):
        solver.advance()
    assert np.abs(solver.momentum - momentum).max() < 1e-12 * scale


@pytest.mark.parametrize("kind", KINDS)
def test_domains_are_as_large_as_what_they_stand_for(kind):
    """Half edges make a parallelogram or parallelepiped of the particle's own area or volume, the right way round."""
    d = KINDS[kind].dimension
    mesh = block([0.0] * d, [2.0, 3.0, 1.0][:d], (2, 2, 1)[:d], kind)
    corners = domain_corners(mesh)
    areas = np.linspace(1.0, 2.0, len(corners)) / len(parts_of(mesh, "gauss").weights)
    volumes = 2**d * np.linalg.det(half_edges(corners, areas))
    assert np.allclose(volumes, areas, rtol=1e-12)


def test_energy_closes_in_an_impact(build, bar, j2):
    """Also where domains are squeezed thin: the step takes notice of them."""
    options = {"interpolation": "cpdi", "viscosity": BulkViscosity(), "wall": "unilateral", "cfl": 0.25}
    solver = build("mpm", bar(3, 10), j2, velocity=-227.0, **options)
    first = solver.time_step
    while solver.time < 12e-6:
        solver.advance()
    assert abs(solver.ledger.relative_error) < 1e-2
    assert solver.time_step < 0.7 * first
    assert solver.ledger.plastic > 0.75 * solver.ledger.initial


def test_a_domain_stretched_over_too_many_cells_ends_the_run(body):
    """With one line that names the particle, how far it is stretched, and what to do."""
    solver = body(interpolation="cpdi")
    solver.points.old_deformation_gradient[7, 0, 0] = 7.0
    with pytest.raises(
        RunFailure, match=r"point 7 .* 3.5 cells along x, 3 are possible: .*'total'"
    ) as failure:
        solver.advance()
    assert "\n" not in str(failure.value)


def test_particles_wider_than_a_domain_may_be_are_refused(body):
    """From the start, with the widths."""
    with pytest.raises(SceneError, match="give larger cells or a finer mesh"):
        body(interpolation="cpdi", cell_size=CELL / 8.0)


def test_extents_are_those_of_the_deformed_box():
    """A unit square sheared by 1 is 2 wide and 1 high."""
    gradient = np.eye(3)[None].copy()
    gradient[0, 0, 1] = 1.0
    assert np.allclose(extents(ConvectedDomain(0.5 * np.eye(2)[None], gradient)), [[2.0, 1.0]])
