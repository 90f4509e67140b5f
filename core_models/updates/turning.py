"""The rotation of a step: of R in F = R U, by which tensors of the state before are turned to the frame after it."""

from core_models.compilation import beside_kernel
from core_models.dispatch import generic
from core_models.quaternions import quaternion, rotation_matrix
from core_models.rotation import polar_rotation, rotation_increment
from core_models.tensors import product_transposed
from core_models.updates.corotation import corotated
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic, unrotated


@generic
def step_rotation(update, objective_rate, f0, f1, rotation_0, rotation_1):
    """Q = R_1 R_0^T (nine components), of the frame of the objective rate where there is one."""


@step_rotation.register(HyperelasticPlastic)
def _(update, objective_rate, f0, f1, rotation_0, rotation_1):
    return product_transposed(polar(f1), polar(f0))


@step_rotation.register(HypoelasticPlastic)
def _(update, objective_rate, f0, f1, rotation_0, rotation_1):
    return rate_rotation(objective_rate, f0, f1, rotation_0, rotation_1)


@generic
def rate_rotation(objective_rate, f0, f1, rotation_0, rotation_1):
    """The rotation of the rate's frame in the step."""


@rate_rotation.register(type(None))
def _(objective_rate, f0, f1, rotation_0, rotation_1):
    return product_transposed(
        rotation_matrix(quaternion(rotation_1)), rotation_matrix(quaternion(rotation_0))
    )


@rate_rotation.otherwise
def _(objective_rate, f0, f1, rotation_0, rotation_1):
    _r0, before, a = unrotated(f0, f1, rotation_0)
    increment, after = rotation_increment(a)
    return rotation_matrix(corotated(objective_rate, before, after, increment)[1])


@beside_kernel
def polar(f):
    """Rotation of F = R U."""
    return polar_rotation(f)
