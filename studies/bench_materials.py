"""The law combinations whose speed is measured, from the founding cards."""

from collections.abc import Iterator
from dataclasses import replace

from core_models.cards import shipped_materials
from core_models.cards.reader import read_material
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.linear import LinearHardening
from core_models.flow.perfect import PerfectPlasticity
from core_models.flow.power_law import PowerLaw
from core_models.flow.voce import Voce
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic

SIMPLE_FLOWS = {
    "perfect": PerfectPlasticity(400e6),
    "linear": LinearHardening(400e6, 100e6),
    "power law": PowerLaw(100e6, 0.01, 0.3),
    "Voce": Voce(100e6, 300e6, 20.0, 50e6),
}


def bench_materials() -> Iterator[tuple[str, Material]]:
    """Name and material of every measured combination."""
    shipped = shipped_materials()
    cook = read_material(shipped["copper_hypoelastic_johnson_cook"]).material
    threshold = read_material(shipped["copper_hyperelastic_mts"]).material
    bulk = cook.elasticity.bulk_modulus
    cold = replace(cook, damage=None, heating=None, melting=None, specific_heat=None)
    for name, flow in SIMPLE_FLOWS.items():
        yield f"hypoelastic, {name}, linear pressure", replace(cold, flow=flow, eos=DefaultHypoelastic(bulk))
    linear = SIMPLE_FLOWS["linear"]
    yield (
        "hyperelastic, linear, neo-Hookean",
        replace(cold, update=HyperelasticPlastic(1e-10), flow=linear, eos=NeoHookean(bulk)),
    )
    yield "hypoelastic, Johnson-Cook, Mie-Grüneisen", replace(cook, damage=None)
    yield "the same with Johnson-Cook damage", cook
    yield "hyperelastic, Johnson-Cook, Mie-Grüneisen, damage", replace(cook, update=threshold.update)
    yield "hypoelastic, MTS, Mie-Grüneisen, damage", replace(threshold, update=cook.update)
    yield "hyperelastic, MTS, Mie-Grüneisen, damage", threshold
