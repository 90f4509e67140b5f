"""What `matpoint drive` does: a material and a loading program from options, and the history they give."""

import argparse
from dataclasses import dataclass

from core_models.driver import History, drive_program, isothermal
from core_models.errors import SceneError
from core_models.loading_program import Program
from core_models.material import Material
from studies.drive.paths import DrivePath, find_path
from studies.drive.segments import read_segment
from studies.scenes.material_finder import find_material, with_update


@dataclass(frozen=True)
class MaterialTest:
    """A material, what is done to it, from which temperature [K], and in words; no path: segments of the user's own."""

    material: Material
    program: Program
    temperature: float
    words: str
    path: DrivePath | None


@dataclass(frozen=True)
class DriveResult:
    """A test and what the point went through."""

    test: MaterialTest
    history: History


def carry_out(test: MaterialTest) -> DriveResult:
    """Lead a point through the test. Raises RunFailure naming the step that it cannot follow."""
    return DriveResult(test, drive_program(test.material, test.program, temperature=test.temperature))


def asked_test(options: argparse.Namespace) -> MaterialTest:
    """The test that the options of the command ask for. Raises SceneError naming what does not fit."""
    path, program, words = _asked_segments(options) if options.segment else _asked_path(options)
    material, temperature = find_material(options.material, options.search_root, options.laws)
    if options.update is not None:
        material = with_update(material, options.update)
    if options.temperature is not None:
        temperature = _checked_temperature(options.temperature, material)
    if options.isothermal:
        material = isothermal(material)
    return MaterialTest(material, program, temperature, words, path)


def _asked_path(options: argparse.Namespace) -> tuple[DrivePath, Program, str]:
    name = options.path or "uniaxial-stress"
    path = find_path(name)
    for option in ("to", "rate"):
        if getattr(options, option) is None:
            raise SceneError(f"--{option} is missing: say e.g. --to 0.3 --rate 1000 (or give --segment)")
    cycles = {} if options.cycles is None else {"cycles": options.cycles}
    program = path.make(options.to, options.rate, steps=options.steps, **cycles)
    rates = ", ".join(f"{rate:g}" for rate in options.rate)
    words = f"{name}, {path.strain} to {options.to:g} at {rates} /s"
    ways = len(program.segments) // len(options.rate)
    if ways > 1:
        words += f", {(ways - 1) // 2} cycle{'s' if ways > 3 else ''}"
    if options.hold is not None:
        program, words = (
            program.then_hold(options.hold, options.steps),
            f"{words}, held for {options.hold:g} s",
        )
    return path, program, words


def _asked_segments(options: argparse.Namespace) -> tuple[None, Program, str]:
    for option in ("path", "to", "rate", "cycles", "hold"):
        if getattr(options, option) is not None:
            raise SceneError(
                f"--{option} stands beside --segment: a program is made of segments, or is a path"
            )
    program = Program([read_segment(text, options.steps) for text in options.segment])
    return None, program, "; ".join(options.segment)


def _checked_temperature(temperature: float, material: Material) -> float:
    if not temperature > 0.0:
        raise SceneError(f"a temperature must be positive, not {temperature:g} K")
    if not material.needs_temperature:
        raise SceneError(f"{material.name} has no law that feels a temperature: leave --temperature out")
    return temperature
