"""Segments of a loading program from words: '1e-3 stretch11=1.1 stress22=0 L12=200'."""

import re

from core_models.errors import SceneError
from core_models.loading import Control, Deformation, Stress, Stretch, VelocityGradient
from core_models.loading_program import Segment
from core_models.names import suggestion

KINDS = {"F": Deformation, "L": VelocityGradient, "stretch": Stretch, "stress": Stress}
FORM = "write a duration [s], then words like stretch11=1.1 F12=0.2 L21=100 stress33=-1e8"


def read_segment(text: str, steps: int) -> Segment:
    """The segment that a text says, in so many steps; raises SceneError naming the wrong word."""
    duration, *words = re.split(r"[\s,]+", text.strip())
    controls: dict[str, Control] = {}
    for word in words:
        component, control = _control(word, text)
        if component in controls:
            raise SceneError(f"segment '{text}': component {component} is prescribed twice")
        controls[component] = control
    return Segment(_number(duration, "duration", text), steps, controls)


def _control(word: str, text: str) -> tuple[str, Control]:
    parts = re.fullmatch(r"([A-Za-z]+)(\d*)=(.*)", word)
    if parts is None:
        raise SceneError(f"segment '{text}': '{word}' cannot be read; {FORM}")
    kind, component, value = parts.groups()
    if kind not in KINDS:
        raise SceneError(f"segment '{text}': unknown quantity '{kind}'; {suggestion(kind, KINDS)}")
    if not re.fullmatch("[123][123]", component):
        raise SceneError(f"segment '{text}': '{kind}{component}' needs two digits from 1 to 3, like {kind}12")
    return component, KINDS[kind](_number(value, f"value of {kind}{component}", text))


def _number(value: str, what: str, text: str) -> float:
    try:
        return float(value)
    except ValueError:
        raise SceneError(f"segment '{text}': the {what}, '{value}', is no number; {FORM}") from None
