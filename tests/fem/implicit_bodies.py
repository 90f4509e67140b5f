"""Bodies that the tests of implicit finite elements share."""

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.voce import Voce
from core_models.loads import Prescribed, Symmetry
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from fem import ImplicitSolver
from meshes.necking_bar import necking_bar

BULK, SHEAR = 164.206e9, 80.1938e9
YOUNG = 9.0 * BULK * SHEAR / (3.0 * BULK + SHEAR)
RADIUS, LENGTH = 6.413e-3, 26.667e-3
PULL = 7e-3  # m per second


def steel(yield_stress=0.45e9):
    """The necking bar's steel."""
    flow = Voce(yield_stress, yield_stress + 0.265e9, 16.93, 0.12924e9)
    return Material(
        "steel", 7800.0, HyperelasticPlastic(), IsotropicElastic(BULK, SHEAR), NeoHookean(BULK), flow, VonMises()
    )  # fmt: skip


def bar(across, along, taper, increment, **options):
    """The necking bar, pulled by PULL within 1 s."""
    mesh = necking_bar(
        RADIUS, LENGTH, across, along, taper, options.pop("grading", 1.0), options.pop("kind", "quad4")
    )
    loads = (Symmetry("neck"), Prescribed("end", 1, PULL))
    return ImplicitSolver(mesh, options.pop("material", steel()), loads=loads, increment=increment, **options)


def pulled(solver, end):
    """Force [N] at the end of every increment up to a time [s]."""
    forces = []
    while solver.time < end:
        solver.advance(end)
        forces.append(solver.boundary_force("end")[1])
    return np.array(forces)
