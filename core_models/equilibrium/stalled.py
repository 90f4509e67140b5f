"""An increment that does not come to equilibrium."""


class Stalled(Exception):
    """Newton's method has not found equilibrium in an increment; it is cut before the run gives up."""
