"""What the transfers do differently in each geometry. Two dimensions are three with one layer of nodes."""

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.tensors import determinant, load_tensor, store_tensor
from mpm.interpolation import locate_particle, reach
from mpm.lanes import fused, lane, lanes


@generic
def dimension_of(geometry):
    """Components of a position: a constant when compiled."""


@generic
def depth_of(geometry, shape):
    """Nodes that a particle reaches along the third axis: a constant when compiled."""


@generic
def stand(geometry, shape, grid, positions, p):
    """First nodes (three numbers) that particle p reaches, and its local coordinates as lanes."""


@generic
def vector(geometry, array, p, last):
    """Row p of an array (n, d) as lanes, with `last` in lane 3."""


@generic
def put_vector(geometry, array, p, v):
    """Write lanes as row p of an array (n, d)."""


@generic
def column(geometry, array, p, axis):
    """Column of matrix p of an array (n, d, d) as lanes."""


@generic
def put_columns(geometry, array, p, x, y, z):
    """Write matrix p of an array (n, d, d) from its columns."""


@generic
def hoop_force(geometry, positions, p, tension):
    """Force on a particle as lanes [N] for minus volume times hoop stress."""


@generic
def deform(geometry, old, new, p, dt, x, y, z, v, positions):
    """Write F = (1 + dt L) F_old of particle p for L with columns x, y, z and velocity v; returns its determinant."""


@dimension_of.register(Axisymmetric)
@dimension_of.register(PlaneStrain)
def _(geometry):
    return 2


@dimension_of.register(Spatial)
def _(geometry):
    return 3


@depth_of.register(Axisymmetric)
@depth_of.register(PlaneStrain)
def _(geometry, shape):
    return 1


@depth_of.register(Spatial)
def _(geometry, shape):
    return reach(shape)


@inside_kernel
def along(shape, geometry, grid, positions, p, axis):
    """First node that particle p reaches along an axis, and its local coordinate."""
    x = (positions[p, axis] - grid.base[axis]) * grid.over_h
    return locate_particle(shape, geometry, p, axis, x, grid.over_h)


@stand.register(Axisymmetric)
@stand.register(PlaneStrain)
def _(geometry, shape, grid, positions, p):
    i, x = along(shape, geometry, grid, positions, p, 0)
    j, y = along(shape, geometry, grid, positions, p, 1)
    return i, j, 0.0, lanes(x, y, 0.0, 0.0)


@stand.register(Spatial)
def _(geometry, shape, grid, positions, p):
    i, x = along(shape, geometry, grid, positions, p, 0)
    j, y = along(shape, geometry, grid, positions, p, 1)
    k, z = along(shape, geometry, grid, positions, p, 2)
    return i, j, k, lanes(x, y, z, 0.0)


@vector.register(Axisymmetric)
@vector.register(PlaneStrain)
def _(geometry, array, p, last):
    return lanes(array[p, 0], array[p, 1], 0.0, last)


@vector.register(Spatial)
def _(geometry, array, p, last):
    return lanes(array[p, 0], array[p, 1], array[p, 2], last)


@put_vector.register(Axisymmetric)
@put_vector.register(PlaneStrain)
def _(geometry, array, p, v):
    array[p, 0], array[p, 1] = lane(v, 0), lane(v, 1)


@put_vector.register(Spatial)
def _(geometry, array, p, v):
    array[p, 0], array[p, 1], array[p, 2] = lane(v, 0), lane(v, 1), lane(v, 2)


@column.register(Axisymmetric)
@column.register(PlaneStrain)
def _(geometry, array, p, axis):
    if axis == 2:
        return lanes(0.0, 0.0, 0.0, 0.0)
    return lanes(array[p, 0, axis], array[p, 1, axis], 0.0, 0.0)


@column.register(Spatial)
def _(geometry, array, p, axis):
    return lanes(array[p, 0, axis], array[p, 1, axis], array[p, 2, axis], 0.0)


@put_columns.register(Axisymmetric)
@put_columns.register(PlaneStrain)
def _(geometry, array, p, x, y, z):
    array[p, 0, 0], array[p, 0, 1] = lane(x, 0), lane(y, 0)
    array[p, 1, 0], array[p, 1, 1] = lane(x, 1), lane(y, 1)


@put_columns.register(Spatial)
def _(geometry, array, p, x, y, z):
    array[p, 0, 0], array[p, 0, 1], array[p, 0, 2] = lane(x, 0), lane(y, 0), lane(z, 0)
    array[p, 1, 0], array[p, 1, 1], array[p, 1, 2] = lane(x, 1), lane(y, 1), lane(z, 1)
    array[p, 2, 0], array[p, 2, 1], array[p, 2, 2] = lane(x, 2), lane(y, 2), lane(z, 2)


@hoop_force.register(Axisymmetric)
def _(geometry, positions, p, tension):
    return lanes(tension / positions[p, 0], 0.0, 0.0, 0.0)


@hoop_force.register(PlaneStrain)
@hoop_force.register(Spatial)
def _(geometry, positions, p, tension):
    return lanes(0.0, 0.0, 0.0, 0.0)


@inside_kernel
def deform_in_plane(old, new, p, dt, x, y, hoop):
    """The part of `deform` in the plane of the first two axes; hoop : ratio of stretches along the third."""
    xx, xy, yx, yy = old[p, 0, 0], old[p, 0, 1], old[p, 1, 0], old[p, 1, 1]
    first, second = dt * fused(xx, x, yx * y), dt * fused(xy, x, yy * y)
    xx, xy, yx, yy = xx + lane(first, 0), xy + lane(second, 0), yx + lane(first, 1), yy + lane(second, 1)
    zz = old[p, 2, 2] * hoop
    new[p, 0, 0], new[p, 0, 1], new[p, 1, 0], new[p, 1, 1], new[p, 2, 2] = xx, xy, yx, yy, zz
    return zz * (xx * yy - xy * yx)


@deform.register(Axisymmetric)
def _(geometry, old, new, p, dt, x, y, z, v, positions):
    return deform_in_plane(old, new, p, dt, x, y, 1.0 + dt * lane(v, 0) / positions[p, 0])


@deform.register(PlaneStrain)
def _(geometry, old, new, p, dt, x, y, z, v, positions):
    return deform_in_plane(old, new, p, dt, x, y, 1.0)


@deform.register(Spatial)
def _(geometry, old, new, p, dt, x, y, z, v, positions):
    f = load_tensor(old, p)
    a = dt * fused(f[0], x, fused(f[3], y, f[6] * z))
    b = dt * fused(f[1], x, fused(f[4], y, f[7] * z))
    c = dt * fused(f[2], x, fused(f[5], y, f[8] * z))
    g = (
        f[0] + lane(a, 0), f[1] + lane(b, 0), f[2] + lane(c, 0),
        f[3] + lane(a, 1), f[4] + lane(b, 1), f[5] + lane(c, 1),
        f[6] + lane(a, 2), f[7] + lane(b, 2), f[8] + lane(c, 2),
    )  # fmt: skip
    store_tensor(new, p, g)
    return determinant(g)
