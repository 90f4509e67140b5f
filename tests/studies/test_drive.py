"""`matpoint drive`: what it prints and writes, and what it refuses."""

import argparse
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core_models.cards import read_material
from core_models.driver import History, drive_program
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.errors import SceneError
from core_models.flow.thermal_voce import ThermalVoce
from core_models.loading import Deformation, Stress, Stretch, VelocityGradient
from core_models.loading_paths import uniaxial_stress
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from studies.command_line import main
from studies.commands.drive import add_options
from studies.drive.driving import DriveResult, asked_test
from studies.drive.segments import read_segment
from studies.drive.text import remarks
from studies.options import Parser
from studies.scenes.material_finder import find_material, with_update
from studies.scenes.reader import read_scene

PULL = ["--to", "0.1", "--rate", "1e3", "--steps", "20"]


def asked(*arguments):
    """The test that the options of a command ask for."""
    parser = Parser(prog="drive")
    add_options(parser)
    return asked_test(parser.parse_args(list(arguments)))


def test_drive_prints_the_test_the_table_and_the_final_state(capsys):
    """Laws, path, heat; strain, stresses, plastic strain and temperature; the state at the end."""
    assert main(["drive", "taylor-copper-jc", *PULL]) == 0
    out = capsys.readouterr().out
    history = drive_program(read_scene("taylor-copper-jc").material, uniaxial_stress(0.1, 1e3, steps=20))
    for told in (
        "JohnsonCook",
        "uniaxial-stress",
        "at 1000 /s",
        "20 steps in 0.0001 s, from 294 K, adiabatic",
    ):
        assert told in out
    row = next(line for line in out.splitlines() if line.startswith("0.0001 ")).split()
    end = history.stress[-1, 0] / 1e6
    state = [history.fields[name][-1] for name in ("equivalent_plastic_strain", "temperature", "damage")]
    expected = [1e-4, 0.1, end, end, -end / 3.0, *state]
    assert [float(word) for word in row] == pytest.approx(expected, rel=1e-4)
    assert "final state" in out and "volume ratio J" in out


