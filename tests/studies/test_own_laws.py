"""Laws of a user's own, from the documented example to a run: each test in a process of its own."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from studies.scenes.shipped import SCENES_FOLDER

ROOT = Path(__file__).resolve().parents[2]
FLOW = re.compile(r"<plasticity_model.*?</plasticity_model>", re.S)
LUDWIK = '<plasticity_model type="ludwik"><sigma_0>90e6</sigma_0><k>290e6</k><n>0.31</n></plasticity_model>'


@pytest.fixture
def folder(tmp_path):
    """A folder with the example of docs/command-line.md as my_laws.py."""
    example = re.search(r"```python\n(.*?)```", (ROOT / "docs/command-line.md").read_text(), re.S)
    (tmp_path / "my_laws.py").write_text(example[1])
    return tmp_path


@pytest.fixture
def scene(folder):
    """A short scene of the classic bar whose card names the law."""
    text = FLOW.sub(LUDWIK, (SCENES_FOLDER / "taylor-classic.xml").read_text())
    text = re.sub(r"<reference.*?/>", "", text, flags=re.S)
    text = text.replace("<material>", '<laws href="my_laws.py"/><material>', 1)
    path = folder / "scene.xml"
    path.write_text(text.replace('time="80e-6"', 'time="1e-6"'))
    return path


def matpoint(*arguments):
    """Run the command."""
    command = [sys.executable, "-m", "studies", *map(str, arguments)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


def test_a_scene_with_its_own_law_runs_by_both_methods(scene, folder):
    """The card names the law, both methods run it, and the kept scene reads back with it."""
    ended = matpoint("compare", scene, "--resolution", "2", "--out", folder / "out")
    assert ended.returncode == 0, ended.stderr
    for run in ("fem-explicit-2", "mpm-2"):
        kept = matpoint("check", folder / "out" / run / "scene.xml")
        assert kept.returncode == 0 and "Ludwik(yield_stress 9e+07" in kept.stdout


def test_models_shows_a_law_of_ones_own(folder):
    """The list has it, and its explanation has docstring, tags and units."""
    laws = ("--laws", folder / "my_laws.py")
    assert "ludwik" in matpoint("models", *laws).stdout
    told = matpoint("models", "ludwik", *laws).stdout
    assert "Ludwik hardening" in told and "<sigma_0>" in told and "[Pa]" in told


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('types=("ludwik",)', 'types=("voce",)', "'voce' is taken"),
        ('types=("ludwik",)', 'types=("anand",)', "'anand' is taken"),
        ('feeds="exponent"', 'feeds="exponant"', "give each field one Parameter"),
        ('    "flow",\n', '    "flaw",\n', "did you mean 'flow'"),
    ],
)
def test_a_schema_that_does_not_fit_is_refused(folder, old, new, told):
    """One line that says what to change."""
    laws = folder / "my_laws.py"
    assert laws.read_text().count(old) == 1
    laws.write_text(laws.read_text().replace(old, new))
    ended = matpoint("models", "--laws", laws)
    assert ended.returncode == 2 and told in ended.stderr and ended.stderr.count("\n") == 1
