"""Effects that a scene calls for, decided from its numbers, and what switching them says."""

import json
from dataclasses import asdict, replace

import pytest

from core_models.erosion.preserve_stress import PreserveStress
from core_models.erosion.zero_stress import ZeroStress
from core_models.errors import RunFailure, UnsupportedError
from studies.bar.taylor_impact import Quantity
from studies.command_line import main
from studies.decisions.afterwards import is_confirmed, verified
from studies.decisions.beforehand import Decision, decisions, disagreements
from studies.decisions.text import decisions_text, verified_text
from studies.effects_study import study
from studies.effects_study.off import OffCost, all_off, never_had
from studies.effects_study.study import compare_effects, planned
from studies.effects_study.switched import AS_IT_IS, Switched
from studies.effects_study.switches import SWITCHES
from studies.effects_study.tables import verdict_table
from studies.observers.history import COLUMNS, ENERGIES, History
from studies.runs.costs import Cost
from studies.runs.record import to_json
from studies.runs.result import RunResult
from studies.scenes.plan_text import plan_text
from studies.scenes.reader import read_scene
from studies.work_precision.measurement import Measurement

SCENES = ("taylor-classic", "taylor-copper-jc", "taylor-copper-mts", "taylor-ofhc-190")


@pytest.fixture
def copper():
    """The founding example."""
    return read_scene("taylor-copper-jc")


def found(scene, effect):
    """The decision about one effect."""
    return next(each for each in decisions(scene, "unilateral") if each.effect == effect)


def test_numbers_are_those_of_the_scene(copper):
    """Fourier number, heating by what is left to melting, and impact pressure by K, worked out by hand."""
    end, bar, material = copper.end.limit("unilateral"), copper.bar, copper.material
    fourier = material.thermal_conductivity / (material.density * 383.0) * end / bar.radius**2
    assert found(copper, "heat conduction").number == pytest.approx(fourier, rel=1e-6)
    rise = 0.45 * bar.velocity**2 / 383.0
    assert found(copper, "plastic heating").number == pytest.approx(rise / (1356.0 - 294.0), rel=0.05)
    speed = ((136.35e9 + 4.0 / 3.0 * 45.45e9) / material.density) ** 0.5
    pressure = material.density * speed * -bar.velocity
    assert found(copper, "equation of state").number == pytest.approx(pressure / 136.35e9, rel=1e-6)


def test_the_founding_example_has_what_its_numbers_ask_for(copper):
    """Heating, equation of state, viscosity and damage on; conduction and gravity off."""
    assert disagreements(copper, "unilateral") == []
    wanted = {each.effect: each.wanted for each in decisions(copper, "unilateral")}
    assert wanted["plastic heating"] and wanted["damage"] and not wanted["heat conduction"]
    assert wanted["wall friction"] is None


def test_decisions_of_every_shipped_scene_can_be_written_down():
    """Their numbers and verdicts are what JSON knows, whatever the laws have computed them with."""
    for name in SCENES:
        scene = read_scene(name)
        entries = [asdict(each) | {"wanted": each.wanted} for each in decisions(scene, "unilateral")]
        assert json.loads(to_json({"decisions": entries}))["decisions"] == entries


def test_slow_and_long_scenes_ask_for_other_effects(copper):
    """A thousandth of the speed asks for no equation of state; ten seconds for conduction."""
    slow = replace(copper, bar=replace(copper.bar, velocity=0.001 * copper.bar.velocity))
    assert not found(slow, "equation of state").wanted and not found(slow, "plastic heating").wanted
    long = replace(copper, end=replace(copper.end, latest=10.0, plane=10.0))
    assert found(long, "heat conduction").wanted and found(long, "gravity").wanted
    names = {each.effect for each in disagreements(long, "unilateral")}
    assert {"heat conduction", "gravity"} <= names


def test_check_says_every_decision_with_number_and_threshold(copper):
    """The text of `matpoint check` has them all."""
    text = plan_text(copper, ("mpm",), (4,), None)
    assert decisions_text(decisions(copper, "unilateral")) in text and "≥ 0.02" in text


