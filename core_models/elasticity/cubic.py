"""Linear elasticity of cubic crystals."""

from typing import NamedTuple

from core_models.elasticity.stiffness import Stiffness, averaged_moduli, axes_fault, material_axes
from core_models.laws import elastic_moduli, stiffness


class CubicElastic(NamedTuple):
    """Cubic linear elasticity: a crystal whose three axes are alike.

        s_11 = C_11 e_11 + C_12 (e_22 + e_33),  ...,   s_ij = 2 C_44 e_ij

    Parameters
    ----------
    C_11, C_12, C_44 : stiffnesses [Pa], C_11 > 0, -C_11 / 2 < C_12 < C_11, C_44 > 0. Isotropic if 2 C_44 = C_11 - C_12.
    axis_1, axis_2 : two edges of the cube in the reference body, of any length but 0 and not parallel; of axis_2 the
    part normal to axis_1 counts. In axisymmetry their components are r, z, hoop.

    With the updates StVenantKirchhoff and HypoelasticPlastic.
    In axisymmetry and plane strain one edge, or a diagonal of a face, must be normal to the plane.
    Source: Nye, Physical Properties of Crystals (1985), ch. 8.
    """

    C_11: float
    C_12: float
    C_44: float
    axis_1: tuple[float, float, float]
    axis_2: tuple[float, float, float]

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if not -0.5 * self.C_11 < self.C_12 < self.C_11:
            return (
                f"C_12 = {self.C_12!r} makes a stiffness that is not positive definite: give it between -C_11 / 2 and "
                f"C_11 = {self.C_11!r} Pa"
            )
        return axes_fault(self.axis_1, self.axis_2)


@stiffness.register(CubicElastic)
def _(law):
    normal = (law.C_11, law.C_11, law.C_11, law.C_12, law.C_12, law.C_12)
    return Stiffness(normal, (law.C_44, law.C_44, law.C_44), material_axes(law.axis_1, law.axis_2))


@elastic_moduli.register(CubicElastic)
def _(law):
    return averaged_moduli(stiffness(law))
