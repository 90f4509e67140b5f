"""Kinematics: from nodal positions to the deformation gradients that the points see."""

import numpy as np

from core_models.compilation import kernel
from core_models.dispatch import generic
from core_models.state import write
from core_models.status import INVERTED, OK
from core_models.tensors import cube_root
from fem.cures.projection import PROJECTED, RATIO, project
from fem.elements import points_of
from fem.geometries import dimension_of, point_gradient, put_gradient, ratios_of, scale_gradient

ELEMENT_CHUNK = 64  # elements; fixed, so that results do not depend on the number of threads


@kernel
def deform(first, last, scratch, geometry, element, cure, tables, x, gradients, scales, lengths, failures):
    """Fill the deformation gradients of the points from nodal positions, with the volume ratios of the cure.

    Parameters
    ----------
    first, last : chunks of ELEMENT_CHUNK elements. scratch : (MOST_POINTS, columns), the thread's own.
    geometry, element, cure : what the kernel is compiled for. x : (nodes, d) [m].
    gradients : (n, 3, 3), written. scales : (n,) (theta / J)^(1/3), written, or None without a cure.
    lengths : (n,) current size of the element [m], written, or None. failures : (chunks, 2) status and point.
    """
    points = points_of(element)
    elements = tables.nodes.shape[0]
    for chunk in range(first, last):
        failures[chunk, 0] = OK
        for e in range(chunk * ELEMENT_CHUNK, min((chunk + 1) * ELEMENT_CHUNK, elements)):
            measure = 0.0
            for q in range(points):
                f = point_gradient(geometry, element, tables, x, e, q)
                ratio, area, possible = ratios_of(geometry, f)
                if not possible:
                    failures[chunk, 0] = INVERTED
                    failures[chunk, 1] = points * e + q
                    ratio = 1.0
                put_gradient(geometry, gradients, points * e + q, f)
                scratch[q, RATIO] = ratio
                measure += tables.areas[e, q] * area
            rescale(scales, geometry, element, cure, tables, e, scratch, gradients, failures, chunk)
            put_lengths(lengths, geometry, element, e, measure, tables.size_factor)


@generic
def rescale(scales, geometry, element, cure, tables, e, scratch, gradients, failures, chunk):
    """Give the gradients of element e the volume ratios that the cure makes of scratch[:, RATIO]."""


@rescale.register(np.ndarray)
def _(scales, geometry, element, cure, tables, e, scratch, gradients, failures, chunk):
    project(cure, element, tables, e, scratch, RATIO)
    for q in range(points_of(element)):
        i = points_of(element) * e + q
        theta = scratch[q, PROJECTED + RATIO]
        if not theta > 0.0:
            failures[chunk, 0] = INVERTED
            failures[chunk, 1] = i
            theta = 1.0
        scale = cube_root(theta / scratch[q, RATIO])
        scales[i] = scale
        scale_gradient(geometry, gradients, i, scale)


@rescale.register(type(None))
def _(scales, geometry, element, cure, tables, e, scratch, gradients, failures, chunk):
    return


@generic
def put_lengths(lengths, geometry, element, e, measure, size_factor):
    """Write the size of element e [m] from its area or volume [m^d] at its points, where it is asked for."""


@put_lengths.register(np.ndarray)
def _(lengths, geometry, element, e, measure, size_factor):
    length = size_factor * abs(measure) ** (1.0 / dimension_of(geometry))
    for q in range(points_of(element)):
        write(lengths, points_of(element) * e + q, length)


@put_lengths.register(type(None))
def _(lengths, geometry, element, e, measure, size_factor):
    return
