"""CalculiX on a necking bar: its input deck from our mesh, its run, and what it answers."""

import os
import re
import resource
import shutil
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core_models.errors import RunFailure, UnsupportedError
from meshes.mesh import Mesh
from studies.necking.scene import NeckingScene

PROGRAM = "ccx"
_ELEMENTS = {"quad4": "CAX4R", "quad8": "CAX8R"}
_MILLI, _MEGA = 1e3, 1e-6  # the deck is in mm, N and MPa
_STRAINS = np.concatenate([np.linspace(0.0, 1.0, 201), np.linspace(1.25, 6.0, 20)])
_SMALLEST = 1e-8
_FIRST = 0.05  # of an increment


@dataclass(frozen=True)
class CalculixRun:
    """force [N] of the whole bar and neck_radius [m] at elongations [m]; seconds of processor time."""

    elongation: np.ndarray
    force: np.ndarray
    neck_radius: np.ndarray
    seconds: float


def write_deck(path: Path, scene: NeckingScene, mesh: Mesh, increments: int) -> None:
    """Write the deck of a bar, pulled with automatic increments of up to 1 / increments of the pull.

    mesh: of quad4 or quad8 elements, which are taken as CAX4R and CAX8R.
    """
    elastic, flow = scene.material.elasticity, scene.material.flow
    bulk, shear = elastic.bulk_modulus, elastic.shear_modulus
    young = 9.0 * bulk * shear / (3.0 * bulk + shear)
    stress = flow.saturation_stress + flow.linear_modulus * _STRAINS
    stress -= (flow.saturation_stress - flow.yield_stress) * np.exp(-flow.saturation_rate * _STRAINS)
    largest = 1.0 / increments
    lines = [
        "*NODE, NSET=NALL",
        *(f"{i}, {r:.12g}, {z:.12g}, 0" for i, (r, z) in enumerate(_MILLI * mesh.points, 1)),
        f"*ELEMENT, TYPE={_ELEMENTS[mesh.kind]}, ELSET=EALL",
        *(f"{e}, {_numbers(cell + 1)}" for e, cell in enumerate(mesh.cells, 1)),
    ]
    for name in ("neck", "end", "axis"):
        lines += [f"*NSET, NSET={name.upper()}", *(f"{i + 1}," for i in np.unique(mesh.boundaries[name]))]
    lines += [
        "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{_MEGA * young:.10g}, {young / (2.0 * shear) - 1.0:.10g}",
        "*PLASTIC", *(f"{_MEGA * s:.10g}, {p:.10g}" for s, p in zip(stress, _STRAINS, strict=True)),
        "*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL",
        "*BOUNDARY", "NECK, 2, 2", "AXIS, 1, 1",
        "*STEP, NLGEOM, INC=5000", "*STATIC", f"{_FIRST * largest:g}, 1., {_SMALLEST:g}, {largest:g}",
        "*BOUNDARY", f"END, 2, 2, {_MILLI * scene.pull:.10g}",
        "*NODE PRINT, NSET=END, TOTALS=ONLY", "RF", "*NODE PRINT, NSET=NECK", "U", "*END STEP",
    ]  # fmt: skip
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def _numbers(values: Iterable[int]) -> str:
    return ", ".join(str(value) for value in values)


def run_calculix(folder: Path, scene: NeckingScene, mesh: Mesh, increments: int) -> CalculixRun:
    """Run CalculiX in a folder; UnsupportedError where it is not installed, RunFailure where it does not finish."""
    if shutil.which(PROGRAM) is None:
        raise UnsupportedError(
            f"CalculiX is not installed: no program is called {PROGRAM!r} (Debian: calculix-ccx)"
        )
    write_deck(folder / "bar.inp", scene, mesh, increments)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = subprocess.run(
        [PROGRAM, "bar"],
        cwd=folder,
        capture_output=True,
        text=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if ended.returncode != 0 or "Job finished" not in ended.stdout:
        raise RunFailure(
            f"CalculiX did not finish the bar; what it printed ends with {ended.stdout[-200:]!r}"
        )
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return _read(folder / "bar.dat", scene, mesh, seconds)


def _read(path: Path, scene: NeckingScene, mesh: Mesh, seconds: float) -> CalculixRun:
    neck = np.unique(mesh.boundaries["neck"])
    rim = int(neck[mesh.points[neck, 0].argmax()])
    text = path.read_text(encoding="ascii")
    times = [float(each) for each in re.findall(r"set END and time\s+(\S+)", text)]
    forces = [float(line.split()[1]) for line in re.findall(r"total force.*\n\n(.*)\n", text)]
    moved = [float(each) for each in re.findall(rf"^\s+{rim + 1}\s+(\S+)", text, re.MULTILINE)]
    radius = float(mesh.points[rim, 0]) + np.array(moved) / _MILLI
    return CalculixRun(scene.pull * np.array(times), np.array(forces), radius, seconds)
