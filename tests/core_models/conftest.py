"""A good card, what its broken variants raise, and a small pool of materials: each is compiled once for all tests."""

from pathlib import Path

import pytest

from core_models import points
from core_models.cards import read_material
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.perfect import PerfectPlasticity
from core_models.flow.power_law import PowerLaw
from core_models.flow.voce import Voce
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.kernels import advance_points
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.continuing_tangent import continuing_tangents
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.tangent_kernel import linearise_points
from core_models.yield_condition.von_mises import VonMises

GOOD_CARD = Path(__file__).parent / "good_card.xml"

BULK, SHEAR = 136.35e9, 45.45e9
UPDATES = {"hypo": HypoelasticPlastic(), "hyper": HyperelasticPlastic()}
FLOW_LAWS = {
    "perfect": PerfectPlasticity(90e6),
    "linear": LinearHardening(400e6, 100e6),
    "power": PowerLaw(90e6, 0.01, 0.3),
    "voce": Voce(450e6, 715e6, 16.93, 129.24e6),
    "jc": JohnsonCook(89.6e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0),
    "mts": MechanicalThreshold(
        40e6, 0.823e6, 1e7, 1.6, 1.0, 2 / 3, 2.0, 1e7, 0.2625, 770e6, 2390e6, 12e6, 1.696e6, 0.0, 0.0,
        45.78e9, 3.0e9, 180.0, 47.7e9,
    ),
}  # fmt: skip


@pytest.fixture
def read_card(tmp_path):
    """Read the good card after some replacements in its text."""

    def read(*changes):
        text = GOOD_CARD.read_text()
        for old, new in changes:
            assert text.count(old) == 1
            text = text.replace(old, new)
        path = tmp_path / "card.xml"
        path.write_text(text)
        return read_material(path)

    return read


@pytest.fixture
def refused(read_card, tmp_path):
    """The one-line message of the error that a changed card raises at a line."""

    def message(kind, line, *changes):
        with pytest.raises(kind) as caught:
            read_card(*changes)
        assert type(caught.value) is kind
        assert str(caught.value).startswith(f"{tmp_path}/card.xml:{line}: ")
        assert "\n" not in str(caught.value)
        return str(caught.value)

    return message


@pytest.fixture
def interpreted(monkeypatch):
    """Let points advance in plain Python: any material, without compilation."""
    for kernel in (advance_points, linearise_points, continuing_tangents):
        monkeypatch.setattr(points, kernel.__name__, getattr(kernel, "py_func", kernel))


@pytest.fixture(scope="session")
def flow_laws():
    """One flow law of each kind, by short name."""
    return FLOW_LAWS


@pytest.fixture(scope="session")
def copper():
    """Make a copper from an update and a flow law (or its short name); without energy, heat and damage.

    Keywords replace or add slots.
    """

    def make(update, flow=None, **slots):
        eos = DefaultHypoelastic(BULK) if update == "hypo" else NeoHookean(BULK)
        laws = {"elasticity": IsotropicElastic(BULK, SHEAR), "eos": eos, "density": 8930.0}
        if flow is not None:
            laws |= {"flow": FLOW_LAWS.get(flow, flow), "yield_condition": VonMises()}
        return Material(f"{update}-{flow}", update=UPDATES[update], **(laws | slots))

    return make


@pytest.fixture(scope="session")
def hot_copper(copper):
    """Make a copper with Mie-Grüneisen equation of state, damage, melting and heating, as the founding cards have."""

    def make(update, flow, **slots):
        laws = {
            "eos": MieGruneisen(8930.0, 3940.0, 2.02, 1.489),
            "damage": JohnsonCookDamage(0.54, 4.89, -3.03, 0.014, 1.12, 294.0, 1356.0),
            "melting": ConstantMelting(1356.0),
            "specific_heat": ConstantSpecificHeat(383.0),
            "heating": TaylorQuinney(0.9),
        }
        return copper(update, flow, **(laws | slots))

    return make


@pytest.fixture(scope="session")
def pool(copper, hot_copper):
    """Materials by name: update, flow law, and `hot` for those with energy, heat and damage."""
    return {
        "hypo-elastic": copper("hypo"),
        "hyper-elastic": copper("hyper"),
        "hypo-linear": copper("hypo", "linear"),
        "hyper-linear": copper("hyper", "linear"),
        "hypo-power": copper("hypo", "power"),
        "hyper-voce": copper("hyper", "voce"),
        "hypo-jc-hot": hot_copper("hypo", "jc"),
        "hyper-jc-hot": hot_copper("hyper", "jc"),
        "hyper-mts-hot": hot_copper("hyper", "mts"),
    }
