"""The configuration that the grid covers: the body as it is now, or its reference body.

With x the positions in the grid, V the volume and L = sum v_i grad N_i there,

    updated   f_i = - V sigma grad N_i,               F_new = (1 + dt L) F
    total     f_i = - V0 P grad N_i, P = J sigma F^-T,   F_new = F + dt L

and the hoop direction of a body of revolution likewise. In the total configuration x, weights and the order of the
particles never change: particles cross no cells, and come apart only where the material does.
Source: de Vaucorbeil, Nguyen & Hutchinson, Comput. Methods Appl. Mech. Eng. 360 (2020) 112783.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import CHUNK, kernel
from core_models.dispatch import generic
from core_models.errors import SceneError, UnsupportedError
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from core_models.names import suggestion
from core_models.state import read, write
from core_models.tensors import determinant, inverse, load_tensor, store_tensor
from mpm.geometries import deform, dimension_of
from mpm.lanes import lane, lanes

REFERENCE_SHAPES = ("linear", "gimp", "quadratic", "cubic")


class Updated(NamedTuple):
    """The grid covers the body as it is now."""


class Total(NamedTuple):
    """The grid covers the reference body.

    stretch : (n,) what F of a particle is divided by before its points see it (mpm.dilatation), or None for 1.
    """

    stretch: np.ndarray | None = None


CONFIGURATIONS = {"updated": Updated(), "total": Total()}


def find_configuration(name: str, interpolation: str, conduction: bool) -> Updated | Total:
    """The configuration of a name.

    Raises SceneError for an unknown one, UnsupportedError for what the total configuration does not have.
    """
    if name not in CONFIGURATIONS:
        raise SceneError(f"no configuration is called {name!r}; {suggestion(name, CONFIGURATIONS)}")
    if name == "total":
        if interpolation not in REFERENCE_SHAPES:
            raise UnsupportedError(
                f"interpolation {interpolation!r} follows the deformed particles, which configuration 'total' has no "
                f"need of: give one of {', '.join(REFERENCE_SHAPES)}, or configuration 'updated'"
            )
        if conduction:
            raise UnsupportedError(
                "conduction is not available in configuration 'total': use configuration 'updated'"
            )
    return CONFIGURATIONS[name]


@generic
def pulls(configuration, geometry, gradients, p, volume, ratio, s_xx, s_yy, s_zz, s_xy, s_yz, s_zx):
    """What the slopes carry of particle p as three lanes [N m], and minus volume times hoop stress [N m].

    volume : reference volume [m^3]. ratio : det F. s_xx ... : stress [Pa].
    """


@pulls.register(Updated)
def _(configuration, geometry, gradients, p, volume, ratio, s_xx, s_yy, s_zz, s_xy, s_yz, s_zx):
    volume = -volume * ratio
    t_xx, t_yy, t_zz = volume * s_xx, volume * s_yy, volume * s_zz
    t_xy, t_yz, t_zx = volume * s_xy, volume * s_yz, volume * s_zx
    return lanes(t_xx, t_xy, t_zx, 0.0), lanes(t_xy, t_yy, t_yz, 0.0), lanes(t_zx, t_yz, t_zz, 0.0), t_zz


@pulls.register(Total)
def _(configuration, geometry, gradients, p, volume, ratio, s_xx, s_yy, s_zz, s_xy, s_yz, s_zx):
    f = load_tensor(gradients, p)
    volume = -volume / read(configuration.stretch, p, 1.0)
    x, y = lanes(s_xx, s_xy, s_zx, 0.0) * volume, lanes(s_xy, s_yy, s_yz, 0.0) * volume
    z = lanes(s_zx, s_yz, s_zz, 0.0) * volume
    # J F^-T, the cofactors of F
    hoop = f[0] * f[4] - f[1] * f[3]
    pull_x = (
        (f[4] * f[8] - f[5] * f[7]) * x + (f[2] * f[7] - f[1] * f[8]) * y + (f[1] * f[5] - f[2] * f[4]) * z
    )
    pull_y = (
        (f[5] * f[6] - f[3] * f[8]) * x + (f[0] * f[8] - f[2] * f[6]) * y + (f[2] * f[3] - f[0] * f[5]) * z
    )
    pull_z = (f[3] * f[7] - f[4] * f[6]) * x + (f[1] * f[6] - f[0] * f[7]) * y + hoop * z
    return pull_x, pull_y, pull_z, lane(pull_z, 2)


@generic
def deform_particle(configuration, geometry, old, new, p, dt, x, y, z, v, positions):
    """Write the new F of particle p for L with columns x, y, z and velocity v; returns its determinant."""


@deform_particle.register(Updated)
def _(configuration, geometry, old, new, p, dt, x, y, z, v, positions):
    return deform(geometry, old, new, p, dt, x, y, z, v, positions)


@deform_particle.register(Total)
def _(configuration, geometry, old, new, p, dt, x, y, z, v, positions):
    f, s = load_tensor(old, p), read(configuration.stretch, p, 1.0)
    hoop = lane(z, 2) + hoop_rate(geometry, v, positions, p)
    g = (
        s * f[0] + dt * lane(x, 0), s * f[1] + dt * lane(y, 0), s * f[2] + dt * lane(z, 0),
        s * f[3] + dt * lane(x, 1), s * f[4] + dt * lane(y, 1), s * f[5] + dt * lane(z, 1),
        s * f[6] + dt * lane(x, 2), s * f[7] + dt * lane(y, 2), s * f[8] + dt * hoop,
    )  # fmt: skip
    store_tensor(new, p, g)
    return determinant(g)


@generic
def hoop_rate(geometry, v, positions, p):
    """Rate [1/s] of the hoop stretch of particle p with velocity v."""


@hoop_rate.register(Axisymmetric)
def _(geometry, v, positions, p):
    return lane(v, 0) / positions[p, 0]


@hoop_rate.register(PlaneStrain)
@hoop_rate.register(Spatial)
def _(geometry, v, positions, p):
    return 0.0


@kernel
def pull_back(first, last, geometry, gradients, wave_speed, cell_size, lengths, fastest):
    """Largest speed c |F^-1| of waves through the reference body [m/s], squared, for each of some chunks of particles.

    gradients (n, 3, 3). wave_speed (n,) [m/s]. lengths (n,) : current size of a cell [m], written, or None.
    fastest (chunks,), written: |F^-1|^2 is bounded by the largest row sum of F^-1 F^-T, exact without shear.
    """
    d = dimension_of(geometry)
    for chunk in range(first, last):
        most = 0.0
        for p in range(chunk * CHUNK, min((chunk + 1) * CHUNK, gradients.shape[0])):
            f = load_tensor(gradients, p)
            det = determinant(f)
            g = inverse(f, det)
            xx, yy, zz = (
                g[0] * g[0] + g[1] * g[1] + g[2] * g[2],
                g[3] * g[3] + g[4] * g[4] + g[5] * g[5],
                g[6] * g[6] + g[7] * g[7] + g[8] * g[8],
            )
            xy = abs(g[0] * g[3] + g[1] * g[4] + g[2] * g[5])
            yz = abs(g[3] * g[6] + g[4] * g[7] + g[5] * g[8])
            zx = abs(g[0] * g[6] + g[1] * g[7] + g[2] * g[8])
            square = max(xx + xy + zx, yy + xy + yz)
            if d == 3:
                square = max(square, zz + yz + zx)
            most = max(most, wave_speed[p] * wave_speed[p] * square)
            area = det if d == 3 else det * g[8]
            write(lengths, p, cell_size * area ** (1.0 / d))
        fastest[chunk] = most
