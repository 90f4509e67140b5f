"""Heights of the body's surface above the rigid wall, at the columns of nodes that `mpm.wall` acts on."""

import math

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from mpm.geometries import dimension_of
from mpm.grid import EDGE

FAR = 1e300  # m
TOUCHING = 1e-6  # cells: height at which a surface counts as on the wall
HELD_TOUCHING = 0.02  # cells: the same next to a surface that the wall holds
NEAR = 3.0  # cells: particles higher than this have no face that matters


@kernel
def measure_gaps(
    geometry, grid, positions, deformation_gradient, surface, corners, bilateral, touched, gaps, held
):
    """Height of the body's surface above the wall at each column of nodes [m]; FAR where it is far.

    surface : (faces,) particle of each boundary face. corners : (faces, 2 or 4, d) its corners relative to the
    particle in the reference body [m]. gaps : (columns,), written: the lowest face at the column, or with an end
    within a cell of it.
    bilateral : a face that touches the wall is noted in `touched` (faces,) and holds its columns, `held` (columns,),
    wherever it goes from then on. Particles that are below the wall close their columns too: at strains above 5 the
    faces' domains no longer cover the foot, and the bar would run out through the holes.
    """
    last = dimension_of(geometry) - 1
    for column in range(gaps.shape[0]):
        gaps[column] = FAR
        held[column] = False
    for face in range(surface.shape[0]):
        p = surface[face]
        if positions[p, last] <= NEAR * grid.h:
            measure_face(
                geometry,
                grid,
                positions,
                deformation_gradient,
                p,
                corners,
                face,
                bilateral,
                touched,
                gaps,
                held,
            )
    for p in range(positions.shape[0]):
        if positions[p, last] < 0.0:
            close_columns(geometry, grid, positions, p, gaps)


@inside_kernel
def close_columns(geometry, grid, positions, p, gaps):
    """Enter the height of particle p at the columns next to it."""
    first, last = columns_near(grid, 0, positions[p, 0], positions[p, 0])
    low, high = 0, 0
    if dimension_of(geometry) == 3:
        low, high = columns_near(grid, 1, positions[p, 1], positions[p, 1])
    for row in range(low, high + 1):
        for column in range(first, last + 1):
            at = column + EDGE * grid.shape[0] * row
            gaps[at] = min(gaps[at], positions[p, dimension_of(geometry) - 1])


@generic
def measure_face(
    geometry, grid, positions, deformation_gradient, p, corners, face, bilateral, touched, gaps, held
):
    """Enter one face of particle p; see `measure_gaps`."""


@inside_kernel
def enter(grid, column, height, face, bilateral, touched, gaps, held):
    """Enter the height of a face at a column."""
    gaps[column] = min(gaps[column], height)
    touching = HELD_TOUCHING if held[column] else TOUCHING
    touched[face] = touched[face] or (bilateral and height <= touching * grid.h)
    held[column] = held[column] or touched[face]


@inside_kernel
def columns_near(grid, axis, low, high):
    """First and last column along an axis within a cell of an interval [m], counted from that of the box."""
    first = math.floor((low - grid.base[axis]) * grid.over_h - 0.5) - EDGE * grid.low[axis]
    last = math.floor((high - grid.base[axis]) * grid.over_h - 0.5) + 1 - EDGE * grid.low[axis]
    return max(first, 0), min(last, EDGE * grid.shape[axis] - 1)


@inside_kernel
def column_position(grid, axis, column):
    """Coordinate of a column along an axis [m]."""
    return grid.base[axis] + (column + EDGE * grid.low[axis] + 0.5) * grid.h