@pytest.fixture
def ended(copper):
    """A run that has come to its end, with numbers of our own: half of its energy is no longer kinetic."""
    history = History(None, 1.0)
    history._rows = [tuple(float(name == "t") * t for name in COLUMNS) for t in (0.0, 50e-6)]
    history._rows[1] = tuple(
        1e6 if name == "wall_force" else x for name, x in zip(COLUMNS, history._rows[1], strict=True)
    )
    energies = dict.fromkeys(ENERGIES, 0.0) | {
        "initial": 400.0,
        "kinetic": 200.0,
        "viscosity": 2.0,
        "plastic": 150.0,
    }
    quantities = {"max_temperature": Quantity(294.0 + 531.0, "K")}
    return RunResult(
        copper, "fem-explicit", 4, "unilateral", 1, history, Cost(), energies=energies, quantities=quantities
    )  # fmt: skip


def test_a_run_verifies_what_was_decided(ended):
    """Numbers worked out by hand; each confirms what the scene has, or does not, or cannot tell."""
    numbers = {decision.effect: (decision, number) for decision, number in verified(ended)}
    assert numbers["plastic heating"][1] == pytest.approx(0.5)
    assert numbers["bulk viscosity"][1] == pytest.approx(0.005) and numbers["inertia"][1] == pytest.approx(
        2.0
    )
    bar, density = ended.scene.bar, ended.scene.material.density
    section = 2.0 * 400.0 / bar.velocity**2 / (density * bar.length)
    assert numbers["equation of state"][1] == pytest.approx(1e6 / section / 136.35e9)
    assert is_confirmed(*numbers["plastic heating"]) and is_confirmed(*numbers["heat conduction"])
    assert is_confirmed(*numbers["bulk viscosity"]) is False
    assert not numbers["heat conduction"][0].wanted
    assert is_confirmed(*numbers["wall friction"]) is None and numbers["damage"][1] is None
    text = verified_text(verified(ended))
    assert "found 0.5: needed, as foreseen" in text and "found 0.005: not needed after all" in text
    assert "not needed, as foreseen" in text
    assert "the run cannot tell" in text


def test_a_finding_on_the_side_of_the_number_confirms_it_whatever_the_scene_has(ended):
    """Too slow for an equation of state and kept all the same: number and finding agree; without a number none does."""
    kept = Decision("equation of state", True, 3.1e-7, 0.01, "")
    assert is_confirmed(kept, 2.8e-7) is True and is_confirmed(kept, 0.3) is False
    text = verified_text([(kept, 2.8e-7), (kept, 0.3)])
    assert "not needed, kept  found 2.8e-07: not needed, as foreseen" in text
    assert "found 0.3: needed after all" in text
    unforeseen = Decision("wall friction", True, None, 0.0, "")
    assert (
        is_confirmed(unforeseen, 0.1) is None and "found 0.1\n" in verified_text([(unforeseen, 0.1)]) + "\n"
    )


def test_damage_that_acts_on_nothing_is_said_to_be_reported_only(copper):
    """The founding card counts damage; with a coupling, or with an erosion that takes something, it acts."""
    told = "reported only: changes no answer"
    assert told in decisions_text([found(copper, "damage")])
    laws = {"damage": copper.material.damage._replace(coupling=0.5)}, {"erosion": ZeroStress()}
    for law in laws:
        acting = replace(copper, material=replace(copper.material, **law))
        assert told not in decisions_text([found(acting, "damage")])
    marked = replace(copper, material=replace(copper.material, erosion=PreserveStress()))
    assert told in decisions_text([found(marked, "damage")])


def test_heating_that_was_left_out_is_missed_by_the_work_that_would_heat(ended):
    """Without heating the mean rise that the plastic work makes stands in for the temperature."""
    ended.scene = replace(ended.scene, material=replace(ended.scene.material, heating=None))
    decision, number = verified(ended)[0]
    mass = 2.0 * 400.0 / ended.scene.bar.velocity**2
    assert number == pytest.approx(0.9 * 150.0 / (mass * 383.0) / (1356.0 - 294.0), rel=0.05)
    assert decision.wanted and is_confirmed(decision, number) is (number >= decision.threshold)


