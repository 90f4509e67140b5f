"""Interpolations between grid and particles, one per file: products of one-dimensional functions along the axes.

Coordinates count cells: node i lies at i + 1/2. Each function here is generic in the interpolation; from `weights` on
they take and give lanes, one per axis. t is the interpolation's own local coordinate of a particle, from `locate`;
`half` is half the particle's size, of which only GIMP takes notice.
"""

from core_models.dispatch import generic


@generic
def reach(shape):
    """Number of nodes along an axis that a particle reaches: a constant when compiled."""


@generic
def middle(shape):
    """Distance from the first of these nodes to where t = 0 [cells]."""


@generic
def layers(shape):
    """Layers of nodes beyond a plane that particles on this side reach."""


@generic
def locate(shape, x):
    """First node that a coordinate x [cells] reaches, as a number without fraction, and t."""


@generic
def locate_particle(shape, geometry, p, axis, x, over_h):
    """`locate` for particle p at x [cells] along an axis."""


@locate_particle.otherwise
def _(shape, geometry, p, axis, x, over_h):
    return locate(shape, x)


@generic
def half_size(shape, p, over_h):
    """Half the size of particle p along the axes [cells]."""


@half_size.otherwise
def _(shape, p, over_h):
    return 0.0


@generic
def weights(shape, t, half):
    """Weights of the nodes."""


@generic
def slopes(shape, t, half):
    """Derivatives of the weights [1 / cell]."""


@generic
def spread(shape, t, half):
    """Second moment D = sum of weight times squared distance to the node [cells^2]."""


@generic
def row(shape, table, place):
    """The numbers of the nodes in a table with four numbers per node, from `place` on, as a tuple."""


@generic
def moments(shape, t, half):
    """Weight times distance to the node over D [1 / cell]: what turns nodal velocities into an affine velocity."""
