"""What the kernels do differently in each geometry, at one point and one node.

A deformation gradient is a tuple: (rr, rz, zr, zz, hoop) in two dimensions, with hoop = 1 in plane strain, and nine
numbers, row by row, in three. Its cofactor has the same form.
"""

from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.tensors import determinant, load_tensor, store_tensor
from fem.elements import nodes_of


@generic
def dimension_of(geometry):
    """Components of a position."""


@dimension_of.register(PlaneStrain)
@dimension_of.register(Axisymmetric)
def _(geometry):
    return 2


@dimension_of.register(Spatial)
def _(geometry):
    return 3


@generic
def point_gradient(geometry, element, tables, x, e, q):
    """Deformation gradient of point q of element e at nodal positions x (n, d) [m]."""


@point_gradient.register(Axisymmetric)
def _(geometry, element, tables, x, e, q):
    rr, rz, zr, zz, hoop = 0.0, 0.0, 0.0, 0.0, 0.0
    for a in range(nodes_of(element)):
        node = tables.nodes[e, a]
        gr, gz = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1]
        xr, xz = x[node, 0], x[node, 1]
        rr += xr * gr
        rz += xr * gz
        zr += xz * gr
        zz += xz * gz
        hoop += xr * tables.gradients[e, q, a, 2]
    return rr, rz, zr, zz, hoop


@point_gradient.register(PlaneStrain)
def _(geometry, element, tables, x, e, q):
    rr, rz, zr, zz = 0.0, 0.0, 0.0, 0.0
    for a in range(nodes_of(element)):
        node = tables.nodes[e, a]
        gr, gz = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1]
        xr, xz = x[node, 0], x[node, 1]
        rr += xr * gr
        rz += xr * gz
        zr += xz * gr
        zz += xz * gz
    return rr, rz, zr, zz, 1.0


@point_gradient.register(Spatial)
def _(geometry, element, tables, x, e, q):
    xx, xy, xz, yx, yy, yz, zx, zy, zz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for a in range(nodes_of(element)):
        node = tables.nodes[e, a]
        g0, g1, g2 = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2]
        x0, x1, x2 = x[node, 0], x[node, 1], x[node, 2]
        xx += x0 * g0
        xy += x0 * g1
        xz += x0 * g2
        yx += x1 * g0
        yy += x1 * g1
        yz += x1 * g2
        zx += x2 * g0
        zy += x2 * g1
        zz += x2 * g2
    return xx, xy, xz, yx, yy, yz, zx, zy, zz


@generic
def ratios_of(geometry, f):
    """J, ratio of areas in the plane of the mesh (of volumes in three dimensions), and whether such a body can be."""


@ratios_of.register(PlaneStrain)
@ratios_of.register(Axisymmetric)
def _(geometry, f):
    area = f[0] * f[3] - f[1] * f[2]
    return area * f[4], area, area > 0.0 and f[4] > 0.0


@ratios_of.register(Spatial)
def _(geometry, f):
    ratio = determinant(f)
    return ratio, ratio, ratio > 0.0


@generic
def put_gradient(geometry, gradients, i, f):
    """Write a deformation gradient as row i of (n, 3, 3), which holds zeros where it has no component."""


@put_gradient.register(PlaneStrain)
@put_gradient.register(Axisymmetric)
def _(geometry, gradients, i, f):
    gradients[i, 0, 0], gradients[i, 0, 1] = f[0], f[1]
    gradients[i, 1, 0], gradients[i, 1, 1] = f[2], f[3]
    gradients[i, 2, 2] = f[4]


@put_gradient.register(Spatial)
def _(geometry, gradients, i, f):
    store_tensor(gradients, i, f)


@generic
def scale_gradient(geometry, gradients, i, scale):
    """Multiply row i of (n, 3, 3) by a number."""


@scale_gradient.register(PlaneStrain)
@scale_gradient.register(Axisymmetric)
def _(geometry, gradients, i, scale):
    gradients[i, 0, 0] *= scale
    gradients[i, 0, 1] *= scale
    gradients[i, 1, 0] *= scale
    gradients[i, 1, 1] *= scale
    gradients[i, 2, 2] *= scale


@scale_gradient.register(Spatial)
def _(geometry, gradients, i, scale):
    for j in range(3):
        for k in range(3):
            gradients[i, j, k] *= scale


@generic
def cofactor_of(geometry, gradients, i):
    """Cofactor and determinant of row i of (n, 3, 3): F^-T = cofactor / determinant."""


@cofactor_of.register(PlaneStrain)
@cofactor_of.register(Axisymmetric)
def _(geometry, gradients, i):
    rr, rz, zr, zz = gradients[i, 0, 0], gradients[i, 0, 1], gradients[i, 1, 0], gradients[i, 1, 1]
    hoop = gradients[i, 2, 2]
    area = rr * zz - rz * zr
    return (zz * hoop, -zr * hoop, -rz * hoop, rr * hoop, area), area * hoop


@cofactor_of.register(Spatial)
def _(geometry, gradients, i):
    a = load_tensor(gradients, i)
    cofactor = (
        a[4] * a[8] - a[5] * a[7], a[5] * a[6] - a[3] * a[8], a[3] * a[7] - a[4] * a[6],
        a[2] * a[7] - a[1] * a[8], a[0] * a[8] - a[2] * a[6], a[1] * a[6] - a[0] * a[7],
        a[1] * a[5] - a[2] * a[4], a[2] * a[3] - a[0] * a[5], a[0] * a[4] - a[1] * a[3],
    )  # fmt: skip
    return cofactor, a[0] * cofactor[0] + a[1] * cofactor[1] + a[2] * cofactor[2]
