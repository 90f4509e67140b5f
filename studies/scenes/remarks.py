"""What is odd about a scene's numbers, though it can be simulated."""

from collections.abc import Iterator, Sequence

from core_models.laws import melting_temperature
from studies.scenes.scene import Scene


def scene_remarks(scene: Scene, wall: str, steps: Sequence[float]) -> list[str]:
    """One line each for a molten bar, an end that comes too soon and an impact above the speed of waves.

    steps : estimates of the first time step of every run [s].
    """
    return [*_melted(scene), *_end(scene, wall, steps), *_speed(scene)]


def _melted(scene: Scene) -> Iterator[str]:
    start, melting = scene.bar.temperature, melting_temperature(scene.material.melting)
    if start >= melting:
        yield (
            f"the bar begins at {start:g} K, at or above its melting temperature, {melting:g} K: it has no strength"
        )


def _end(scene: Scene, wall: str, steps: Sequence[float]) -> Iterator[str]:
    end, crossing = scene.end.limit(wall), 0.5 * scene.axial_period
    if end < crossing:
        yield (
            f"the scene ends at {end:.3g} s, before an elastic wave has come from the foot to the rear, which takes "
            f"{crossing:.3g} s: most of the bar stays as it was"
        )
    if steps and end < max(steps):
        yield f"the scene ends at {end:.3g} s, within the first time step, some {max(steps):.2g} s"


def _speed(scene: Scene) -> Iterator[str]:
    speed = -scene.bar.velocity
    if speed >= scene.wave_speed:
        yield (
            f"the impact at {speed:g} m/s is faster than elastic waves, {scene.wave_speed:.4g} m/s: the bar meets the "
            "wall with a shock beyond what its laws are made for"
        )