@measure_face.register(Axisymmetric)
@measure_face.register(PlaneStrain)
def _(geometry, grid, positions, deformation_gradient, p, corners, face, bilateral, touched, gaps, held):
    x_low, z_low = face_end(
        geometry, p, positions, deformation_gradient, corners[face, 0, 0], corners[face, 0, 1]
    )
    x_high, z_high = face_end(
        geometry, p, positions, deformation_gradient, corners[face, 1, 0], corners[face, 1, 1]
    )
    if x_low > x_high:
        x_low, z_low, x_high, z_high = x_high, z_high, x_low, z_low
    slope = (z_high - z_low) / (x_high - x_low) if x_high > x_low else 0.0
    first, last = columns_near(grid, 0, x_low, x_high)
    for column in range(first, last + 1):
        x = min(max(column_position(grid, 0, column), x_low), x_high)
        height = z_low + slope * (x - x_low) if x_high > x_low else min(z_low, z_high)
        enter(grid, column, height, face, bilateral, touched, gaps, held)


@inside_kernel
def face_end(geometry, p, positions, f, x, z):
    """Where the end of a face of particle p is now, which was at (x, z) from it."""
    now = positions[p, 0] + f[p, 0, 0] * x + f[p, 0, 1] * z
    return off_axis(geometry, now), positions[p, 1] + f[p, 1, 0] * x + f[p, 1, 1] * z


@generic
def off_axis(geometry, x):
    """A first coordinate, on the body's side of the axis if there is one."""


@off_axis.register(Axisymmetric)
def _(geometry, x):
    return max(x, 0.0)


@off_axis.register(PlaneStrain)
def _(geometry, x):
    return x


@measure_face.register(Spatial)
def _(geometry, grid, positions, deformation_gradient, p, corners, face, bilateral, touched, gaps, held):
    f = deformation_gradient
    low_x, high_x, low_y, high_y, lowest, middle = FAR, -FAR, FAR, -FAR, FAR, 0.0
    middle_x, middle_y = 0.0, 0.0
    a_x, a_y, a_z, b_x, b_y, b_z = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for corner in range(4):
        u, v, w = corners[face, corner, 0], corners[face, corner, 1], corners[face, corner, 2]
        x = positions[p, 0] + f[p, 0, 0] * u + f[p, 0, 1] * v + f[p, 0, 2] * w
        y = positions[p, 1] + f[p, 1, 0] * u + f[p, 1, 1] * v + f[p, 1, 2] * w
        z = positions[p, 2] + f[p, 2, 0] * u + f[p, 2, 1] * v + f[p, 2, 2] * w
        low_x, high_x, low_y, high_y = min(low_x, x), max(high_x, x), min(low_y, y), max(high_y, y)
        lowest = min(lowest, z)
        middle_x, middle_y, middle = middle_x + 0.25 * x, middle_y + 0.25 * y, middle + 0.25 * z
        along, across = (1.0 if corner in (1, 2) else -1.0), (1.0 if corner >= 2 else -1.0)
        a_x, a_y, a_z = a_x + along * x, a_y + along * y, a_z + along * z
        b_x, b_y, b_z = b_x + across * x, b_y + across * y, b_z + across * z
    normal = a_x * b_y - a_y * b_x
    slope_x, slope_y = 0.0, 0.0
    if abs(normal) > 1e-9 * (abs(a_x) + abs(a_y) + abs(a_z)) * (abs(b_x) + abs(b_y) + abs(b_z)):
        slope_x, slope_y = (a_z * b_y - a_y * b_z) / normal, (a_x * b_z - a_z * b_x) / normal
    else:
        middle = lowest
    first_x, last_x = columns_near(grid, 0, low_x, high_x)
    first_y, last_y = columns_near(grid, 1, low_y, high_y)
    for row in range(first_y, last_y + 1):
        y = min(max(column_position(grid, 1, row), low_y), high_y)
        for column in range(first_x, last_x + 1):
            x = min(max(column_position(grid, 0, column), low_x), high_x)
            height = max(middle + slope_x * (x - middle_x) + slope_y * (y - middle_y), lowest)
            enter(grid, column + EDGE * grid.shape[0] * row, height, face, bilateral, touched, gaps, held)
