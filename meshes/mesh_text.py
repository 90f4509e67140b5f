"""Text of mesh files that are written here: gmsh's .msh in format 4.1 and Abaqus's .inp."""

import numpy as np

from meshes.abaqus import FACES, ORDERS
from meshes.kinds import KINDS
from meshes.mesh import Mesh

ABAQUS_TYPES = {
    "tri3": "CPS3",
    "tri6": "CPS6",
    "quad4": "CPS4",
    "quad8": "CPS8",
    "quad9": "M3D9",
    "tet4": "C3D4",
    "tet10": "C3D10",
    "hex8": "C3D8",
    "hex20": "C3D20",
    "hex27": "C3D27",
}

_EDGES = (8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14)
GMSH_TYPES = {
    "line2": (1, range(2)),
    "line3": (8, range(3)),
    "tri3": (2, range(3)),
    "tri6": (9, range(6)),
    "quad4": (3, range(4)),
    "quad8": (16, range(8)),
    "quad9": (10, range(9)),
    "tet4": (4, range(4)),
    "tet10": (11, (*range(8), 9, 8)),
    "hex8": (5, range(8)),
    "hex20": (17, (*range(8), *_EDGES)),
    "hex27": (12, (*range(8), *_EDGES, 24, 22, 20, 21, 23, 25, 26)),
}
"""gmsh's number of a type, and the places in VTK's order of the nodes in gmsh's."""


def msh_text(mesh: Mesh) -> str:
    """A mesh in gmsh's format 4.1: a physical group for each boundary, and 'body' for the elements."""
    dimension, facet = mesh.dimension, KINDS[mesh.kind].facet
    parts = [
        (dimension - 1, i, name, facet, mesh.boundaries[name]) for i, name in enumerate(mesh.boundaries, 1)
    ]
    parts.append((dimension, 1, "body", mesh.kind, mesh.cells))
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(parts))]
    lines += [f'{dim} {tag} "{name}"' for dim, tag, name, _, _ in parts]
    counts = [sum(part[0] == d for part in parts) for d in range(4)]
    lines += ["$EndPhysicalNames", "$Entities", _join(counts)]
    box = _join([*_solid(mesh.points.min(axis=0)), *_solid(mesh.points.max(axis=0))])
    lines += [f"{tag} {box} 1 {tag} 0" for _, tag, _, _, _ in parts]
    n = len(mesh.points)
    lines += ["$EndEntities", "$Nodes", f"1 {n} 1 {n}", f"{dimension} 1 0 {n}"]
    lines += [str(number) for number in range(1, n + 1)]
    lines += [_join(_solid(point)) for point in mesh.points]
    total = sum(len(nodes) for *_, nodes in parts)
    lines += ["$EndNodes", "$Elements", f"{len(parts)} {total} 1 {total}"]
    number = 0
    for dim, tag, _, kind, nodes in parts:
        code, order = GMSH_TYPES[kind]
        lines.append(f"{dim} {tag} {code} {len(nodes)}")
        for row in (nodes[:, list(order)] + 1).tolist():
            number += 1
            lines.append(_join([number, *row]))
    return "\n".join([*lines, "$EndElements", ""])


def inp_text(mesh: Mesh) -> str:
    """A mesh for Abaqus: the elements in the set 'body', and a surface for each boundary."""
    lines = ["*HEADING", "*NODE"]
    lines += [", ".join([str(i), *map(repr, point)]) for i, point in enumerate(mesh.points.tolist(), 1)]
    lines.append(f"*ELEMENT, TYPE={ABAQUS_TYPES[mesh.kind]}, ELSET=body")
    order = np.argsort(ORDERS.get(mesh.kind, range(mesh.cells.shape[1])))
    for number, row in enumerate((mesh.cells[:, order] + 1).tolist(), 1):
        entries = [str(number), *map(str, row)]
        lines += [
            ", ".join(entries[i : i + 16]) + ("," if i + 16 < len(entries) else "")
            for i in range(0, len(entries), 16)
        ]
    face_of = np.argsort(FACES[mesh.kind.rstrip("0123456789")]) + 1
    for name in mesh.boundaries:
        lines.append(f'*SURFACE, TYPE=ELEMENT, NAME="{name}"')
        lines += [f"{cell + 1}, S{face_of[facet]}" for cell, facet in mesh.owners(name).tolist()]
    return "\n".join([*lines, ""])


def _solid(point: np.ndarray) -> list[float]:
    """Three coordinates of a point in the plane or in space."""
    return [*point.tolist(), 0.0][:3]


def _join(values: list) -> str:
    return " ".join(map(repr, values))
