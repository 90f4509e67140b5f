"""The gmsh mesh of a Taylor bar."""

import math
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core_models.errors import MeshError
from meshes.quality import quality
from meshes.taylor_bar import taylor_bar

RADIUS, LENGTH = 3.2e-3, 32.4e-3  # m
sizes = st.floats(1e-4, 1.0)


@settings(max_examples=15, deadline=None)
@given(sizes, sizes, st.integers(1, 8), st.integers(1, 12), st.floats(0.2, 5.0))
def test_volume_of_the_full_turn_is_the_cylinders(radius, length, across, along, grading):
    """The mesh fills the cylinder exactly, whatever its size, resolution and grading."""
    mesh = taylor_bar(radius, length, across, along, grading)
    assert quality(mesh).turn == pytest.approx(math.pi * radius**2 * length, rel=1e-12)
    assert len(mesh.cells) == across * along


@settings(max_examples=15, deadline=None)
@given(st.integers(1, 6), st.integers(2, 12), st.floats(0.2, 5.0))
def test_grading_is_the_ratio_of_axial_sizes_foot_to_rear(across, along, grading):
    """`grading` is the axial size at the foot by that at the rear; sizes between follow a progression."""
    heights = np.unique(taylor_bar(RADIUS, LENGTH, across, along, grading).points[:: across + 1, 1])
    sizes = np.diff(heights)
    assert sizes[0] / sizes[-1] == pytest.approx(grading, rel=1e-5)
    assert np.ptp(np.diff(np.log(sizes))) < 1e-5


@settings(max_examples=10, deadline=None)
@given(st.integers(1, 6), st.integers(1, 12))
def test_boundaries_are_one_loop_round_the_body(across, along):
    """Foot, side, rear and axis follow each other head to tail, counter-clockwise, from the foot's centre."""
    mesh = taylor_bar(RADIUS, LENGTH, across, along)
    loop = np.concatenate([mesh.boundaries[name] for name in ("foot", "side", "rear", "axis")])
    assert (loop[:, 1] == np.roll(loop[:, 0], -1)).all()
    starts = {name: mesh.points[pairs[0, 0]].tolist() for name, pairs in mesh.boundaries.items()}
    assert starts == {"foot": [0, 0], "side": [RADIUS, 0], "rear": [RADIUS, LENGTH], "axis": [0, LENGTH]}


def test_default_elements_are_square():
    """Without `elements_along`, elements are as square as a whole number of them allows."""
    figures = quality(taylor_bar(RADIUS, LENGTH, 8))
    assert figures.elements == 8 * 81
    assert figures.max_aspect_ratio == pytest.approx(1.0, abs=1e-9)
    assert figures.min_scaled_jacobian == pytest.approx(1.0, abs=1e-9)


def test_foot_height_lifts_the_bar():
    """`foot_height` is the z of the foot; nothing else changes."""
    low, high = taylor_bar(RADIUS, LENGTH, 2, 4), taylor_bar(RADIUS, LENGTH, 2, 4, foot_height=1e-3)
    assert np.array_equal(high.points, low.points + [0.0, 1e-3])
    assert np.array_equal(high.cells, low.cells)


def test_elements_and_nodes_are_numbered_row_by_row():
    """Neighbours in space are neighbours in memory, and an element starts at its lower inner corner."""
    mesh = taylor_bar(RADIUS, LENGTH, 3, 2)
    assert mesh.cells.tolist()[:4] == [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [4, 5, 9, 8]]


def test_same_parameters_give_the_same_mesh_bitwise():
    """Two calls, and a call from another thread, give bitwise equal meshes."""
    meshes = []
    thread = threading.Thread(target=lambda: meshes.append(taylor_bar(RADIUS, LENGTH, 5, 9, 2.0)))
    thread.start()
    thread.join()
    meshes += [taylor_bar(RADIUS, LENGTH, 5, 9, 2.0) for _ in range(2)]
    assert all(mesh.points.tobytes() == meshes[0].points.tobytes() for mesh in meshes)


def test_finest_bar_in_use_takes_less_than_a_second():
    """64 elements across (41,472 in all) are meshed and checked within a second."""
    taylor_bar(RADIUS, LENGTH, 1)
    start = time.process_time()
    taylor_bar(RADIUS, LENGTH, 64)
    assert time.process_time() - start < 1.0


def test_gmsh_models_of_the_caller_are_kept():
    """A gmsh that is open already keeps its models, current model and options; no signal handler changes."""
    import gmsh

    handler = signal.getsignal(signal.SIGINT)
    gmsh.initialize([], interruptible=False)
    try:
        gmsh.model.add("mine")
        gmsh.model.add("other")
        gmsh.model.setCurrent("mine")
        gmsh.option.setNumber("General.Terminal", 1)
        models = gmsh.model.list()
        taylor_bar(RADIUS, LENGTH, 2, 2)
        assert (gmsh.model.list(), gmsh.model.getCurrent()) == (models, "mine")
        assert gmsh.option.getNumber("General.Terminal") == 1
    finally:
        gmsh.finalize()
    taylor_bar(RADIUS, LENGTH, 2, 2)
    assert not gmsh.isInitialized()
    assert signal.getsignal(signal.SIGINT) is handler


def test_meshing_prints_nothing():
    """gmsh writes neither to standard output nor to standard error."""
    code = "from meshes.taylor_bar import taylor_bar; taylor_bar(1.0, 2.0, 4)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True)
    assert (done.stdout, done.stderr) == (b"", b"")


@pytest.mark.parametrize(
    ("wrong", "name"),
    [
        ({"radius": -1.0}, "radius"),
        ({"radius": math.nan}, "radius"),
        ({"length": 0.0}, "length"),
        ({"elements_across": 0}, "elements_across"),
        ({"elements_along": 0}, "elements_along"),
        ({"elements_across": 2.5}, "elements_across"),
        ({"grading": 0.0}, "grading"),
        ({"grading": 101.0}, "grading"),
        ({"grading": math.nan}, "grading"),
        ({"foot_height": math.inf}, "foot_height"),
    ],
)
def test_senseless_parameters_are_refused_by_name(wrong, name):
    """A parameter outside its range is a one-line MeshError that names it and its value."""
    with pytest.raises(MeshError, match=rf"{name} is .*; give") as caught:
        taylor_bar(**{"radius": RADIUS, "length": LENGTH, "elements_across": 4} | wrong)
    assert "\n" not in str(caught.value)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="needs Linux's account of signals")
@pytest.mark.parametrize("number", [signal.SIGPIPE, signal.SIGTERM, signal.SIGINT])
def test_signals_are_after_meshing_what_they_were(number):
    """gmsh would let a closed pipe and SIGTERM end the process without a word, and Python would not know."""

    def listed():
        status = Path("/proc/self/status").read_text()
        return [int(status.split(of)[1].split()[0], 16) >> (number - 1) & 1 for of in ("SigIgn:", "SigCgt:")]

    before = signal.getsignal(number)
    for handler in (signal.SIG_IGN, lambda *received: None):
        signal.signal(number, handler)
        try:
            expected = listed()
            taylor_bar(1.0, 3.0, 3)
            assert listed() == expected and any(expected)
        finally:
            signal.signal(number, before)
