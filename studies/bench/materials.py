"""The law combinations whose speed is measured: the founding cards', and every flow law in both updates."""

from collections.abc import Iterator
from dataclasses import replace

from core_models.cards import shipped_materials
from core_models.cards.reader import read_material
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from studies.laws.sample_laws import SAMPLES


def bench_materials() -> Iterator[tuple[str, Material]]:
    """Name and material of every measured combination."""
    cook, threshold = _shipped("copper_hypoelastic_johnson_cook"), _shipped("copper_hyperelastic_mts")
    yield "hypoelastic, Johnson-Cook, Mie-Grüneisen", yardstick_material()
    yield "the same with Johnson-Cook damage", cook
    yield "hyperelastic, Johnson-Cook, Mie-Grüneisen, damage", replace(cook, update=threshold.update)
    yield "hypoelastic, MTS, Mie-Grüneisen, damage", replace(threshold, update=cook.update)
    yield "hyperelastic, MTS, Mie-Grüneisen, damage", threshold
    cold = replace(cook, damage=None, heating=None, melting=None, specific_heat=None)
    bulk = cook.elasticity.bulk_modulus
    for flow in SAMPLES["flow"]:
        name = type(flow).__name__
        plain = replace(cold, flow=flow, eos=DefaultHypoelastic(bulk), update=HypoelasticPlastic())
        yield f"hypoelastic, {name}, linear pressure", plain
        yield (
            f"hyperelastic, {name}, neo-Hookean",
            replace(plain, update=HyperelasticPlastic(), eos=NeoHookean(bulk)),
        )


def yardstick_material() -> Material:
    """The material whose update is also written by hand (studies.bench.yardstick)."""
    return replace(_shipped("copper_hypoelastic_johnson_cook"), damage=None)


def _shipped(name: str) -> Material:
    return read_material(shipped_materials()[name]).material
