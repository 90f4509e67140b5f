"""Nodes of next to no mass: which solvers they make unstable.

A node that has a share s of a particle's mass is moved by the particle's stress with f / m = sigma |grad N| V / (s m).
With splines |grad N|^2 / N has a bound. Linear hats have none: the frequency of the node grows as 1 / sqrt(s), beyond
any step, and a particle that has just entered a cell may have any s. Nothing comes of it where the node's velocity
reaches particles through N alone: that is how they move, how they take it with FLIP, PIC and XPIC, and what `musl`
makes their velocity gradient of. USL and the affine velocities of APIC take it through grad N.
Sources: Sulsky, Zhou & Schreyer, Comput. Phys. Commun. 87 (1995) 236; Nairn, Comput. Model. Eng. Sci. 4 (2003) 649.
"""

import logging

from mpm.musl import MUSL

logger = logging.getLogger(__name__)


def warn_of_small_masses(interpolation: str, transfer: str, update: str) -> None:
    """Log a warning where the solver has no stable step once a particle's share of a node is small."""
    if interpolation == "linear" and (update != MUSL or transfer == "apic"):
        logger.warning(
            "interpolation 'linear' with transfer '%s' and update '%s' is unstable wherever nodes have little mass: "
            "give transfer='flip', update='musl', or interpolation='quadratic'",
            transfer,
            update,
        )
