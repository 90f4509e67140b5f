"""Materials by name: shipped ones, those of shipped scenes, cards and scenes in files; and with another update."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from core_models import user_laws
from core_models.cards import load_document, read_material, shipped_materials
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.errors import SceneError
from core_models.material import Material
from core_models.names import suggestion
from core_models.schema import UPDATE
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from studies.scenes.reader import read_scene
from studies.scenes.shipped import shipped_scenes


def find_material(
    name: str, search_roots: Iterable[str | Path] = (), laws: str | Path | None = None
) -> tuple[Material, float]:
    """The material of a name or file, and the temperature that a body of it begins with [K].

    A scene gives that of its bar, a card its room temperature.
    Raises SceneError naming the nearest name; errors of cards and scenes as their readers raise them.
    """
    shipped = shipped_materials() | shipped_scenes()
    path = shipped.get(name, Path(name))
    if name not in shipped and path.suffix != ".xml" and not path.is_file():
        raise SceneError(
            f"no material or scene '{name}'; {suggestion(name, shipped)} (or the path of an XML file)"
        )
    if load_document(path, search_roots).tag == "scene":
        scene = read_scene(path, search_roots, laws)
        return scene.material, scene.bar.temperature
    if laws is not None:
        user_laws.load(laws)
    material = read_material(path, search_roots).material
    return material, material.room_temperature


def with_update(material: Material, name: str) -> Material:
    """The material with the stress update of that name; settings that both updates have are kept.

    The default equation of state of the hypoelastic update has no stored energy: the hyperelastic one takes the
    neo-Hookean of the same bulk modulus for it, as a card without an equation of state would.
    Raises SceneError naming the nearest update, MaterialError where a law does not fit it.
    """
    known = {kind: model.law for model in UPDATE.models for kind in model.types}
    known |= {kind.removesuffix("_plastic"): law for kind, law in known.items()}
    wanted = name.replace("-", "_").lower()
    if wanted not in known:
        shown = [model.types[0].removesuffix("_plastic") for model in UPDATE.models]
        raise SceneError(f"no stress update '{name}'; {suggestion(wanted, shown)}")
    law = known[wanted]
    if isinstance(material.update, law):
        return material
    eos = material.eos
    if law is HyperelasticPlastic and isinstance(eos, DefaultHypoelastic):
        eos = NeoHookean(eos.bulk_modulus)
    settings = {name: value for name, value in material.update._asdict().items() if name in law._fields}
    return replace(material, update=law(**settings), eos=eos)
