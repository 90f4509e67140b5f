"""The rigid wall in the plane where the last coordinate is 0: it stops the body's surface, not its nodes.

The wall acts on columns of nodes. The grid's velocity in its plane is the mean of the nodes next to it on both sides;
where the body's surface would pass, an impulse shared by both changes that mean to what just closes the gap. With the
node below the wall the mirror image of the one above, this is the mirror condition, switched on by contact.
Interpolations that reach further do the same with each further pair of nodes.
"""

import math

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from mpm.geometries import dimension_of
from mpm.grid import EDGE, MASS, RECORD, VELOCITY, node_at
from mpm.interpolation import layers

FAR = 1e300  # m
TOUCHING = 1e-6  # cells: height at which a surface counts as on the wall
HELD_TOUCHING = 0.02  # cells: the same next to a surface that the wall holds
NEAR = 3.0  # cells: particles higher than this have no face that matters


@kernel
def meet_wall(geometry, shape, grid, dt, friction, gaps, held):
    """Stop the columns of nodes whose material would pass the wall.

    The normal impulse can push only, unless the column is held. The tangential one brings the mean velocity of the
    pair to rest, or as near to that as `friction` (Coulomb's coefficient) times the push allows.

    gaps : (columns,) height of the surface above the wall [m], FAR where no surface is near. held : (columns,) bool,
    columns whose surface has touched a wall that does not let go.
    Returns the normal impulse [N s], the work of normal and tangential impulses, and the change of kinetic energy [J].
    """
    wide, last = EDGE * grid.shape[0], dimension_of(geometry) - 1
    impulse, work, rubbed, energy = 0.0, 0.0, 0.0, 0.0
    for column in range(gaps.shape[0]):
        if gaps[column] == FAR:
            continue
        i, j = column % wide + EDGE * grid.low[0], column // wide + EDGE * grid.low[1]
        target = 0.0 if held[column] else -max(gaps[column], 0.0) / dt
        for layer in range(layers(shape)):
            low, high = wall_node(geometry, grid, i, j, -1 - layer), wall_node(geometry, grid, i, j, layer)
            if low < 0 or high < 0:
                continue
            m_low, m_high = grid.nodes[RECORD * low + MASS], grid.nodes[RECORD * high + MASS]
            if not (m_low > 0.0 and m_high > 0.0):
                continue
            velocity = mean_velocity(grid, low, high, last)
            if velocity >= target and not held[column]:
                continue
            push = (target - velocity) / (0.25 / m_low + 0.25 / m_high)
            energy -= kinetic(grid, low) + kinetic(grid, high)
            work += push_pair(grid, low, high, last, push)
            impulse += push
            if friction > 0.0 and push > 0.0:
                rubbed += rub(grid, low, high, last, friction * push)
            energy += kinetic(grid, low) + kinetic(grid, high)
    return impulse, work, rubbed, energy


@generic
def wall_node(geometry, grid, i, j, row):
    """Number of the node of column (i, j) in a row of nodes along the last axis, or -1."""


@wall_node.register(Axisymmetric)
@wall_node.register(PlaneStrain)
def _(geometry, grid, i, j, row):
    return node_at(geometry, grid, i, row, 0)


@wall_node.register(Spatial)
def _(geometry, grid, i, j, row):
    return node_at(geometry, grid, i, j, row)


@inside_kernel
def mean_velocity(grid, low, high, axis):
    """Mean of two nodes' velocities along an axis after the forces [m/s]."""
    return 0.5 * (grid.after[VELOCITY * low + axis] + grid.after[VELOCITY * high + axis])


@inside_kernel
def kinetic(grid, node):
    """Kinetic energy of a node after the forces [J]."""
    at = VELOCITY * node
    u, v, w = grid.after[at], grid.after[at + 1], grid.after[at + 2]
    return 0.5 * grid.nodes[RECORD * node + MASS] * (u * u + v * v + w * w)


@inside_kernel
def push_pair(grid, low, high, axis, push):
    """Share an impulse between two nodes; returns its work [J]."""
    mean = 0.0
    for node in (low, high):
        before, mass = grid.nodes[RECORD * node + axis], grid.nodes[RECORD * node + MASS]
        v = grid.after[VELOCITY * node + axis] + 0.5 * push / mass
        grid.after[VELOCITY * node + axis] = v
        mean += before + v
    return 0.25 * push * mean


@inside_kernel
def rub(grid, low, high, last, most):
    """Tangential impulse on a pair of nodes, at most `most` [N s]; returns its work [J]."""
    m_low, m_high = grid.nodes[RECORD * low + MASS], grid.nodes[RECORD * high + MASS]
    inverse = 1.0 / (0.25 / m_low + 0.25 / m_high)
    u = mean_velocity(grid, low, high, 0)
    v = mean_velocity(grid, low, high, 1) if last == 2 else 0.0
    needed = inverse * math.sqrt(u * u + v * v)
    share = -inverse * (1.0 if needed <= most else most / needed)
    work = push_pair(grid, low, high, 0, share * u)
    if last == 2:
        work += push_pair(grid, low, high, 1, share * v)
    return work


@kernel
def measure_gaps(
    geometry, grid, positions, deformation_gradient, surface, corners, bilateral, touched, gaps, held
):
    """Height of the body's surface above the wall at each column of nodes [m]; FAR where it is far.

    surface : (faces,) particle of each boundary face. corners : (faces, 2 or 4, d) its corners relative to the
    particle in the reference body [m]. gaps : (columns,), written: the lowest face at the column, or with an end
    within a cell of it.
    bilateral : a face that touches the wall is noted in `touched` (faces,) and holds its columns, `held` (columns,),
    wherever it goes from then on.
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
