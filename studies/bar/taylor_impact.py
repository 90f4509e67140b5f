"""The Taylor impact study: what is measured on the bar, by name.

Shape is measured on the outline of the deformed body (edges of the deformed domains, not their centres).
"""

from dataclasses import dataclass, field

import numpy as np

from core_models.errors import SceneError
from core_models.walls import PLANE
from studies.bar import profile
from studies.bar.outline import bar_outline
from studies.bar.shape import Outline, foot_height, foot_radius, rim_lift
from studies.observers.contact_watch import ContactWatch
from studies.observers.history import History
from studies.scenes.scene import Scene

WIDTH_STATION = 0.2  # height of `radius_at_0.2_L0` in undeformed lengths
UNDEFORMED_TOLERANCE = 0.01  # a radius up to 1 % above R0 counts as undeformed


@dataclass(frozen=True)
class Quantity:
    """One measured number in SI; value None where the run has no such thing, and the note says why."""

    value: float | None
    unit: str
    note: str = ""
    more: dict[str, float] = field(default_factory=dict)

    def as_json(self) -> dict:
        """Plain dictionary for results.json."""
        note = {"note": self.note} if self.note else {}
        return {"value": self.value, "unit": self.unit, **self.more, **note}


def measure(solver, scene: Scene, wall: str, history: History, contact: ContactWatch) -> dict[str, Quantity]:
    """All quantities of a finished run, by name, in the order in which they are reported."""
    outline = bar_outline(solver)
    return {
        "final_length": _final_length(scene, wall, history),
        "foot_radius": Quantity(foot_radius(outline), "m"),
        "rim_lift": Quantity(rim_lift(outline), "m"),
        **_shape(outline, scene),
        **_maxima(solver.points.fields()),
        "contact_duration": _contact_duration(wall, contact, solver.time),
    }


def _final_length(scene: Scene, wall: str, history: History) -> Quantity:
    times, lengths = history.column("t"), history.column("length")
    if not scene.end.after_release(wall):
        return Quantity(float(lengths[-1]), "m", f"at the end time, {times[-1] * 1e6:.4g} µs")
    last = times >= times[-1] - scene.axial_period
    t, values = times[last], lengths[last]
    mean = np.trapezoid(values, t) / (t[-1] - t[0]) if len(t) > 1 else values[-1]
    amplitude = 0.5 * float(values.max() - values.min())
    return Quantity(
        float(mean),
        "m",
        f"mean over the last axial period, {scene.axial_period * 1e6:.4g} µs",
        {"amplitude": amplitude},
    )


def _shape(outline: Outline, scene: Scene) -> dict[str, Quantity]:
    polygon = profile.half_profile(outline)
    foot = foot_height(outline)
    centroid_r, centroid_z = profile.centroid(polygon)
    station = foot + WIDTH_STATION * scene.bar.length
    return {
        "radius_at_0.2_L0": _radius_at(outline["side"], station),
        "undeformed_length": Quantity(_undeformed_length(outline, scene.bar.radius), "m"),
        "profile_arc_length": Quantity(profile.arc_length(outline["side"]), "m"),
        "profile_area": Quantity(profile.area(polygon), "m^2"),
        "volume": Quantity(profile.revolved_volume(polygon), "m^3"),
        "centroid_r": Quantity(float(centroid_r), "m"),
        "centroid_z": Quantity(float(centroid_z) - foot, "m"),
    }


def _radius_at(side: np.ndarray, height: float) -> Quantity:
    try:
        return Quantity(profile.radius_at_height(side, height), "m")
    except SceneError as error:
        return Quantity(None, "m", str(error))


def _undeformed_length(outline: Outline, radius: float) -> float:
    rear = profile.mean_height(outline["rear"])
    side_from_rear = outline["side"][::-1]
    height = profile.first_exceeding(side_from_rear, radius * (1.0 + UNDEFORMED_TOLERANCE))
    return rear - (foot_height(outline) if height is None else height)


def _maxima(fields: dict) -> dict[str, Quantity]:
    names = {"equivalent_plastic_strain": "1", "temperature": "K"}
    return {f"max_{name}": _maximum(fields, name, unit) for name, unit in names.items()}


def _maximum(fields: dict, name: str, unit: str) -> Quantity:
    if name not in fields:
        return Quantity(None, unit, f"the material has no {name.replace('_', ' ')}")
    return Quantity(float(fields[name].array.max()), unit, "largest over all points, at the end")


def _contact_duration(wall: str, contact: ContactWatch, end: float) -> Quantity:
    if wall == PLANE:
        return Quantity(None, "s", "a plane wall never lets go")
    if contact.first is None:
        return Quantity(None, "s", "the bar never touched the wall")
    note = "from the first to the last touch"
    if contact.last >= end:
        note = "from the first touch to the end, where the bar still touches the wall"
    return Quantity(contact.last - contact.first, "s", note)
