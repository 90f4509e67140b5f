"""Energy ledger of a run."""

from dataclasses import dataclass


@dataclass
class EnergyLedger:
    """Energies of the whole body [J]; every dissipative term is the integral of its own power.

    kinetic : of the motion now. strain : work of the stress that has not been dissipated (elastic and, with an
    equation of state, thermal). plastic : sigma_y dep. viscosity : work of the bulk viscosity. transfer : what moving
    velocities between particles and grid has lost (0 in the finite element method). contact : what the wall's
    impulses have taken out, - impulse times mean velocity. initial : kinetic energy at the start.

    The terms on the right close the balance: initial = kinetic + strain + plastic + viscosity + transfer + contact.
    """

    initial: float
    kinetic: float
    strain: float = 0.0
    plastic: float = 0.0
    viscosity: float = 0.0
    transfer: float = 0.0
    contact: float = 0.0

    @property
    def total(self) -> float:
        """Sum of all terms but `initial` [J]."""
        return self.kinetic + self.strain + self.plastic + self.viscosity + self.transfer + self.contact

    @property
    def relative_error(self) -> float:
        """(total - initial) / initial."""
        return (self.total - self.initial) / self.initial if self.initial > 0.0 else self.total
