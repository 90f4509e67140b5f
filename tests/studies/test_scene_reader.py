"""Scenes: shipped ones, round trip, strict reading."""

import pytest
from lxml import etree

from core_models.errors import CardError, MaterialError, MatpointError, SceneError, UnsupportedError
from core_models.walls import Wall
from studies.methods.method import build_solver
from studies.output.output_folder import OutputFolder
from studies.scenes.reader import read_scene
from studies.scenes.shipped import SCENES_FOLDER, shipped_scenes
from studies.scenes.writer import write_scene

RUBBING = '<wall type="plane" friction="0.2"/><conduction>on</conduction>'
NAMES = ("taylor-classic", "taylor-copper-jc", "taylor-copper-mts", "taylor-hy100-gtn", "taylor-ofhc-190")


def variant(tmp_path, old, new, name="taylor-classic"):
    """A shipped scene with one piece of its text replaced, beside its curves."""
    text = (SCENES_FOLDER / f"{name}.xml").read_text()
    assert old in text
    for curve in SCENES_FOLDER.glob("*.csv"):
        (tmp_path / curve.name).write_text(curve.read_text())
    path = tmp_path / "scene.xml"
    path.write_text(text.replace(old, new, 1))
    return path


def test_the_five_scenes_are_shipped():
    """The scenes that the documentation names are there and can be read."""
    assert tuple(shipped_scenes()) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_a_written_scene_reads_back_equal(name, tmp_path):
    """scene.xml of a run is the scene, resolved."""
    scene = read_scene(name)
    with OutputFolder(tmp_path / "out") as folder:
        write_scene(scene, scene.wall, folder)
    again = read_scene(tmp_path / "out" / "scene.xml")
    for attribute in ("name", "material", "bar", "end", "wall", "viscosity", "resolutions", "references"):
        assert getattr(again, attribute) == getattr(scene, attribute)
    assert [curve.path.name for curve in again.curves] == [curve.path.name for curve in scene.curves]


def test_the_founding_cylinder_is_read_along_its_axis():
    """The cards' y axis becomes the impact axis."""
    bar = read_scene("taylor-copper-jc").bar
    assert (bar.radius, bar.length, bar.velocity, bar.temperature) == (7.62e-3, 25.4e-3, -208.0, 294.0)


def test_dead_tags_are_reported():
    """toughness, burn and velocity_field do nothing, and the scene says so."""
    unused = " ".join(read_scene("taylor-copper-jc").unused)
    assert all(f"<{tag}>" in unused for tag in ("toughness", "burn", "velocity_field"))


def test_heating_can_be_turned_off(tmp_path):
    """<plastic_heating>off</plastic_heating> removes the effect."""
    path = variant(tmp_path, "<wall", "<plastic_heating>off</plastic_heating>\n<wall", "taylor-copper-jc")
    assert read_scene("taylor-copper-jc").material.heating is not None
    assert read_scene(path).material.heating is None


def test_conduction_and_friction_are_read_and_written(tmp_path):
    """<conduction> and the wall's friction come out of a file and go into one; without them there is neither."""
    plain = read_scene("taylor-copper-jc")
    assert not plain.conduction and plain.friction == 0.0
    path = variant(tmp_path, '<wall type="unilateral"/>', RUBBING, "taylor-copper-jc")
    scene = read_scene(path)
    assert scene.conduction and (scene.wall, scene.friction) == ("plane", 0.2)
    with OutputFolder(tmp_path / "out") as folder:
        write_scene(scene, scene.wall, folder)
    again = read_scene(tmp_path / "out" / "scene.xml")
    assert (again.conduction, again.wall, again.friction) == (True, "plane", 0.2)
    solver = build_solver(scene, "mpm", 4, scene.wall, 1)
    assert solver.wall == Wall("plane", 0.2) and solver.points.old.temperature is not None
    off = variant(tmp_path, '<wall type="unilateral"/>', RUBBING.replace("on<", "off<"), "taylor-copper-jc")
    assert not read_scene(off).conduction


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("<wall ", "<wal ", "did you mean 'wall'"),
        ('<wall type="unilateral"', '<wall kind="unilateral"', "type"),
        ('type="unilateral"', 'type="unilaterl"', "did you mean 'unilateral'"),
        ("<wall ", '<wall friction="-0.1" ', "friction = -0.1 is out of range"),
        ("<wall ", '<wall friction="some" ', "no number"),
        ("<wall ", "<conduction>maybe</conduction><wall ", "write on or off"),
        ("<wall ", "<conduction>on</conduction><wall ", "no thermal_conductivity and no specific_heat"),
        ('time="80e-6"', 'time="80-6"', "no number"),
        ('time="80e-6"', 'time="nan"', "no number"),
        ('time="80e-6"', 'time="-1"', "positive"),
        ('<end time="80e-6"/>', "", "lacks <end>"),
        ('linear="0"', 'linear="-1"', "negative"),
        ('fem="6 8 12 16"', 'fem="0"', "leaves no cell"),
        ('quantity="foot_radius"', 'quantity="foot_radus"', "did you mean 'foot_radius'"),
        ('href="taylor-classic-history.csv"', 'href="../x.csv"', "out of the scene's folder"),
        ('href="taylor-classic-history.csv"', 'href="x.csv"', "no such file"),
        ('name="taylor-classic"', 'name="../../escape"', "letters, digits"),
        ('name="taylor-classic"', 'name=""', "letters, digits"),
        ("-227.0]", "227.0]", "point to the wall"),
        ("[0.0,0.0,-227.0]", "[5.0,0.0,-227.0]", "straight impact"),
        ("<density>8930.0", "<density>-8930.0", "density"),
    ],
)
def test_bad_scenes_are_refused_with_file_line_and_remedy(tmp_path, old, new, told):
    """One line that begins with file and line and says what is wrong."""
    path = variant(tmp_path, old, new)
    with pytest.raises((SceneError, CardError, MaterialError, UnsupportedError)) as refused:
        read_scene(path)
    message = str(refused.value)
    assert message.startswith(f"{path}:") and message[len(str(path)) + 1].isdigit()
    assert told in message and "\n" not in message


def test_an_unknown_scene_names_the_nearest():
    """A misspelt scene is corrected."""
    with pytest.raises(SceneError, match="taylor-classic"):
        read_scene("taylor-clasic")


def test_random_damage_never_gives_anything_but_a_typed_error(tmp_path):
    """Every element taken out or renamed in turn reads or is refused by name."""
    count = len(list(etree.parse(SCENES_FOLDER / "taylor-classic.xml").getroot().iter("*")))
    for i in range(count):
        tree = etree.parse(SCENES_FOLDER / "taylor-classic.xml")
        list(tree.getroot().iter("*"))[i].tag = "broken"
        tree.write(tmp_path / "scene.xml")
        with pytest.raises(MatpointError):
            read_scene(tmp_path / "scene.xml")