def test_csv_holds_the_whole_history_with_units(tmp_path, capsys):
    """A header of names with SI units, a row per step, all fields of the points."""
    file = tmp_path / "history.csv"
    assert main(["drive", "taylor-copper-jc", *PULL, "--csv", str(file)]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == str(file)
    header, *rows = file.read_text().splitlines()
    values = np.array([[float(word) for word in row.split(",")] for row in rows])
    columns = dict(zip(header.split(","), values.T, strict=True))
    history = drive_program(read_scene("taylor-copper-jc").material, uniaxial_stress(0.1, 1e3, steps=20))
    assert len(rows) == 21
    for name, expected in {
        "time [s]": history.times,
        "deformation_gradient_22 [1]": history.deformation_gradient[:, 1, 1],
        "stress_11 [Pa]": history.stress[:, 0],
        "mises [Pa]": history.mises,
        "temperature [K]": history.fields["temperature"],
        "internal_energy [J/m^3]": history.fields["internal_energy"],
        "plastic_dissipation [J/m^3]": history.plastic,
        "wave_speed [m/s]": history.wave_speed,
    }.items():
        assert columns[name] == pytest.approx(expected, rel=1e-9, abs=1e-9), name


@pytest.mark.parametrize(("ending", "begin"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")])
def test_plots_are_pictures_of_their_kind(tmp_path, ending, begin):
    """By the file's ending."""
    file = tmp_path / f"history.{ending}"
    assert main(["drive", "taylor-copper-jc", *PULL, "--plot", str(file)]) == 0
    assert file.read_bytes().startswith(begin)


def test_a_plot_names_what_it_shows_and_is_the_same_each_time(tmp_path):
    """Titles, axes and lines as text; no date in the file."""
    files = [tmp_path / name for name in ("a.svg", "b.svg")]
    for file in files:
        assert main(["drive", "taylor-copper-jc", *PULL, "--plot", str(file)]) == 0
    assert files[0].read_bytes() == files[1].read_bytes()
    text = files[0].read_text()
    assert all(told in text for told in ("Stress [MPa]", "Temperature K", "true strain 11", "von Mises"))


def test_out_keeps_card_history_picture_and_summary(tmp_path, capsys):
    """The card reads back as the material that was driven, whatever the options changed."""
    folder = tmp_path / "out"
    arguments = ["drive", "taylor-copper-jc", *PULL, "--update", "hyperelastic", "--out", str(folder)]
    assert main(arguments) == 0
    assert {path.name for path in folder.iterdir()} == {
        "history.csv",
        "history.svg",
        "material.xml",
        "summary.txt",
    }
    out = capsys.readouterr().out
    assert out == (folder / "summary.txt").read_text() + f"{folder}\n"
    assert read_material(folder / "material.xml").material == asked(*arguments[1:-2]).material
    assert main(arguments) == 2
    assert "not empty" in capsys.readouterr().err


def test_materials_come_from_scenes_cards_and_files(tmp_path):
    """A scene begins at its bar's temperature, a card at room temperature, an option overrides both."""
    scene = read_scene("taylor-ofhc-190")
    assert find_material("taylor-ofhc-190") == (scene.material, scene.bar.temperature)
    card, temperature = find_material("copper_hypoelastic_johnson_cook")
    assert temperature == card.room_temperature
    assert asked("taylor-copper-jc", *PULL, "--temperature", "500").temperature == 500.0
    with pytest.raises(SceneError, match="did you mean 'taylor-copper-jc'"):
        find_material("taylor-coper-jc")


def test_update_and_isothermal_change_the_material_only_so_far():
    """All other laws are the card's; the default equation of state gets its hyperelastic partner."""
    material = asked("taylor-copper-jc", *PULL, "--isothermal", "--update", "hyperelastic").material
    card = read_scene("taylor-copper-jc").material
    assert (material.update, material.heating) == (HyperelasticPlastic(card.update.tolerance), None)
    assert (material.flow, material.eos, material.specific_heat) == (card.flow, card.eos, card.specific_heat)
    classic = read_scene("taylor-classic").material
    hypo = with_update(classic, "hypoelastic_plastic")
    assert isinstance(hypo.update, HypoelasticPlastic) and hypo.eos == classic.eos
    plain = type(classic)(**vars(hypo) | {"eos": DefaultHypoelastic(1.3e11)})
    assert with_update(plain, "hyperelastic").eos == NeoHookean(1.3e11)
    assert with_update(classic, "hyperelastic") is classic


def test_segments_are_programs_of_any_mix():
    """Durations and prescribed components, one segment after the other."""
    segment = read_segment("1e-3 stretch11=1.1, F12=0.2 L21=-3e2 stress33=-50e6", 7)
    assert (segment.duration, segment.steps) == (1e-3, 7)
    assert segment.controls == {
        "11": Stretch(1.1),
        "12": Deformation(0.2),
        "21": VelocityGradient(-300.0),
        "33": Stress(-50e6),
    }
    test = asked("taylor-classic", "--segment", "1 F11=1.01", "--segment", "2 stress11=0", "--steps", "4")
    assert [part.duration for part in test.program.segments] == [1.0, 2.0]
    assert len(test.program.time_steps) == 8


def test_a_table_of_many_cycles_stays_short(capsys):
    """Some ends of ways, not thousands of rows; the first and the last among them."""
    assert main(["drive", "taylor-copper-jc", "--path", "cyclic", "--to", "4e-3", "--rate", "1e3", "--steps", "4",
                 "--cycles", "60"]) == 0  # fmt: skip
    out = capsys.readouterr().out
    assert "60 cycles" in out and len(out.splitlines()) < 50


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--to", "0.3", "--rate", "1", "--temperature", "1400"], "has melted at t = 0 s, 1400 K"),
        (["--to", "1e-4", "--rate", "1"], "has not yielded"),
        (["--to", "2.8", "--rate", "1"], "damage has reached 1 at t = 2."),
        (["--to", "-3e-4", "--rate", "1"], "-0.0003"),
    ],
)
def test_remarks_tell_what_a_table_hides(arguments, told, capsys):
    """Melting, failure, and a point that has stayed elastic; numbers with exponents are numbers, also negative ones."""
    assert main(["drive", "taylor-copper-jc", *arguments]) == 0
    assert told in capsys.readouterr().out


def test_remarks_tell_that_heat_has_taken_the_strength():
    """Without a melting law too: Voce's flow stress with thermal softening of 0.002 /K is gone 500 K above T_0."""
    test = asked("copper_ofhc_johnson_cook", "--to", "0.1", "--rate", "1")
    flow = ThermalVoce(450e6, 715e6, 16.93, 129.24e6, 0.002, 0.002, 294.0)
    test = replace(test, material=replace(test.material, flow=flow, melting=None))
    fields = {
        "equivalent_plastic_strain": np.array([0.0, 0.1, 0.2]),
        "temperature": np.array([294.0, 700.0, 800.0]),
    }
    history = History(np.arange(3.0), fields, *np.zeros((4, 3)))
    assert list(remarks(DriveResult(test, history))) == [
        "heat has taken all strength at t = 2 s, 800 K: there the flow law gives no stress"
    ]


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["taylor-coper-jc", *PULL], "did you mean 'taylor-copper-jc'?"),
        (["no.xml", *PULL], "no such file"),
        (["taylor-copper-jc", *PULL, "--path", "uniaxal-stress"], "did you mean 'uniaxial-stress'?"),
        (["taylor-copper-jc", *PULL, "--stps", "3"], "did you mean '--steps'?"),
        (["taylor-copper-jc", "--to", "0.1"], "--rate is missing"),
        (["taylor-copper-jc", "--rate", "1"], "--to is missing"),
        (["taylor-copper-jc", "--to", "0.1", "--rate", "0"], "positive, not 0.0 /s"),
        (["taylor-copper-jc", "--to", "0.1", "--rate", "1e3,-2"], "-2.0 /s"),
        (["taylor-copper-jc", "--to", "0", "--rate", "1"], "other than 0"),
        (["taylor-copper-jc", "--to", "much", "--rate", "1"], "'much' is not a number"),
        (["taylor-copper-jc", "--to", "90", "--rate", "1"], "take 180 steps or more"),
        (["taylor-copper-jc", *PULL, "--cycles", "-1"], "0 or more"),
        (["taylor-copper-jc", *PULL, "--hold", "-1"], "positive time, not -1.0 s"),
        (["taylor-copper-jc", *PULL, "--temperature", "-1"], "positive, not -1 K"),
        (["taylor-classic", *PULL, "--temperature", "400"], "leave --temperature out"),
        (["taylor-copper-jc", *PULL, "--update", "hyperelstic"], "did you mean 'hyperelastic'?"),
        (["taylor-copper-jc", *PULL, "--plot", "a.jpg"], ".pdf, .png, .svg"),
        (["taylor-copper-jc", *PULL, "--csv", "none/a.csv"], "there is no folder none"),
        (["taylor-copper-jc", *PULL, "--segment", "1 F11=1.1"], "--to stands beside --segment"),
        (["taylor-copper-jc", "--segment", "1 strss11=1"], "did you mean 'stress'?"),
        (["taylor-copper-jc", "--segment", "1 stress14=1"], "two digits from 1 to 3"),
        (["taylor-copper-jc", "--segment", "1 stress11=high"], "value of stress11, 'high', is no number"),
        (["taylor-copper-jc", "--segment", "F11=1.1"], "the duration, 'F11=1.1', is no number"),
        (["taylor-copper-jc", "--segment", "1 F11"], "'F11' cannot be read"),
        (["taylor-copper-jc", "--segment", "1 F11=1.1 stress11=0"], "11 is prescribed twice"),
        (["taylor-copper-jc", "--segment", "1 stretch11=-0.2"], "a stretch must be positive, not -0.2"),
    ],
)
def test_bad_input_is_one_line_with_a_remedy_and_status_2(arguments, told, capsys, tmp_path, monkeypatch):
    """Nothing is computed or written."""
    monkeypatch.chdir(tmp_path)
    assert main(["drive", *arguments]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and captured.err.count("\n") == 1 and told in captured.err
    assert list(tmp_path.iterdir()) == []


def test_a_stress_that_cannot_be_carried_ends_with_status_3(capsys, tmp_path):
    """Step, components and what is missed; no file."""
    arguments = ["taylor-copper-jc", "--segment", "1 stress11=3e9 stress22=0 stress33=0", "--steps", "20"]
    assert main(["drive", *arguments, "--csv", str(tmp_path / "a.csv")]) == 3
    captured = capsys.readouterr()
    assert captured.out == "" and "is missed by" in captured.err and "stress 11" in captured.err
    assert list(tmp_path.iterdir()) == []


def test_numbers_are_read_once():
    """Options hold numbers, not words."""
    parser = argparse.ArgumentParser()
    add_options(parser)
    options = parser.parse_args(["copper", "--to", "0.3", "--rate", "1,1e4"])
    assert (options.to, options.rate, options.steps) == (0.3, (1.0, 1e4), 100)


def test_the_document_s_example_runs(capsys):
    """docs/driver.md shows Python that works."""
    text = (Path(__file__).parents[2] / "docs" / "driver.md").read_text(encoding="utf-8")
    names = {}
    exec(re.search(r"```python\n(.*?)```", text, re.DOTALL)[1], names)
    assert float(capsys.readouterr().out.split()[1]) > 400.0
    assert names["history"].stress[-1, [0, 3]] == pytest.approx([200e6, 30e6], rel=1e-8)
