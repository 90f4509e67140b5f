"""What an effect costs that is off: a scene with all effects off beside one whose card has never had them."""

import time
from dataclasses import dataclass, replace

from core_models.errors import MaterialError
from studies.methods.method import build_solver
from studies.scenes.scene import Scene
from studies.work_precision.bars import finish_bar
from studies.work_precision.measurement import WARM_STEPS

PAIRS = 15
ONLY_FOR_EFFECTS = ("thermal_conductivity", "specific_heat", "damage_radius", "melting")


@dataclass(frozen=True)
class OffCost:
    """Processor seconds of pairs of runs, made in turn; same : whether all answers were bitwise the same."""

    method: str
    off: tuple[float, ...]
    never: tuple[float, ...]
    same: bool

    @property
    def ratio(self) -> float:
        """Seconds with the effects off by those of a scene that never had them, the fastest of both."""
        return min(self.off) / min(self.never)

    @property
    def noise(self) -> float:
        """How much slower than the fastest the faster quarter is of the runs that are all the same, relative to it."""
        ordered = sorted(self.never)
        return ordered[len(ordered) // 4] / ordered[0] - 1.0


def all_off(scene: Scene) -> Scene:
    """The scene with damage, heating, conduction, viscosity and friction off; its card keeps their numbers."""
    material = replace(scene.material, damage=None, erosion=None, heating=None)
    return replace(scene, material=material, conduction=False, viscosity=None, friction=0.0)


def never_had(scene: Scene) -> Scene:
    """The scene with all off, of a card without the numbers that only these effects read."""
    material = all_off(scene).material
    for slot in ONLY_FOR_EFFECTS:
        try:
            material = replace(material, **{slot: None})
        except MaterialError:
            continue  # another law of the card reads it too
    return replace(all_off(scene), material=material)


def cost_of_off(scene: Scene, method: str, resolution: int, wall: str, pairs: int = PAIRS) -> OffCost:
    """Make both in turn, compiled beforehand, so many times each; MatpointError for what cannot be run."""
    seconds: tuple[list[float], list[float]] = ([], [])
    answers = []
    for k in range(pairs + 1):
        for kind, each in enumerate((all_off(scene), never_had(scene))):
            solver = build_solver(each, method, resolution, wall, 1)
            if k == 0:
                for _ in range(WARM_STEPS):
                    solver.advance()
                continue
            began = time.process_time()
            answers.append(finish_bar(solver, each.end.limit(wall)))
            seconds[kind].append(time.process_time() - began)
    return OffCost(method, tuple(seconds[0]), tuple(seconds[1]), all(each == answers[0] for each in answers))
