"""Volumetric part of the Simo-Hughes neo-Hookean law."""

from typing import NamedTuple

from core_models.laws import is_beyond_eos, pressure


class NeoHookean(NamedTuple):
    """Neo-Hookean equation of state: p = K/2 (J - 1/J), from U = K/2 [(J^2 - 1)/2 - ln J] (tension positive).

    Parameters
    ----------
    bulk_modulus : K [Pa], > 0.

    Valid for every J > 0.
    Source: Simo & Hughes, Computational Inelasticity (1998), eq. 9.2.3; Uintah's `default_hyper`.
    """

    bulk_modulus: float


@pressure.register(NeoHookean)
def _(eos, volume_ratio, energy):
    inverse = 1.0 / volume_ratio
    half_modulus = 0.5 * eos.bulk_modulus
    return half_modulus * (volume_ratio - inverse), half_modulus * (1.0 + inverse * inverse), 0.0


@is_beyond_eos.register(NeoHookean)
def _(eos, volume_ratio):
    return False
