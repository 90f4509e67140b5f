"""What every locking cure has in common.

The points see Fbar = (theta / J)^(1/3) F, where theta = P J and P is linear, leaves constants alone and is symmetric
with respect to the reference weights, w_q P_qk = w_k P_kq. Then the virtual work of the stress at Fbar is

    sum_q w_q [theta_q s_q : grad du + p_q sum_k P_qk J_k div_k du]
  = sum_q [w_q theta_q s_q + w_q J_q (P p)_q 1] : grad du

so the nodal forces, with the mean stress replaced by P p, are the exact gradient of an energy that depends on Fbar.
Of elements with more points than modes of P, P leaves every point a share of its own volume ratio, which breaks none of
this: P = (1 - share) P0 + share, where P0 projects on the modes. See `fem.cures.own_share`.
Source: Simo, Taylor & Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177, for the element's mean.
"""

from core_models.dispatch import generic
from fem.elements import points_of

RATIO, PRESSURE = 0, 1
PROJECTED = 2  # columns of the scratch: what is projected, and behind it what came of it


@generic
def project(cure, element, tables, e, scratch, column):
    """Project a number at the points of element e: scratch[q, column] -> scratch[q, PROJECTED + column].

    column : RATIO or PRESSURE.
    """


@project.register(type(None))
def _(cure, element, tables, e, scratch, column):
    for q in range(points_of(element)):
        scratch[q, PROJECTED + column] = scratch[q, column]
