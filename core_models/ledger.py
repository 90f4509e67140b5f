"""Energy ledger of a run."""

from dataclasses import dataclass


@dataclass
class EnergyLedger:
    """Energies of the whole body [J]; every dissipative term is the integral of its own power.

    kinetic : of the motion now. strain : work of the stress that has not been dissipated (elastic and, with an equation
    of state, thermal). plastic : sigma_y dep. viscosity : work of the bulk viscosity. transfer : what moving velocities
    between particles and grid has lost: kinetic energy, and work that the same forces do on other velocities (0 in the
    finite element method). contact : what the wall's normal impulses have taken out, - impulse times mean velocity, and
    what supports have by stopping or starting a body at once; friction : what the wall's tangential impulses have.
    hourglass : held by the hourglass control of one-point elements. damping : taken out by mass-proportional damping.
    external : work done on the body by loads and prescribed motion. initial : kinetic and strain energy at the start.
    heat : conducted into the body through its boundary; it changes temperatures only and stands apart from the balance.

    The balance: initial + external = kinetic + strain + plastic + viscosity + transfer + contact + friction +
    hourglass + damping.
    """

    initial: float
    kinetic: float
    strain: float = 0.0
    plastic: float = 0.0
    viscosity: float = 0.0
    transfer: float = 0.0
    contact: float = 0.0
    friction: float = 0.0
    hourglass: float = 0.0
    damping: float = 0.0
    external: float = 0.0
    heat: float = 0.0

    @property
    def total(self) -> float:
        """Sum of all terms but `initial`, the external work counted as taken from outside [J]."""
        return (
            self.kinetic + self.strain + self.plastic + self.viscosity + self.transfer + self.contact + self.friction
            + self.hourglass + self.damping - self.external
        )  # fmt: skip

    @property
    def relative_error(self) -> float:
        """(total - initial) / scale, the scale being the energy that there was or came in, whichever is larger."""
        scale = max(abs(self.initial), abs(self.external), self.kinetic + abs(self.strain))
        return (self.total - self.initial) / scale if scale > 0.0 else self.total
