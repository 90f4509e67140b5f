"""Impacts: fast, hot, soft, softening, damaged."""

from dataclasses import replace

from core_models.erosion.zero_stress import ZeroStress
from studies.stability.bodies import bar, bar_mesh, copper, hardening, hyperelastic, softening
from studies.stability.case import Case

END = 15e-6  # s
MICRON = 1e-3  # scale of a bar whose strain rate is a thousand times as high


def _impact(speed: float, **options):
    return lambda variant: bar(variant, copper(), velocity=-speed, wall="unilateral", **options)


def _held(variant: str):
    return bar(variant, copper(), velocity=-400.0, wall="plane")


def _soft(variant: str):
    return bar(variant, hardening(1.0, 0.0), velocity=-200.0, wall="unilateral")


def _softening(variant: str):
    return bar(variant, softening(), velocity=-200.0, wall="unilateral")


def _eroding(variant: str):
    return bar(variant, replace(copper(), erosion=ZeroStress()), velocity=-500.0, wall="unilateral")


def _hyperelastic(variant: str):
    return bar(variant, hyperelastic(copper()), velocity=-600.0, wall="unilateral")


def _fast_rate(variant: str):
    mesh = bar_mesh(variant, scale=MICRON)
    cell = MICRON * 0.4e-3
    return bar(variant, copper(), mesh=mesh, cell=cell, velocity=-500.0, wall="unilateral")


CASES = (
    Case("taylor-600", "Copper bar at 600 m/s", _impact(600.0), END),
    Case("taylor-600-hyperelastic", "The same with the hyperelastic update", _hyperelastic, END),
    Case("taylor-plane", "Copper bar at 400 m/s, held by a plane wall", _held, END),
    Case("melting", "Copper bar 6 K below melting, 200 m/s", _impact(200.0, temperature=1350.0), END),
    Case("melted", "Copper bar above melting: no strength, 200 m/s", _impact(200.0, temperature=1400.0), END),
    Case("erosion", "Copper bar at 500 m/s whose damaged points lose all stress", _eroding, END),
    Case("soft", "Yield stress of 1 Pa, 200 m/s", _soft, END),
    Case("softening", "Flow stress that falls with strain until next to nothing is left, 200 m/s", _softening, END),
    Case("rate-1e8", "A bar of a few micrometres: strain rates of 1e8 1/s", _fast_rate, MICRON * END),
)  # fmt: skip
