"""What necking costs beside CalculiX: the deck is our bar, its answers are read, and without it that is said."""

import shutil

import numpy as np
import pytest

from core_models.errors import SceneError
from meshes.necking_bar import necking_bar
from studies.necking.reader import read_necking_scene
from studies.necking_cost import beside_calculix
from studies.necking_cost.beside_calculix import theirs
from studies.necking_cost.calculix import PROGRAM, write_deck
from studies.verification.study import find_problem

SCENE = read_necking_scene("necking-simo")


def mesh(across, along):
    """Second-order elements of the bar."""
    return necking_bar(SCENE.radius, SCENE.length, across, along, SCENE.taper, kind="quad8")


def section(lines, head):
    """Numbers (rows, columns) that follow the keyword line which starts with `head`."""
    first = next(i for i, line in enumerate(lines) if line.startswith(head)) + 1
    last = next((i for i in range(first, len(lines)) if lines[i].startswith("*")), len(lines))
    return np.array([[float(each) for each in line.split(",") if each.strip()] for line in lines[first:last]])


def test_deck_is_our_bar(tmp_path):
    """Nodes in mm, elements in the same order, Hooke's constants in MPa, flow stress at its plastic strains."""
    body = mesh(2, 4)
    write_deck(tmp_path / "bar.inp", SCENE, body, 50)
    lines = (tmp_path / "bar.inp").read_text(encoding="ascii").splitlines()
    assert 1e-3 * section(lines, "*NODE, NSET")[:, 1:3] == pytest.approx(body.points, abs=1e-12)
    assert (section(lines, "*ELEMENT")[:, 1:] == body.cells + 1).all()
    assert section(lines, "*ELASTIC")[0] == pytest.approx([206.9e3, 0.29], rel=1e-4)
    stress, strain = section(lines, "*PLASTIC").T
    assert stress[0] == 450.0 and stress[strain == 1.0] == pytest.approx(715.0 + 129.24, rel=1e-6)
    assert (np.unique(body.boundaries["neck"]) + 1 == section(lines, "*NSET, NSET=NECK")[:, 0]).all()


@pytest.mark.skipif(shutil.which(PROGRAM) is None, reason="CalculiX is not installed")
def test_answers_of_calculix_are_read():
    """On a coarse mesh the peak is that of the bar, 77.4 kN, and time is measured."""
    answer = theirs(SCENE, mesh(2, 4), 20)
    assert answer.peak == pytest.approx(77.4e3, rel=0.01) and answer.seconds > 0.0
    assert answer.increments >= 20 and 4e-3 < answer.neck < 6e-3


def test_without_calculix_the_criterion_says_so(monkeypatch):
    """It is not met, and the reason names the package."""
    monkeypatch.setattr("studies.necking_cost.calculix.shutil.which", lambda name: None)
    (criterion,) = beside_calculix.run(True).criteria
    assert not criterion.met and "calculix-ccx" in criterion.reason


def test_problems_of_the_study_are_found_by_name():
    """As those of the other studies are; the nearest name is told."""
    assert find_problem("calculix").name == "calculix" and find_problem("dofs").name == "dofs"
    with pytest.raises(SceneError, match="dofs"):
        find_problem("dof")
