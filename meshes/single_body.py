"""A mesh that must be one body."""

from core_models.errors import UnsupportedError
from meshes.bodies import bodies_of_nodes
from meshes.mesh import Mesh


def refuse_several_bodies(mesh: Mesh, solver: str) -> None:
    """Refuse bodies that would pass through each other; UnsupportedError. solver : its name."""
    count = int(bodies_of_nodes(mesh.cells, len(mesh.points)).max()) + 1
    if count > 1:
        raise UnsupportedError(
            f"{mesh.source}: {count} bodies, between which {solver} has no contact: give one body, merge nodes "
            "that coincide, or use mpm.Solver, where bodies meet in one velocity field"
        )
