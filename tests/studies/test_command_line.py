"""The command: verbs, options, exit statuses, one-line errors."""

import json
import re
import subprocess
import sys
import time

import pytest

from studies.command_line import VERBS, main
from studies.options import names, whole_numbers
from studies.scenes.shipped import SCENES_FOLDER


def said(capsys):
    """What was printed, and the error line."""
    captured = capsys.readouterr()
    return captured.out, captured.err


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_has_help_with_an_example(verb, capsys):
    """`matpoint VERB --help` explains itself and shows how it is typed."""
    with pytest.raises(SystemExit) as ended:
        main([verb, "--help"])
    out, _ = said(capsys)
    assert ended.value.code == 0
    assert f"matpoint {verb}" in out and "example" in out


def test_help_is_quick():
    """`matpoint --help` imports no compiler."""
    code = """
import sys
from studies.command_line import main
try:
    main(["--help"])
except SystemExit:
    assert "numba" not in sys.modules and "matplotlib" not in sys.modules
"""
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True)
    assert time.perf_counter() - began < 3.0


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["run", "taylor-clasic"], "taylor-classic"),
        (["run", "taylor-classic", "--wal", "plane"], "--wall"),
        (["run", "taylor-classic", "--method", "mpn"], "mpm"),
        (
            ["compare", "taylor-classic", "--methods", ""],
            "no method given; valid: fem-explicit, mpm, each also",
        ),
        (["run", "taylor-classic", "--method", "fem-implicit"], "study necking"),
        (["study", "stability", "--methods", ""], "no method given; valid: fem-explicit, fem-implicit, mpm"),
        (["study", "effects", "taylor-classic", "--methods", ","], "no method given"),
        (["study", "work-precision", "necking-simo", "--methods", ""], "fem-implicit"),
        (["study", "necking", "--methods", ""], "no method given; valid: "),
        (["run", "taylor-classic", "--wall", "plan"], "plane"),
        (["run", "taylor-classic", "--resolution", "x"], "whole numbers"),
        (["run", "taylor-classic", "--resolution", "0"], "cell"),
        (["check", "taylor-classic", "--resolution", "100000"], "GiB of memory"),
        (["run", "taylor-classic", "--out", "x" * 300], "--out"),
        (["run", "taylor-classic", "--resolution", "8,12"], "matpoint compare"),
        (["run", "taylor-classic", "--threads", "0"], "1 or more"),
        (["compare", "no.xml"], "no such file"),
        (["models", "jonson_cook"], "johnson_cook"),
        (["rum"], "did you mean 'run'?"),
        (["study", "experimnts"], "did you mean 'experiments'?"),
        (["run", "taylor-classic", "--checkpoint-every", "-5s"], "10min"),
        ([], "COMMAND"),
    ],
)
def test_bad_input_is_one_line_with_a_remedy_and_status_2(arguments, told, capsys, tmp_path, monkeypatch):
    """Nothing is written, nothing is traced back."""
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 2
    out, err = said(capsys)
    assert out == "" and err.count("\n") == 1 and told in err
    assert list(tmp_path.iterdir()) == []


def test_run_prints_its_table_and_folder(fake_solvers, capsys, tmp_path):
    """Quantities, cost, folder; exit status 0."""
    assert main(["run", "taylor-classic", "--method", "mpm", "--out", str(tmp_path / "out")]) == 0
    out, err = said(capsys)
    assert "final length" in out and out.rstrip().endswith(str(tmp_path / "out")) and err == ""


def test_compare_prints_its_table_and_ends_with_the_report(fake_solvers, capsys, tmp_path):
    """The last line is the path of report.html."""
    arguments = ["compare", "taylor-classic", "--resolution", "8,12", "--out", str(tmp_path / "out")]
    assert main(arguments) == 0
    out, _ = said(capsys)
    assert out.splitlines()[-1] == str(tmp_path / "out" / "report.html")


def test_a_run_that_goes_wrong_ends_with_status_3(fake_solvers, capsys, tmp_path):
    """run and compare say step, time, point and law."""
    assert main(["run", "taylor-classic", "--resolution", "13", "--out", str(tmp_path / "a")]) == 3
    assert "point 1" in said(capsys)[1]
    assert main(["compare", "taylor-classic", "--resolution", "8,13", "--out", str(tmp_path / "b")]) == 3
    assert "point 1" in said(capsys)[0]
    statuses = [run["status"] for run in json.loads((tmp_path / "b/results.json").read_text())["runs"]]
    assert statuses.count("failed") == 2


def test_scenes_are_listed(capsys):
    """Every shipped scene with its description."""
    assert main(["scenes"]) == 0
    out, _ = said(capsys)
    assert "taylor-copper-mts" in out and "208 m/s" in out


def test_models_are_listed_and_explained(capsys):
    """A law's explanation has equation, units and card tags."""
    assert main(["models"]) == 0
    assert "johnson_cook" in said(capsys)[0]
    assert main(["models", "mts_model"]) == 0
    out, _ = said(capsys)
    assert "MechanicalThreshold" in out and "[Pa]" in out and "<mu_0>" in out


