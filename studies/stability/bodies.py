"""Small bodies of the hard cases, by any variant."""

from dataclasses import replace
from functools import cache
from typing import Any

from core_models.bulk_viscosity import BulkViscosity
from core_models.cards import shipped_materials
from core_models.cards.reader import read_material
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.linear import LinearHardening
from core_models.flow.voce import Voce
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from meshes.block import block
from meshes.mesh import Mesh
from meshes.taylor_bar import taylor_bar
from studies.scenes.reader import read_scene
from studies.stability.variants import variant_of

RADIUS = 1.6e-3  # m
ACROSS, ASPECT = 4, 3
STIFF = 1000.0  # bulk over shear modulus
VISCOSITY = BulkViscosity()


@cache
def copper() -> Material:
    """OFHC copper: hypoelastic, Johnson-Cook, Mie-Grüneisen, heating, melting at 1356 K; damage reported."""
    return read_material(shipped_materials()["copper_ofhc_johnson_cook"]).material


@cache
def classic() -> Material:
    """The classic bar's copper: hyperelastic, neo-Hookean, linear hardening."""
    return read_scene("taylor-classic").material


def hardening(yield_stress: float, modulus: float) -> Material:
    """The same with another linear hardening [Pa]."""
    return replace(classic(), flow=LinearHardening(yield_stress, modulus))


def elastic() -> Material:
    """The same with a yield stress that is never reached."""
    return hardening(0.9 * classic().elasticity.shear_modulus, 0.0)


def stiff() -> Material:
    """The same with a bulk modulus STIFF times the shear modulus, a tenth of its own."""
    shear = classic().elasticity.shear_modulus / 10.0
    bulk = STIFF * shear
    return replace(classic(), elasticity=IsotropicElastic(bulk, shear), eos=NeoHookean(bulk))


def softening() -> Material:
    """The same with a flow stress that falls with strain until next to nothing is left."""
    return replace(classic(), flow=Voce(400e6, 1e3, 10.0, 0.0))


def hyperelastic(material: Material) -> Material:
    """A material with the hyperelastic update."""
    return replace(material, update=HyperelasticPlastic(1e-10))


def bar_mesh(variant: str, *, scale: float = 1.0, across: int = ACROSS, **options: Any) -> Mesh:
    """A bar of the variant's kind of element, RADIUS times a scale, so many elements across it."""
    radius = scale * RADIUS
    return taylor_bar(radius, ASPECT * radius, across, kind=variant_of(variant).kind, **options)


def bar(
    variant: str,
    material: Material,
    *,
    mesh: Mesh | None = None,
    cell: float = RADIUS / ACROSS,
    viscosity: BulkViscosity | None = VISCOSITY,
    **options: Any,
) -> Any:
    """The solver of a bar by a variant, from a mesh of its own or the usual one, with options of the solver."""
    asked = variant_of(variant)
    body = bar_mesh(variant) if mesh is None else mesh
    options = {"viscosity": viscosity} | asked.options | options
    if asked.solver == "fem-explicit":
        from fem import ExplicitSolver

        return ExplicitSolver(body, material, **options)
    from mpm import Solver

    return Solver(body, material, cell_size=cell, **options)


def square(variant: str, *, across: int = 2 * ACROSS, distortion: float = 0.0) -> Mesh:
    """A square of 2 RADIUS along each edge, from (0, 0) on, so many elements along it."""
    counts = [across, across]
    edge = 2.0 * RADIUS
    return block([0.0, 0.0], [edge, edge], counts, variant_of(variant).kind, distortion=distortion, seed=1)
