"""The transfers of velocity between particles and grid, by name."""

from typing import NamedTuple

from core_models.arguments import check_between, check_share
from core_models.errors import SceneError
from core_models.names import suggestion

TRANSFERS = ("apic", "flip", "pic", "xpic")
MOST_XPIC = 20  # order; beyond it the filter's alternating sums lose their digits


class Transfer(NamedTuple):
    """How particles take velocities from the grid: v_p = S v + own v_p + share S w (see mpm.to_particles).

    affine : whether particles carry an affine velocity too. order : of XPIC's filter, 0 for the other transfers.
    """

    affine: bool = False
    own: float = 0.0
    share: float = 0.0
    order: int = 0

    @property
    def keeps_velocity(self) -> bool:
        """Whether w is the grid's velocity before the forces."""
        return self.own != 0.0


def make_transfer(name: str, flip_fraction: float, xpic_order: int) -> Transfer:
    """The transfer of a name; SceneError for an unknown one, or numbers out of range."""
    if name not in TRANSFERS:
        raise SceneError(f"no transfer is called {name!r}; {suggestion(name, TRANSFERS)}")
    check_share("flip_fraction", flip_fraction)
    if not isinstance(xpic_order, int):
        raise SceneError(f"xpic_order = {xpic_order!r} is no whole number: give 1 to {MOST_XPIC}")
    check_between("xpic_order", xpic_order, 0, MOST_XPIC)
    if name == "apic":
        return Transfer(affine=True)
    if name == "flip" and flip_fraction > 0.0:
        return Transfer(own=flip_fraction, share=-flip_fraction)
    if name == "xpic" and xpic_order > 1:
        return Transfer(share=1.0, order=xpic_order)
    return Transfer()
