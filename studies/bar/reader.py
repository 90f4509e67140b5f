"""The bar of a scene from the cylinder in its `<material>` block."""

import numpy as np
from lxml import etree

from core_models.cards import Cylinder, refusal
from core_models.errors import SceneError, UnsupportedError
from studies.scenes.scene import Bar

OFF_AXIS = 1e-9  # largest sideways share of a velocity that still flies along the axis


def read_bar(bodies: tuple[Cylinder, ...], material: etree._Element) -> Bar:
    """The one cylinder, its axis from bottom (at the wall) to top, flying towards its bottom."""
    if len(bodies) != 1:
        raise refusal(
            material,
            f"<material> has {len(bodies)} bodies",
            "a scene has one geom_object with a cylinder",
            SceneError,
        )
    body = bodies[0]
    element = material.find("geom_object")
    axis = np.subtract(body.top, body.bottom)
    length = float(np.linalg.norm(axis))
    speed = float(np.dot(body.velocity, axis) / length)
    sideways = np.linalg.norm(np.subtract(body.velocity, speed * axis / length))
    if sideways > OFF_AXIS * abs(speed):
        raise refusal(
            element,
            "the velocity is not along the cylinder's axis",
            "only straight impact is offered",
            UnsupportedError,
        )
    try:
        return Bar(body.radius, length, speed, body.temperature)
    except SceneError as error:
        raise refusal(element, str(error), "let it fly from top to bottom", SceneError) from error