def test_a_failed_run_verifies_nothing(ended):
    """No number is found."""
    ended.failure = RunFailure("gone wrong")
    assert {number for _, number in verified(ended)} == {None}


def test_every_switch_turns_its_effect_round(copper):
    """Switched once, the decision's `on` is the other; a scene without the effect is left alone."""
    for switch in SWITCHES:
        _, switched = switch.switched(copper)
        assert found(switched, switch.effect).on != found(copper, switch.effect).on, switch.effect
    classic = read_scene("taylor-classic")
    none = [switch.effect for switch in SWITCHES if switch.switched(classic) is None]
    assert none == ["damage", "plastic heating", "heat conduction", "equation of state"]
    assert [effect for effect, *_ in planned(classic, "mpm", True)] == [
        AS_IT_IS, "bulk viscosity", "wall friction", "three dimensions",
    ]  # fmt: skip


def switched(effect, length, seconds=1.0):
    """A run whose bar has a length."""
    values = {"final_length": length, "foot_radius": 1.0}
    return Switched(effect, "off", "mpm", Measurement("mpm", 4, values, seconds))


def test_a_wrong_decision_is_said_to_be_wrong(copper):
    """Heating was asked for but changes nothing; conduction was not and changes much."""
    runs = [switched(AS_IT_IS, 1.0), switched("plastic heating", 1.0001), switched("heat conduction", 0.9)]
    rows = {row[0]: row[1:] for row in verdict_table(runs, decisions(copper, "unilateral")).rows}
    assert rows["plastic heating"][2:] == ("no", "cautious: kept for nothing")
    assert rows["heat conduction"][0] == "no" and rows["heat conduction"][2:] == (
        "yes",
        "wrong: it is missing",
    )


def test_the_study_leaves_tables_and_goes_on_after_a_refusal(copper, tmp_path, monkeypatch):
    """Costs relative to the scene as it is, of one run each; what is refused is listed."""

    def measure(scene, variant, resolution, wall, repeats):
        if scene.conduction:
            return Measurement(variant, resolution, message=str(UnsupportedError("no conduction here")))
        return Measurement(variant, resolution, {"final_length": 0.02, "foot_radius": 0.005}, 2.0, steps=9)

    def off(scene, method, resolution, wall):
        return OffCost(method, (1.0, 1.0, 1.3), (1.0, 0.9, 1.1), True)

    monkeypatch.setattr(study, "_measure", measure)
    monkeypatch.setattr(study, "cost_of_off", off)
    outcome = compare_effects(copper, tmp_path / "out", methods=("mpm",), resolution=4)
    assert len(outcome.runs) == 2 + len(SWITCHES)
    assert "mpm: damage off,2.0,1.0" in (tmp_path / "out/changes.csv").read_text()
    assert "Processor seconds of the steps, one run each;" in (tmp_path / "out/report.md").read_text()
    assert "no conduction here" in (tmp_path / "out/failures.csv").read_text()
    assert "mpm,1.0,0.9," in (tmp_path / "out/off.csv").read_text()
    assert json.loads((tmp_path / "out/results.json").read_text())["study"] == "effects"


def test_unknown_methods_are_refused_before_anything_runs(tmp_path, capsys):
    """Status 2 and the nearest name."""
    arguments = ["study", "effects", "taylor-classic", "--methods", "mpn", "--out", str(tmp_path / "out")]
    assert main(arguments) == 2
    assert "mpm" in capsys.readouterr().err and not (tmp_path / "out").exists()


def test_effects_that_are_off_leave_no_trace(copper):
    """With all off no law of an effect is left to be compiled in, though the card keeps its numbers."""
    off, never = all_off(copper), never_had(copper)
    assert off.material.thermal_conductivity and off.material.specific_heat
    assert never.material.thermal_conductivity is None and never.material.specific_heat is None
    slots = ("damage", "erosion", "heating", "damage_radius")
    assert all(getattr(each.material, slot) is None for each in (off, never) for slot in slots)
    assert not (off.conduction or off.viscosity or off.friction)
    cost = OffCost("mpm", (1.2, 1.1, 1.0), (1.0, 1.5, 1.1, 1.4), True)
    assert cost.ratio == 1.0 and cost.noise == pytest.approx(0.1)
