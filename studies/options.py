"""Options that several commands share, and a parser whose errors are one line with the nearest valid name."""

import argparse
import math
import re
from typing import Any, NoReturn, TextIO


class Parser(argparse.ArgumentParser):
    """Full option names only; raises SceneError where argparse would print its usage and exit."""

    def __init__(self, **settings) -> None:
        super().__init__(allow_abbrev=False, **settings)
        # argparse takes -0.3 for a number, but -3e-1, -4,6,8 and -5s for options; none of ours begins with a digit
        self._negative_number_matcher = re.compile(r"-\.?\d")

    @property
    def option_names(self) -> list[str]:
        """All options, as typed."""
        return [name for action in self._actions for name in action.option_strings]

    def parse(self, arguments: list[str]) -> argparse.Namespace:
        """Parse, refusing unknown options by name."""
        namespace, unknown = self.parse_known_args(arguments)
        if unknown:
            from core_models.names import suggestion

            self.error(f"unknown option '{unknown[0]}'; {suggestion(unknown[0], namespace.known_options)}")
        return namespace

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            from core_models.names import suggestion

            raise argparse.ArgumentError(action, f"unknown '{value}'; {suggestion(value, action.choices)}")

    def print_help(self, file: TextIO | None = None) -> None:
        """Print it; OSError, which argparse swallows, where it cannot be written."""
        print(self.format_help(), end="", file=file, flush=True)

    def error(self, message: str) -> NoReturn:
        """One line, as a SceneError."""
        from core_models.errors import SceneError

        raise SceneError(message)


def whole_numbers(text: str) -> tuple[int, ...]:
    """Whole numbers separated by commas, each once."""
    words = text.split(",")
    if not all(re.fullmatch("[0-9]{1,9}", word) for word in words):
        raise argparse.ArgumentTypeError(f"'{text}' is not a list of whole numbers like 8,12,16")
    return tuple(dict.fromkeys(int(word) for word in words))


def positive(text: str) -> int:
    """A whole number of at least 1."""
    if not re.fullmatch("[0-9]{1,9}", text) or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number of 1 or more")
    return int(text)


def whole(text: str) -> int:
    """A whole number of at least 0."""
    if not re.fullmatch("[0-9]{1,9}", text):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number of 0 or more")
    return int(text)


def number(text: str) -> float:
    """A finite number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"'{text}' is not a number like 0.3 or 1e3")
    return value


def numbers(text: str) -> tuple[float, ...]:
    """Numbers separated by commas."""
    return tuple(number(word) for word in text.split(","))


def names(text: str) -> tuple[str, ...]:
    """Names separated by commas, each once."""
    return tuple(dict.fromkeys(word.strip() for word in text.split(",")))


def add_scene_options(parser: argparse.ArgumentParser, *, optional: bool = False) -> None:
    """The scene, which may be left out where it is optional, and where its includes and laws are found."""
    parser.add_argument(
        "scene",
        metavar="SCENE",
        nargs="?" if optional else None,
        help="a shipped scene's name (matpoint scenes) or an XML file",
    )
    parser.add_argument(
        "--search-root",
        metavar="DIR",
        action="append",
        default=[],
        help="folder in which includes are looked for",
    )
    parser.add_argument("--laws", metavar="FILE", help="Python file with laws of your own")


def add_material_options(parser: argparse.ArgumentParser) -> None:
    """The material and where its includes and laws are found."""
    parser.add_argument(
        "material",
        metavar="MATERIAL",
        help="a shipped material's or scene's name, or the XML file of a card or a scene",
    )
    parser.add_argument(
        "--search-root",
        metavar="DIR",
        action="append",
        default=[],
        help="folder in which includes are looked for",
    )
    parser.add_argument("--laws", metavar="FILE", help="Python file with laws of your own")


def add_method_options(parser: argparse.ArgumentParser) -> None:
    """Method, resolution, wall, threads, output."""
    parser.add_argument(
        "--method",
        "--methods",
        dest="methods",
        metavar="A[,B]",
        type=names,
        help="fem-explicit, mpm, or variants like mpm:cubic",
    )
    parser.add_argument(
        "--resolution", metavar="N[,N...]", type=whole_numbers, help="elements or cells across the radius"
    )
    parser.add_argument("--wall", metavar="NAME", help="unilateral or plane (default: the scene's)")
    parser.add_argument("--threads", metavar="K", type=positive, default=1, help="threads (default: 1)")
    parser.add_argument(
        "--out", metavar="DIR", help="new or empty folder for the results (default: results/SCENE-DATE-TIME)"
    )


def add_json_option(parser: argparse.ArgumentParser) -> None:
    """Results as data."""
    parser.add_argument("--json", action="store_true", help="print one JSON document instead of text")


def asked_scene(options: argparse.Namespace):
    """The scene that the options name."""
    from studies.scenes.reader import read_scene

    return read_scene(options.scene, options.search_root, options.laws)
