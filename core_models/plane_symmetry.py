"""Anisotropy in two dimensions: the plane of the mesh must be a plane of symmetry of the material."""

import math

from core_models.elasticity.stiffness import Stiffness, stressed
from core_models.errors import MaterialError
from core_models.geometry import Geometry, Spatial, axis_names
from core_models.laws import stiffness
from core_models.material import Material
from core_models.tensors import congruence, transposed
from core_models.updates.fibre_reinforced import FibreReinforced
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff

LARGEST_COUPLING = 1e-6  # stress out of the plane by the largest stress
ANISOTROPIC_UPDATES = (HypoelasticPlastic, StVenantKirchhoff)  # those that know the whole stiffness
STRAINS_IN_PLANE = tuple(tuple(float(i == j) for j in range(6)) for i in range(4))


def check_plane(material: Material, geometry: Geometry) -> None:
    """Refuse a material that would shear out of the plane of an axisymmetric or plane strain body.

    Raises MaterialError: no axis of the material is normal to the plane.
    """
    if isinstance(geometry, Spatial) or coupling_out_of_plane(material) <= LARGEST_COUPLING:
        return
    plane = "-".join(axis_names(geometry)[:2])
    raise MaterialError(
        f"{material.name}: strain in the plane {plane} would shear the body out of it: turn an axis of the material "
        "normal to the plane, and fibres into it or normal to it, or take a mesh in three dimensions"
    )


def coupling_out_of_plane(material: Material) -> float:
    """The largest shear stress out of the plane of the first two axes by the largest stress, of strains in it [-]."""
    update = material.update
    if isinstance(update, FibreReinforced):
        x, y, z = update.fibre
        return math.hypot(x, y) * abs(z) / math.hypot(x, y, z) ** 2
    return _coupling(stiffness(material.elasticity)) if type(update) in ANISOTROPIC_UPDATES else 0.0


def _coupling(elastic: Stiffness) -> float:
    back = transposed(elastic.axes)
    stresses = [
        congruence(elastic.axes, stressed(elastic, congruence(back, strain))) for strain in STRAINS_IN_PLANE
    ]
    largest = max(abs(component) for stress in stresses for component in stress)
    return max(abs(component) for stress in stresses for component in stress[4:]) / largest
