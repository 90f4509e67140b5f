"""The rotation of a step: of R in F = R U, by which tensors of the state before are turned to the frame after it."""

from core_models.compilation import beside_kernel
from core_models.dispatch import generic
from core_models.quaternions import quaternion, rotation_matrix
from core_models.rotation import polar_rotation
from core_models.tensors import product_transposed
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic


@generic
def step_rotation(update, f0, f1, rotation_0, rotation_1):
    """Q = R_1 R_0^T (nine components) from deformation gradients, or from the rotation vectors that points have."""


@step_rotation.otherwise
def _(update, f0, f1, rotation_0, rotation_1):
    return product_transposed(rotation_after(update, f1, rotation_1), rotation_after(update, f0, rotation_0))


@generic
def rotation_after(update, f, rotation):
    """R (nine components) of a deformation gradient, or from the rotation vector."""


@rotation_after.register(HypoelasticPlastic)
def _(update, f, rotation):
    return rotation_matrix(quaternion(rotation))


@rotation_after.register(HyperelasticPlastic)
def _(update, f, rotation):
    return polar(f)


@beside_kernel
def polar(f):
    """Rotation of F = R U."""
    return polar_rotation(f)
