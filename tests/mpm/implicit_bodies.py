"""Bodies that the tests of implicit material points share."""

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.voce import Voce
from core_models.loads import Prescribed, Symmetry
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from meshes.necking_bar import necking_bar
from mpm import ImplicitSolver

H = 1e-3  # m, size of the cells
MEAN = "mean-dilatation"
RADIUS, LENGTH, TAPER = 6.413e-3, 26.667e-3, 0.982
PULL = 7e-3  # m per second


def steel():
    """The necking bar's steel."""
    bulk, shear = 164.206e9, 80.1938e9
    flow = Voce(0.45e9, 0.715e9, 16.93, 0.12924e9)
    return Material(
        "steel", 7800.0, HyperelasticPlastic(), IsotropicElastic(bulk, shear), NeoHookean(bulk), flow, VonMises()
    )  # fmt: skip


def solve(mesh, loads, increment=0.5, end=1.0, **options):
    """Lead a body up to a time [s]."""
    solver = ImplicitSolver(mesh, steel(), loads=loads, increment=increment, **({"cell_size": H} | options))
    while solver.time < end:
        solver.advance(end)
    return solver


def bar(increment, across=5, along=20, taper=TAPER, grading=0.2, **options):
    """The necking bar, with lines of the grid through the nodes on its axis."""
    mesh = necking_bar(RADIUS, LENGTH, across, along, taper, grading)
    heights = np.sort(mesh.points[mesh.points[:, 0] == 0.0, 1])
    loads = (Symmetry("neck"), Prescribed("end", 1, PULL))
    options = {"cell_size": (RADIUS / across, heights), "cure": MEAN} | options
    return ImplicitSolver(mesh, steel(), loads=loads, increment=increment, **options)


def pulled(solver, end):
    """Force [N] at the end of every increment up to a time [s]."""
    forces = []
    while solver.time < end:
        solver.advance(end)
        forces.append(solver.boundary_force("end")[1])
    return np.array(forces)
