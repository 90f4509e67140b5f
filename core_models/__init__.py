"""Constitutive laws shared by every method: laws, materials, states of material points and their update."""

from core_models.compilation import use_source_keyed_cache, use_whole_registers

use_source_keyed_cache()
use_whole_registers()

DISTRIBUTION = "matpoint"
