"""The card schema of anisotropic elasticity."""

from core_models.elasticity.cubic import CubicElastic
from core_models.elasticity.orthotropic import OrthotropicElastic
from core_models.elasticity.transversely_isotropic import TransverselyIsotropicElastic
from core_models.schema.entries import ANY, POSITIVE, ModelSchema, Parameter, SlotSchema

AXES = (
    Parameter("axis_1", "-", ANY, "first axis of the material in the reference body", size=3),
    Parameter("axis_2", "-", ANY, "second axis; its part normal to the first counts", size=3),
)

ANISOTROPY = SlotSchema(
    slot="elasticity",
    tags=("elasticity_model",),
    places=("constitutive_model",),
    absent="isotropic, by <bulk_modulus> and <shear_modulus>",
    models=(
        ModelSchema(
            types=("orthotropic",),
            law=OrthotropicElastic,
            help="three planes of symmetry; with st_venant_kirchhoff or hypoelastic_plastic",
            parameters=(
                Parameter("E_1", "Pa", POSITIVE, "Young's modulus along axis 1"),
                Parameter("E_2", "Pa", POSITIVE, "Young's modulus along axis 2"),
                Parameter("E_3", "Pa", POSITIVE, "Young's modulus along axis 3"),
                Parameter("nu_12", "-", ANY, "contraction along 2 under tension along 1"),
                Parameter("nu_23", "-", ANY, "contraction along 3 under tension along 2"),
                Parameter("nu_13", "-", ANY, "contraction along 3 under tension along 1"),
                Parameter("G_12", "Pa", POSITIVE, "shear modulus in the plane 1-2"),
                Parameter("G_23", "Pa", POSITIVE, "shear modulus in the plane 2-3"),
                Parameter("G_13", "Pa", POSITIVE, "shear modulus in the plane 1-3"),
                *AXES,
            ),
        ),
        ModelSchema(
            types=("transversely_isotropic",),
            law=TransverselyIsotropicElastic,
            help="the same in all directions normal to an axis; with st_venant_kirchhoff or hypoelastic_plastic",
            parameters=(
                Parameter("E_1", "Pa", POSITIVE, "Young's modulus along the axis"),
                Parameter("E_2", "Pa", POSITIVE, "Young's modulus across the axis"),
                Parameter("nu_12", "-", ANY, "contraction across under tension along the axis"),
                Parameter("nu_23", "-", ANY, "Poisson's ratio in the plane normal to the axis"),
                Parameter("G_12", "Pa", POSITIVE, "shear modulus along the axis"),
                Parameter("axis", "-", ANY, "direction of the axis in the reference body", size=3),
            ),
        ),
        ModelSchema(
            types=("cubic",),
            law=CubicElastic,
            help="a crystal whose three axes are alike; with st_venant_kirchhoff or hypoelastic_plastic",
            parameters=(
                Parameter("C_11", "Pa", POSITIVE, "stress along an axis over strain along it"),
                Parameter("C_12", "Pa", ANY, "stress across over strain along an axis"),
                Parameter("C_44", "Pa", POSITIVE, "shear modulus in the planes of the axes"),
                *AXES,
            ),
        ),
    ),
)
