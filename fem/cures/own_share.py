"""How much of its own volume ratio a point keeps under a cure, whose dilatations are fewer than its points.

Changes of volume that the projection does not see are held by nothing where a body flows under tension: the stress
sigma, beyond the slope of the flow stress, softens them, and the surface of a neck wrinkles. A share holds them with
share^2 K. In patches of quadratic elements in a ring, held all round but at its side and pulled to strains of 0.1 to
0.8, 0.056 is enough for no negative eigenvalue, whatever the cure and the shape, up to 50 : 1, of steel with
sigma = K / 200. It grows with the root of sigma / K: a tenth is enough up to sigma = K / 60. In plane strain such
patches need none. What a share holds it also locks a little: docs/methods.md. Tests: `tests/fem/test_own_share.py`.
"""

from core_models.arguments import check_share
from core_models.errors import SceneError
from core_models.geometry import Geometry, PlaneStrain
from fem.cures.choice import LINEAR, MEAN, NODAL
from meshes.kinds import KINDS

OF_QUADRATIC = 0.1


def default_share(kind: str, cure: str, geometry: Geometry) -> float:
    """OF_QUADRATIC where a cure of quadratic elements needs it: in bodies of revolution and in space; else 0."""
    needed = KINDS[kind].degree == 2 and cure in (MEAN, LINEAR) and not isinstance(geometry, PlaneStrain)
    return OF_QUADRATIC if needed else 0.0


def check_own_share(share: float, cure: str) -> float:
    """The share; SceneError for one that is not from 0 to 1, or more than 0 where no cure projects within elements."""
    check_share("own_share", share)
    if share > 0.0 and cure not in (MEAN, LINEAR):
        why = "averages over nodes" if cure == NODAL else "projects nothing"
        raise SceneError(f"own_share is void: the cure {cure!r} {why}; leave own_share out")
    return float(share)