def test_check_says_what_would_be_simulated_and_writes_nothing(capsys, tmp_path, monkeypatch):
    """Effects on and off with reasons, material, mesh, estimated steps."""
    monkeypatch.chdir(tmp_path)
    assert main(["check", "taylor-copper-jc", "--resolution", "8"]) == 0
    out, _ = said(capsys)
    assert all(told in out for told in ("JohnsonCook", "wall friction", "frictionless", "mpm 8", "<burn>"))
    assert list(tmp_path.iterdir()) == []


def test_a_package_that_shadows_ours_is_named(monkeypatch, capsys, tmp_path):
    """The command says which package is not ours, instead of failing somewhere inside."""
    stranger = tmp_path / "fem"
    stranger.mkdir()
    (stranger / "__init__.py").write_text("")
    monkeypatch.delitem(sys.modules, "fem", raising=False)
    monkeypatch.syspath_prepend(tmp_path)
    assert main(["scenes"]) == 2
    assert f"{stranger}" in said(capsys)[1]


def test_check_lists_each_run_once(capsys):
    """Repeated methods and resolutions are one run."""
    assert main(["check", "taylor-classic", "--methods", "mpm,mpm", "--resolution", "4,4"]) == 0
    assert said(capsys)[0].count("mpm 4") == 1


def test_lists_hold_everything_once():
    """However often a name or number is given, no study makes a run twice."""
    assert names("mpm, fem-explicit,mpm") == ("mpm", "fem-explicit")
    assert whole_numbers("8,12,8") == (8, 12)


@pytest.mark.parametrize(
    ("before", "after", "remarks"),
    [
        ("", "", []),
        ("<temperature>294<", "<temperature>1400<", ["the bar begins at 1400 K, at or above its melting"]),
        ('latest="150e-6"', 'latest="5e-6"', ["ends at 5e-06 s, before an elastic wave"]),
        (
            'latest="150e-6"',
            'latest="1e-12"',
            ["ends at 1e-12 s, before", "within the first time step, some"],
        ),
        (",-208.0,", ",-8000.0,", ["impact at 8000 m/s is faster than elastic waves, 4"]),
    ],
)
def test_check_remarks_on_what_is_odd(before, after, remarks, capsys, tmp_path):
    """A molten bar, an end before anything happens, an impact above the speed of waves: with their numbers."""
    text = (SCENES_FOLDER / "taylor-copper-jc.xml").read_text()
    assert before in text
    (tmp_path / "odd.xml").write_text(text.replace(before, after) if before else text)
    asked = ["check", str(tmp_path / "odd.xml"), "--resolution", "4"]
    assert main(asked) == 0
    lines = [line for line in said(capsys)[0].splitlines() if line.startswith("remark: ")]
    assert main([*asked, "--json"]) == 0
    assert lines == [f"remark: {each}" for each in json.loads(said(capsys)[0])["remarks"]]
    assert len(lines) == len(remarks) and all(told in line for told, line in zip(remarks, lines, strict=True))


@pytest.mark.parametrize("name", ["IsotropicElastic", "ConstantMelting", "ConstantSpecificHeat"])
def test_models_knows_the_laws_of_plain_tags(name, capsys):
    """Laws without a block in the card are listed and explained too."""
    assert main(["models"]) == 0
    assert name in said(capsys)[0]
    assert main(["models", name]) == 0
    assert "plain tags" in said(capsys)[0]


def test_nonsense_gets_the_list_of_names_and_no_suggestion(capsys):
    """Only a name that is alike is suggested."""
    assert main(["run", "taylor-classic", "--wall", "qqqqq"]) == 2
    _, err = said(capsys)
    assert "did you mean" not in err and "valid: plane, unilateral" in err


@pytest.mark.parametrize(
    ("method", "reason"),
    [
        ("fem-explicit:hex8+nodal-average", "cure 'nodal-average' is void"),
        ("mpm:total+cpdi", "has no need of"),
    ],
)
def test_check_refuses_what_run_would_refuse(capsys, method, reason):
    """Words that do not go together are found before anything runs."""
    assert main(["check", "taylor-classic", "--method", method, "--resolution", "4"]) == 2
    assert reason in said(capsys)[1]


@pytest.mark.parametrize(
    ("arguments", "run", "taken"),
    [
        (["taylor-classic", "--wall", "plane", "--resolution", "6"], "fem-explicit 6", 12656),
        (["taylor-classic", "--resolution", "8"], "mpm 8", 1900),
        (["taylor-copper-jc", "--resolution", "12"], "fem-explicit 12", 4089),
    ],
)
def test_the_estimated_steps_hold_what_runs_have_taken(arguments, run, taken, capsys):
    """A range, since elements are crushed by an amount that nobody knows before; counts of earlier runs."""
    assert main(["check", *arguments]) == 0
    row = next(line for line in said(capsys)[0].splitlines() if line.startswith(run))
    low, high = re.search(r"(\d+) to (\d+)$", row).groups()
    assert int(low) <= taken <= int(high)
