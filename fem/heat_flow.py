"""Heat in the elements, at the nodes and back at the points: the kernels of `fem.conduction`."""

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from core_models.geometry import PlaneStrain, Spatial
from core_models.state import read
from fem.deformation import ELEMENT_CHUNK
from fem.elements import nodes_of, points_of
from fem.geometries import cofactor_of
from fem.motion import NODE_CHUNK
from fem.stable_step import spread

FLOW, CAPACITY, GAIN, SHARE = 0, 1, 2, 3
COLUMNS = 4
DECAY = 0.25  # of an element's highest rate: k / (rho c h^2) for squares and cubes


@kernel
def conduct(
    first, last, geometry, element, tables, metric, gradients, scales, conductivity, density, capacities, before,
    after, nodal, dt, corners, residues, rates,
):  # fmt: skip
    """What the elements of chunks first ... last-1 give to the nodes.

    Parameters
    ----------
    first, last : chunks of ELEMENT_CHUNK elements. geometry : PlaneStrain in every 2-D body, for nothing conducts
    round the axis. element, tables : of the temperature's space. metric : of the highest rate (fem.metric).
    gradients (n, 3, 3), scales (n,) or None : of the points. conductivity [W/(m K)]. density [kg/m^3].
    capacities (n,) [J/K]. before, after (n,) : temperatures of the points before and after the rest of the step [K].
    nodal : (nodes,) temperatures [K]. dt : [s].
    Written: corners (m, a, 4), heat flow into the corner [W], its capacity [J/K], heat gained by the points in the
    step [J], and its share of the heat that leaves the points' residues [J]; residues (n,), what leaves them [K];
    rates (chunks,), the highest rate of the elements [1/s].
    """
    elements = tables.nodes.shape[0]
    for chunk in range(first, last):
        rates[chunk] = 0.0
        for e in range(chunk * ELEMENT_CHUNK, min((chunk + 1) * ELEMENT_CHUNK, elements)):
            for a in range(nodes_of(element)):
                for column in range(COLUMNS):
                    corners[e, a, column] = 0.0
            fastest = 0.0
            for q in range(points_of(element)):
                i = points_of(element) * e + q
                cofactor, ratio = cofactor_of(geometry, gradients, i)
                # The points of a cured element see the gradient times this; heat flows through the true one.
                ratio *= read(scales, i, 1.0)
                heaviness = density * tables.weights[e, q] / capacities[i]
                rate = conductivity * heaviness / ratio * spread(geometry, metric, e, q, cofactor)[1]
                fastest = max(fastest, rate)
                add_flow(
                    geometry, element, tables, e, q, conductivity * tables.weights[e, q] / ratio, cofactor, nodal,
                    corners,
                )  # fmt: skip
            rates[chunk] = max(rates[chunk], fastest)
            decay = min(DECAY * dt * fastest, 1.0)
            for q in range(points_of(element)):
                i = points_of(element) * e + q
                rest = before[i]
                for a in range(nodes_of(element)):
                    rest -= tables.shape[q, a] * nodal[tables.nodes[e, a]]
                residues[i] = decay * rest
                for a in range(nodes_of(element)):
                    part = tables.shape[q, a] * capacities[i]
                    corners[e, a, CAPACITY] += part
                    corners[e, a, GAIN] += part * (after[i] - before[i])
                    corners[e, a, SHARE] += part * residues[i]


@generic
def add_flow(geometry, element, tables, e, q, factor, cofactor, nodal, corners):
    """Add to the corners of element e what point q conducts: - factor (cofactor grad T) . (cofactor grad N_a) [W]."""


@add_flow.register(PlaneStrain)
def _(geometry, element, tables, e, q, factor, cofactor, nodal, corners):
    x, y = 0.0, 0.0
    for a in range(nodes_of(element)):
        temperature = nodal[tables.nodes[e, a]]
        x += temperature * tables.gradients[e, q, a, 0]
        y += temperature * tables.gradients[e, q, a, 1]
    u = factor * (cofactor[0] * x + cofactor[1] * y)
    v = factor * (cofactor[2] * x + cofactor[3] * y)
    x, y = cofactor[0] * u + cofactor[2] * v, cofactor[1] * u + cofactor[3] * v
    for a in range(nodes_of(element)):
        corners[e, a, FLOW] -= x * tables.gradients[e, q, a, 0] + y * tables.gradients[e, q, a, 1]


@add_flow.register(Spatial)
def _(geometry, element, tables, e, q, factor, cofactor, nodal, corners):
    c = cofactor
    x, y, z = 0.0, 0.0, 0.0
    for a in range(nodes_of(element)):
        temperature = nodal[tables.nodes[e, a]]
        x += temperature * tables.gradients[e, q, a, 0]
        y += temperature * tables.gradients[e, q, a, 1]
        z += temperature * tables.gradients[e, q, a, 2]
    u = factor * (c[0] * x + c[1] * y + c[2] * z)
    v = factor * (c[3] * x + c[4] * y + c[5] * z)
    w = factor * (c[6] * x + c[7] * y + c[8] * z)
    x, y, z = c[0] * u + c[3] * v + c[6] * w, c[1] * u + c[4] * v + c[7] * w, c[2] * u + c[5] * v + c[8] * w
    for a in range(nodes_of(element)):
        g = (tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2])
        corners[e, a, FLOW] -= x * g[0] + y * g[1] + z * g[2]


@kernel
def warm_nodes(first, last, start, entries, corners, sources, held, given, dt, nodal, rises, supplied):
    """New temperatures of the nodes of chunks first ... last-1, and what the points round them take.

    start, entries : corners of elements round each node. corners : (m a, 4), see `conduct`. sources : (n,) heat flow
    through the boundary [W]. held : (n,) whether the temperature is given, given : (n,) that temperature [K]. dt : [s].
    nodal : (n,) temperatures [K], changed. rises : (n,) of the points' temperatures [K], written. supplied : (chunks,)
    heat from outside [J], written.
    """
    nodes = nodal.shape[0]
    for chunk in range(first, last):
        heat = 0.0
        for node in range(chunk * NODE_CHUNK, min((chunk + 1) * NODE_CHUNK, nodes)):
            flow = sum_round(start, entries, corners, node, FLOW)
            capacity = sum_round(start, entries, corners, node, CAPACITY)
            over = 1.0 / capacity if capacity > 0.0 else 0.0
            rise = dt * (flow + sources[node]) * over
            after = nodal[node] + sum_round(start, entries, corners, node, GAIN) * over + rise
            heat += dt * sources[node]
            if held[node]:
                heat += capacity * (given[node] - after)
                rise += given[node] - after
                after = given[node]
            nodal[node] = after
            rises[node] = rise + sum_round(start, entries, corners, node, SHARE) * over
        supplied[chunk] = heat


@inside_kernel
def sum_round(start, entries, corners, node, column):
    """Sum over the corners of elements at a node."""
    total = 0.0
    for entry in range(start[node], start[node + 1]):
        total += corners[entries[entry], column]
    return total


@kernel
def warm_points(first, last, element, tables, rises, residues, temperature):
    """Let the points of the elements of chunks first ... last-1 take the nodes' rises and lose their residues [K]."""
    elements = tables.nodes.shape[0]
    for e in range(first * ELEMENT_CHUNK, min(last * ELEMENT_CHUNK, elements)):
        for q in range(points_of(element)):
            i = points_of(element) * e + q
            rise = -residues[i]
            for a in range(nodes_of(element)):
                rise += tables.shape[q, a] * rises[tables.nodes[e, a]]
            temperature[i] += rise
