"""The tangent of continued flow is the limit of that of a step, with every yield condition; voids make it unstable."""

import numpy as np
import pytest

from core_models.damage.gurson import VoidNucleation
from core_models.driver import drive
from core_models.flow.linear import LinearHardening
from core_models.kinematic_hardening.armstrong_frederick import ArmstrongFrederick
from core_models.points import MaterialPoints
from core_models.stability.drucker import DruckerStability
from core_models.updates.continuing_tangent import continuing_tangents
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.mohr_coulomb import MohrCoulomb

BULK, SHEAR, YIELD = 136.35e9, 45.45e9, 100e6
GURSON = {
    "yield_condition": Gurson(1.5, 1.0, 2.25, 4.0, 0.05),
    "damage": VoidNucleation(0.02, 0.04, 0.1, 0.05),
}
LAWS = {
    "gurson": GURSON,
    "drucker-prager": {"yield_condition": DruckerPrager(0.2, 0.1)},
    "mohr-coulomb": {"yield_condition": MohrCoulomb(30.0, 10.0)},
    "back-stress": {"kinematic_hardening": ArmstrongFrederick(5e9, 20.0)},
}

pytestmark = pytest.mark.usefixtures("interpreted")


# All principal stresses differ: at an edge of the pyramid the hardening would depend on the direction of the step.
CHANGE = np.array([[0.01, 0.004, 0.0], [0.0, 0.001, 0.002], [0.0, 0.0, -0.012]])


@pytest.mark.parametrize("update", ["hypo", "hyper"])
@pytest.mark.parametrize("name", LAWS)
def test_the_tangent_of_continued_flow_is_that_of_a_vanishing_step(copper, update, name):
    """At constant rate and temperature the next little step in the same direction has the same tangent."""
    flow = LinearHardening(400e6, 1e9)
    points = MaterialPoints(copper(update, flow, stability=DruckerStability(), **LAWS[name]), np.ones(1))
    points.deformation_gradient[0] += CHANGE
    points.advance(1e-3)
    points.accept()
    stresses, continued, stepped = np.empty((1, 9)), np.empty((1, 9, 9)), np.empty((1, 9, 9))
    kernel = getattr(continuing_tangents, "py_func", continuing_tangents)
    f = points.old_deformation_gradient
    kernel(0, 1, points._workspaces[0], points.model, f.reshape(1, 9), points.old, stresses, continued)
    points.deformation_gradient[0] = f[0] + 1e-7 * CHANGE
    points.linearise(1e-3, np.empty((1, 3, 3)), stepped)
    assert continued[0] == pytest.approx(stepped[0], abs=1e-5 * SHEAR)
    assert stresses.reshape(3, 3) == pytest.approx(first_piola(points), abs=1e-5 * YIELD)


def first_piola(points):
    """First Piola stress of the accepted state."""
    f = points.old_deformation_gradient[0]
    stress = points.old.stress[0][[[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
    return np.linalg.det(f) * stress @ np.linalg.inv(f).T


def test_growing_voids_make_a_hardening_body_unstable(copper):
    """Pulled without contraction the matrix hardens and the body softens: Drucker's measure is lost."""
    laws = {
        "yield_condition": Gurson(1.5, 1.0, 2.25, 4.0, 0.05),
        "damage": VoidNucleation(0.01, 0.0, 0.3, 0.1),
    }
    material = copper("hypo", LinearHardening(400e6, 400e6), stability=DruckerStability(), **laws)
    path = np.tile(np.eye(3), (11, 1, 1))
    path[:, 0, 0] += np.linspace(0.0, 0.015, 11)
    history = drive(material, path, 1e-3)
    top = history.stress[:, 0].argmax()
    lost = np.flatnonzero(history.fields["stability"] <= 0.0)[0]
    assert history.fields["stability"][0] == pytest.approx(1.0, abs=1e-12) and 1 < lost <= top < 10
    assert np.all(history.fields["stability"][lost:] < 0.0)
