"""Measures of a deformed bar's outline, heights counted from the lowest point of its foot.

An outline is the boundary of the deformed body as three lines of (r, z) [m]: 'foot' from the axis to the
rim, 'side' from the foot's rim to the rear's, 'rear' back to the axis. Counting from the lowest point measures
a bar that has left the wall like one that stands on it; under the plane wall that point is the wall.
"""

import numpy as np

from studies import profile

Outline = dict[str, np.ndarray]


def length(outline: Outline) -> float:
    """Length of the bar [m]: area-weighted mean height of the rear above the lowest point of the foot."""
    return profile.mean_height(outline["rear"]) - lowest_point(outline)


def foot_radius(outline: Outline) -> float:
    """Largest radius of the lower half of the bar [m]."""
    line = np.concatenate([outline["foot"], outline["side"]])
    middle = 0.5 * (profile.mean_height(outline["rear"]) + lowest_point(outline))
    return float(line[line[:, 1] <= middle, 0].max())


def rim_lift(outline: Outline) -> float:
    """Height of the foot's rim above the foot's lowest point [m]."""
    return float(outline["foot"][-1, 1]) - lowest_point(outline)


def lowest_point(outline: Outline) -> float:
    """Height of the lowest point of the foot [m]."""
    return float(outline["foot"][:, 1].min())


def standing(outline: Outline) -> Outline:
    """The same outline, moved so that its lowest point is at z = 0."""
    return {part: line - [0.0, lowest_point(outline)] for part, line in outline.items()}
