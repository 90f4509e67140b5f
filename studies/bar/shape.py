"""Measures of a deformed bar's outline, heights counted from its foot.

An outline is the boundary of the deformed body as three lines of (r, z) [m]: 'foot' from the axis to the
rim, 'side' from the foot's rim to the rear's, 'rear' back to the axis. Counting from the foot measures a bar that
has left the wall like one that stands on it. The foot's height is the median over the inner half of its radius: the
rim may lift, and single corners of particles' domains, above all beside the axis, are noisy.
"""

import numpy as np

from studies.bar import profile

Outline = dict[str, np.ndarray]


def length(outline: Outline) -> float:
    """Length of the bar [m]: area-weighted mean height of the rear above the foot."""
    return profile.mean_height(outline["rear"]) - foot_height(outline)


def foot_radius(outline: Outline) -> float:
    """Largest radius of the lower half of the bar [m]."""
    line = np.concatenate([outline["foot"], outline["side"]])
    middle = 0.5 * (profile.mean_height(outline["rear"]) + foot_height(outline))
    return float(line[line[:, 1] <= middle, 0].max())


def rim_lift(outline: Outline) -> float:
    """Height of the foot's rim above the foot [m]."""
    return float(outline["foot"][-1, 1]) - foot_height(outline)


def foot_height(outline: Outline) -> float:
    """Height of the foot [m]: area-weighted median over the inner half of its radius."""
    foot = outline["foot"]
    return profile.median_height(foot, 0.5 * float(foot[-1, 0]))


def standing(outline: Outline) -> Outline:
    """The same outline, moved so that its foot is at z = 0."""
    return {part: line - [0.0, foot_height(outline)] for part, line in outline.items()}
