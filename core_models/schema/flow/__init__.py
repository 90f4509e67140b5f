"""The card schema of the flow laws, one law or family a file."""

from core_models.schema.entries import SlotSchema
from core_models.schema.flow.anand import ANAND
from core_models.schema.flow.hardening import LINEAR, PERFECT, POWER_LAW, TABULATED, THERMAL_VOCE, VOCE
from core_models.schema.flow.johnson_cook import JOHNSON_COOK
from core_models.schema.flow.mts import MTS
from core_models.schema.flow.preston_tonks_wallace import PRESTON_TONKS_WALLACE
from core_models.schema.flow.steinberg_cochran_guinan import STEINBERG_COCHRAN_GUINAN
from core_models.schema.flow.zerilli_armstrong import ZERILLI_ARMSTRONG

FLOW = SlotSchema(
    slot="flow",
    tags=("plasticity_model", "flow_model"),
    places=("constitutive_model",),
    absent="",
    models=(
        PERFECT,
        LINEAR,
        POWER_LAW,
        VOCE,
        THERMAL_VOCE,
        TABULATED,
        JOHNSON_COOK,
        MTS,
        ZERILLI_ARMSTRONG,
        STEINBERG_COCHRAN_GUINAN,
        PRESTON_TONKS_WALLACE,
        ANAND,
    ),
    plain=("none",),
    unavailable=("zerilli_armstrong_polymer", "suvic_i"),
)
