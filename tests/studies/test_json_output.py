"""`--json`: every command that prints results prints one JSON document, whole and nothing else."""

import json

import numpy as np
import pytest

from studies.command_line import VERBS, main
from studies.commands.study import STUDIES
from studies.output.json_output import json_text


def printed(capsys, *arguments):
    """What a command has printed, read as JSON."""
    assert main([*arguments, "--json"]) == 0
    return json.loads(capsys.readouterr().out, parse_constant=pytest.fail)


COMMANDS = [[verb] for verb in VERBS if verb != "study"] + [["study", name] for name in STUDIES]


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_every_command_offers_its_results_as_data(command, capsys):
    """`--json`, examples and exit statuses are in the help of each."""
    with pytest.raises(SystemExit):
        main([*command, "--help"])
    told = capsys.readouterr().out
    assert "--json" in told and "example" in told and "Exit status" in told
    assert "%%" not in told


def test_arrays_laws_and_infinity_become_plain_data():
    """Classes are names, infinite numbers null."""
    content = {"a": np.array([1.0, np.inf]), "b": (int, None), 3: np.float64(2.5)}
    assert json.loads(json_text(content)) == {"a": [1.0, None], "b": ["int", None], "3": 2.5}


def test_scenes_models_and_what_fits_together(capsys):
    """Sizes in SI; every law with its parameters; reasons and remedies."""
    assert printed(capsys, "scenes")[0]["length"] == 32.4e-3
    law = printed(capsys, "models", "johnson_cook")[0]
    assert (law["slot"], law["law"]) == ("flow", "JohnsonCook")
    assert law["parameters"][0]["tag"] == "A" and law["parameters"][0]["unit"] == "Pa"
    assert {"kinematic_hardening", "damage"} <= {each["slot"] for each in printed(capsys, "models")}
    assert {"slot", "why", "remedy"} <= set(printed(capsys, "models", "--compatibility")[0])


def test_what_would_be_simulated(capsys):
    """Laws with their numbers, effects, decisions, runs."""
    plan = printed(capsys, "check", "taylor-copper-jc", "--resolution", "4")
    assert plan["laws"]["JohnsonCook"]["A"] == 89.6e6
    assert [(run["method"], run["points"]) for run in plan["runs"]] == [("fem-explicit", 208), ("mpm", 208)]
    assert {"number", "threshold", "wanted"} <= set(plan["decisions"][0]) and plan["effects"][0]["reason"]


def test_runs_and_comparisons(fake_solvers, capsys, tmp_path):
    """The content of run.json and of results.json, and the folder."""
    run = printed(capsys, "run", "taylor-classic", "--method", "mpm", "--out", str(tmp_path / "a"))
    assert run["quantities"]["final_length"]["value"] > 0.0 and run["folder"] == str(tmp_path / "a")
    out = tmp_path / "b"
    compared = printed(capsys, "compare", "taylor-classic", "--resolution", "8", "--out", str(out))
    assert compared.pop("folder") == str(out)
    assert compared == json.loads((out / "results.json").read_text())


def test_a_driven_point(capsys):
    """The whole history by name and unit."""
    driven = printed(capsys, "drive", "taylor-classic", "--to", "0.01", "--rate", "1", "--steps", "4")
    assert len(driven["history"]["mises [Pa]"]) == 5 and driven["laws"]["LinearHardening"]
