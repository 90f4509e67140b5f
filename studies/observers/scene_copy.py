"""Observer: the scene as run, kept beside its results."""

from studies.observers.observer import Observer
from studies.output.output_folder import OutputFolder
from studies.scenes.scene import Scene
from studies.scenes.writer import write_scene


class SceneCopy(Observer):
    """Writes scene.xml and the files that it names before the first step."""

    def __init__(self, scene: Scene, wall: str, folder: OutputFolder) -> None:
        self._scene, self._wall, self._folder = scene, wall, folder

    def start(self, solver) -> None:
        """Write all of it."""
        write_scene(self._scene, self._wall, self._folder)
