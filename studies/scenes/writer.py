"""Scenes written as XML, resolved: no includes, every number with all its digits; reads back equal."""

from lxml import etree

from core_models.cards import material_element
from studies.methods.method import find_method
from studies.output.output_folder import OutputFolder
from studies.scenes.scene import Bar, End, Scene


def write_scene(scene: Scene, wall: str, folder: OutputFolder) -> None:
    """Write scene.xml, and beside it the files that it names."""
    named = [scene.mesh, scene.laws, *(curve.path for curve in scene.curves)]
    for path in filter(None, named):
        folder.copy(path)
    text = etree.tostring(scene_element(scene, wall), pretty_print=True, encoding="unicode")
    folder.write_text("scene.xml", f'<?xml version="1.0" encoding="UTF-8"?>\n{text}')


def scene_element(scene: Scene, wall: str) -> etree._Element:
    """The `<scene>` element of a scene under a wall."""
    root = etree.Element("scene", name=scene.name)
    if scene.description:
        etree.SubElement(root, "description").text = scene.description
    material = material_element(scene.material)
    material.append(_body(scene.bar))
    root.append(material)
    for tag, path in (("mesh", scene.mesh), ("laws", scene.laws)):
        if path is not None:
            etree.SubElement(root, tag, href=path.name)
    friction = {"friction": repr(scene.friction)} if scene.friction else {}
    etree.SubElement(root, "wall", type=wall, **friction)
    etree.SubElement(root, "end", _end(scene.end))
    coefficients = (0.0, 0.0) if scene.viscosity is None else scene.viscosity
    etree.SubElement(root, "bulk_viscosity", linear=repr(coefficients[0]), quadratic=repr(coefficients[1]))
    if scene.conduction:
        etree.SubElement(root, "conduction").text = "on"
    if scene.resolutions:
        numbers = {
            find_method(name).scene_key: " ".join(map(str, of)) for name, of in scene.resolutions.items()
        }
        etree.SubElement(root, "resolution", numbers)
    _add_references(root, scene)
    return root


def _body(bar: Bar) -> etree._Element:
    element = etree.Element("geom_object")
    cylinder = etree.SubElement(element, "cylinder", label="bar")
    etree.SubElement(cylinder, "bottom").text = "[0.0,0.0,0.0]"
    etree.SubElement(cylinder, "top").text = f"[0.0,0.0,{bar.length!r}]"
    etree.SubElement(cylinder, "radius").text = repr(bar.radius)
    etree.SubElement(element, "velocity").text = f"[0.0,0.0,{bar.velocity!r}]"
    etree.SubElement(element, "temperature").text = repr(bar.temperature)
    return element


def _end(end: End) -> dict[str, str]:
    if end.time is not None:
        return {"time": repr(end.time)}
    times = {"latest": end.latest, "plane": end.plane}
    return {"after": "release", **{name: repr(time) for name, time in times.items() if time is not None}}


def _add_references(root: etree._Element, scene: Scene) -> None:
    for reference in scene.references:
        numbers = {"low": repr(reference.low), "high": repr(reference.high)}
        wall = {"wall": reference.wall} if reference.wall else {}
        etree.SubElement(
            root, "reference", quantity=reference.quantity, **numbers, **wall, source=reference.source
        )
    for curve in scene.curves:
        wall = {"wall": curve.wall} if curve.wall else {}
        etree.SubElement(
            root, "reference_curve", kind=curve.kind, href=curve.path.name, **wall, source=curve.source
        )
