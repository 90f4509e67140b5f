"""Material cards: XML in and out."""

from core_models.cards.blocks import check_attributes, named_children
from core_models.cards.bodies import Cylinder
from core_models.cards.includes import load_document
from core_models.cards.numbers import read_number
from core_models.cards.origins import Origin, origin, refusal
from core_models.cards.reader import MaterialCard, UnusedTag, parse_material, read_material
from core_models.cards.shipped import DATA_FOLDER, shipped_materials
from core_models.cards.writer import material_element, write_material

__all__ = [
    "DATA_FOLDER",
    "Cylinder",
    "MaterialCard",
    "Origin",
    "UnusedTag",
    "check_attributes",
    "load_document",
    "material_element",
    "named_children",
    "origin",
    "parse_material",
    "read_material",
    "read_number",
    "refusal",
    "shipped_materials",
    "write_material",
]
