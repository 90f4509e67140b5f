"""The generic functions that laws register for: what each slot of a material has to answer.

A law states what it needs as plain class attributes: `uses_temperature = True` asks for a temperature,
`uses_energy = True` for the internal energy, `hardening_variable = <initial value>` for a history variable.
"""

import math

from core_models.dispatch import generic


@generic
def elastic_moduli(elasticity):
    """Bulk and shear modulus (K, G) [Pa] of an elasticity law, averaged over all directions if it knows several."""


@generic
def stiffness(elasticity):
    """The constants and axes of an elasticity law as a `Stiffness` (core_models.elasticity.stiffness)."""


@generic
def flow_stress(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    """Flow stress and its slopes.

    Parameters
    ----------
    flow : the law.
    hardening_variable : value of the law's own history variable (0 for laws without one).
    plastic_strain : equivalent plastic strain [-], >= 0.
    plastic_rate : its rate [1/s], >= 0.
    temperature : [K].

    Returns
    -------
    (stress [Pa], d/d hardening_variable, d/d plastic_strain [Pa], d/d plastic_rate [Pa s], d/d temperature [Pa/K])
    """


@generic
def evolve_hardening(flow, hardening_variable, strain_increment, plastic_rate, temperature):
    """History variable after `strain_increment`, and its slopes with respect to increment and rate."""


@evolve_hardening.otherwise
def _(flow, hardening_variable, strain_increment, plastic_rate, temperature):
    return hardening_variable, 0.0, 0.0


@generic
def under_pressure(flow, density_ratio, pressure, melting):
    """The flow law with the constants that it has at a density and a pressure, which `flow_stress` does not know.

    Parameters
    ----------
    density_ratio : rho / rho_0 > 0. pressure : [Pa], positive in compression. melting : melting temperature there
    [K], infinite if nothing tells.

    Returns
    -------
    a law of the same type: `flow` itself where neither density nor pressure matters
    """


@under_pressure.otherwise
def _(flow, density_ratio, pressure, melting):
    return flow


@generic
def pressure(eos, volume_ratio, energy):
    """Mean Cauchy stress (tension positive) of an equation of state.

    Parameters
    ----------
    volume_ratio : J = det F > 0. energy : internal energy per reference volume [J/m^3].

    Returns
    -------
    (mean stress [Pa], d/dJ at constant energy [Pa], d/d energy [-])
    """


@generic
def isentropic_ratio(eos, before, after):
    """Ratio of the temperatures after and before as J goes from `before` to `after` at constant entropy."""


@generic
def thermal_volume(expansion, temperature):
    """Volume ratio J_th that an unstressed body has at a temperature [K]."""


@thermal_volume.register(type(None))
def _(expansion, temperature):
    return 1.0


@generic
def is_beyond_eos(eos, volume_ratio):
    """Whether J lies where the equation of state has no meaning (beyond its pole)."""


@generic
def shear_modulus(law, density_ratio, temperature, pressure, melting):
    """Shear modulus and its slopes.

    Parameters
    ----------
    density_ratio : rho / rho_0 > 0. temperature : [K]. pressure : [Pa], positive in compression.
    melting : melting temperature at that density and pressure [K], infinite if nothing melts.

    Returns
    -------
    (modulus [Pa], d/d density_ratio [Pa], d/d temperature [Pa/K], d/d pressure [-], d/d melting [Pa/K])
    """


@generic
def shear_stiffness(law, elasticity, density_ratio, temperature, pressure, melting):
    """Shear modulus [Pa] of the law in the slot shear_modulus, that of the elasticity where the slot is empty."""


@shear_stiffness.register(type(None))
def _(law, elasticity, density_ratio, temperature, pressure, melting):
    return elastic_moduli(elasticity)[1]


@shear_stiffness.otherwise
def _(law, elasticity, density_ratio, temperature, pressure, melting):
    return shear_modulus(law, density_ratio, temperature, pressure, melting)[0]


@generic
def melting_temperature(melting, density_ratio=1.0, pressure=0.0):
    """Melting temperature [K].

    Parameters
    ----------
    density_ratio : rho / rho_0 > 0. pressure : [Pa], positive in compression. Left out: the body at rest.
    """


@melting_temperature.register(type(None))
def _(melting, density_ratio=1.0, pressure=0.0):
    return math.inf


@generic
def heat_capacity(specific_heat, temperature):
    """Specific heat [J/(kg K)]."""


@heat_capacity.register(type(None))
def _(specific_heat, temperature):
    return math.inf


@generic
def heated_fraction(heating):
    """Fraction of the plastic work that becomes heat [-]."""


@heated_fraction.register(type(None))
def _(heating):
    return 0.0


@generic
def volume_warming(heating, eos, before, after):
    """Factor on the temperature as J goes from `before` to `after`, plastic work apart."""


@volume_warming.otherwise
def _(heating, eos, before, after):
    return 1.0


@generic
def damage_increment(damage, strain_increment, plastic_rate, temperature, mean_stress, equivalent_stress):
    """Increase of the damage variable [-] for an increment of equivalent plastic strain."""


@damage_increment.register(type(None))
def _(damage, strain_increment, plastic_rate, temperature, mean_stress, equivalent_stress):
    return 0.0


@generic
def stability_measure(stability, tangents, stresses, bulk_modulus, shear_modulus):
    """How far points are from an instability [-]: about 1 in the elastic body at rest, lost at and below 0; (n,).

    For arrays, between steps: it runs in no kernel.

    Parameters
    ----------
    tangents : (n, 3, 3, 3, 3) change of the first Piola stress with the velocity gradient, da_ij = a_ijkl dl_kl, in the
    present configuration [Pa]. stresses : (n, 3, 3) Cauchy stress [Pa]. bulk_modulus, shear_modulus : at rest [Pa].
    """


@generic
def eroded_stress(erosion, damage, deviator, mean_stress):
    """Deviator and mean stress that a point whose damage variable is `damage` carries; all of it below 1."""


@eroded_stress.register(type(None))
def _(erosion, damage, deviator, mean_stress):
    return deviator, mean_stress


@generic
def damage_after(erosion, damage, increment, dt):
    """Damage variable after a step of dt [s] in which the damage law adds an increment."""


@damage_after.otherwise
def _(erosion, damage, increment, dt):
    return damage + increment


@generic
def is_out(erosion, damage):
    """Whether a point of this damage takes no part any more."""


@is_out.otherwise
def _(erosion, damage):
    return False


@generic
def strength_taken(damage, value):
    """Share of the strength that the damage law takes away at a value of the damage variable [-], in [0, 1]."""


@strength_taken.otherwise
def _(damage, value):
    return 0.0


@generic
def weakened(cause, flow, share):
    """The flow law of which a law `cause` (damage, erosion) leaves a share; itself where there is none."""


@weakened.register(type(None))
def _(cause, flow, share):
    return flow


@generic
def back_stress_count(kinematic_hardening):
    """How many back stresses a law of kinematic hardening sums up."""


@back_stress_count.register(type(None))
def _(kinematic_hardening):
    return 0


@back_stress_count.otherwise
def _(kinematic_hardening):
    return 1


@generic
def back_stress_constants(kinematic_hardening, term):
    """Modulus C [Pa] and recovery gamma [-] of a back stress: d alpha = 2/3 C d e_p - gamma alpha d ep."""


@back_stress_constants.register(type(None))
def _(kinematic_hardening, term):
    return 1.0, 0.0  # never asked for: there is no term


@generic
def nucleated(damage, plastic_strain, increment):
    """Volume fraction of voids [-] that an increment of plastic strain of the matrix brings, and its slope."""


@nucleated.otherwise
def _(damage, plastic_strain, increment):
    return 0.0, 0.0


@generic
def damage_of_porosity(yield_condition, porosity, damage):
    """Damage variable of a point with voids, at least `damage`; that itself where the yield condition knows none.

    porosity, damage : before the step [-]; numbers, or arrays of as many points.
    """


@damage_of_porosity.otherwise
def _(yield_condition, porosity, damage):
    return damage
