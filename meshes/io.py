"""Mesh and point files in and out: gmsh's .msh, Abaqus's .inp, VTK's .vtu and .pvd. The only module that knows meshio.

How a file names boundaries:
  .msh  by physical groups of facets (gmsh: Physical Curve("foot") = {...}; in 3-D Physical Surface);
  .inp  by surfaces, by sets of elements that are facets, or by sets of nodes;
  .vtu  by facets among the cells, and per boundary one cell array of its name that is 1 on them and 0 elsewhere.
"""

import io
import logging
import re
from collections.abc import Iterable, Mapping
from contextlib import redirect_stderr
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING
from xml.sax.saxutils import quoteattr

import numpy as np

from core_models.atomic import replacing
from core_models.errors import MeshError
from meshes.abaqus import read_abaqus
from meshes.kinds import KINDS
from meshes.mesh import Mesh
from meshes.mesh_text import inp_text, msh_text
from meshes.parsed import Block, Named, Parsed, to_mesh
from meshes.seams import check_seams
from meshes.xml_guard import refuse_document_type

if TYPE_CHECKING:
    import meshio

LARGEST_FILE = 256 * 2**20
"""Bytes; a larger mesh file is refused before it is parsed."""

SUFFIXES = (".msh", ".inp", ".vtu")
"""Mesh file formats, by the end of the file's name."""

_OUR_NAMES = {"line": "line2", "line3": "line3"} | {kind.meshio: kind.name for kind in KINDS.values()}
_THEIR_NAMES = {ours: theirs for theirs, ours in _OUR_NAMES.items()}
_DOMAINS = {(3, 2): "triangle", (4, 2): "quad", (4, 3): "tetra", (8, 3): "hexahedron"}

logger = logging.getLogger(__name__)


def read_mesh(path: Path | str) -> Mesh:
    """Read a mesh of one kind of element with its named boundaries; coordinates in metres, 2-D in x and y.

    Nodes that no element uses are left out; elements keep the file's order.
    Raises MeshError, naming the file: not there, too large, truncated or not a mesh; elements of several or unknown
    kinds; 2-D elements out of the plane; facets that lie on each other without being merged; and what Mesh refuses.
    """
    path = Path(path)
    suffix = _suffix(path)
    if not path.is_file():
        raise MeshError(
            f"{path}: no such file; give the path of a {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]} file"
        )
    if path.stat().st_size > LARGEST_FILE:
        raise MeshError(f"{path}: is larger than {LARGEST_FILE >> 20} MiB; give a coarser mesh")
    mesh = to_mesh(path, read_abaqus(path) if suffix == ".inp" else _by_meshio(path, suffix))
    check_seams(mesh)
    return mesh


def write_mesh(path: Path | str, mesh: Mesh, msh_version: str = "4.1") -> None:
    """Write a mesh with its boundaries as .msh, .inp or .vtu; read_mesh gives it back equal.

    msh_version : '4.1' or '2.2', both as text. Of a kind for which Abaqus has no plane element (quad9) an .inp file
    holds membranes (M3D9). Raises MeshError for another suffix or version, or a boundary name that a file cannot
    hold, OutputError when the file cannot be written.
    """
    path = Path(path)
    suffix = _suffix(path)
    if msh_version not in ("4.1", "2.2"):
        raise MeshError(f"{path}: unknown format {msh_version} of .msh files; give '4.1' or '2.2'")
    for name in mesh.boundaries:
        if not re.fullmatch(r"[^\s\"',=*\\]+( [^\s\"',=*\\]+)*", name):
            raise MeshError(
                f"{path}: the boundary name {name!r} cannot be written; use letters, digits and _"
            )
    with replacing(path) as temporary:
        if suffix == ".inp":
            temporary.write_text(inp_text(mesh), encoding="utf-8")
        elif suffix == ".msh" and msh_version == "4.1":
            temporary.write_text(msh_text(mesh), encoding="utf-8")
        else:
            _write_by_meshio(temporary, suffix, mesh)


def write_domains_vtu(path: Path | str, domains: np.ndarray, cell_data: Mapping[str, np.ndarray]) -> None:
    """Write separate cells, such as the domains of material points, with their data for ParaView.

    Parameters: domains [m], corners in VTK's order: (n, 4, 2) quads or (n, 3, 2) triangles in the plane, (n, 8, 3)
    hexahedra or (n, 4, 3) tetrahedra; cell_data: arrays of n rows, where tensors (n, 3, 3) become 9 columns.
    Raises MeshError for another shape or number of rows, OutputError when the file cannot be written.
    """
    import meshio

    domains = np.asarray(domains)
    if domains.shape[1:] not in _DOMAINS:
        raise MeshError(
            f"{path}: domains have the shape {domains.shape}; give (n, 4, 2), (n, 3, 2), (n, 8, 3) or (n, 4, 3)"
        )
    count, corners, _ = domains.shape
    cell_data = {name: np.atleast_1d(values) for name, values in cell_data.items()}
    for name, values in cell_data.items():
        if len(values) != count:
            raise MeshError(f"{path}: '{name}' has {len(values)} rows for {count} domains; give one row each")
    columns = {name: [_vtk_column(values)] for name, values in cell_data.items()}
    cells = [(_DOMAINS[domains.shape[1:]], np.arange(corners * count).reshape(count, corners))]
    file = meshio.Mesh(_spatial(domains.reshape(-1, domains.shape[2])), cells, cell_data=columns)
    with replacing(path) as temporary:
        meshio.vtu.write(temporary, file)


def write_pvd(path: Path | str, frames: Iterable[tuple[float, str]]) -> None:
    """Write a time series for ParaView: pairs of time [s] and file name, relative to the .pvd's folder."""
    entries = "".join(
        f'    <DataSet timestep="{float(time)!r}" part="0" file={quoteattr(str(name))}/>\n'
        for time, name in frames
    )
    with replacing(path) as temporary:
        temporary.write_text(
            '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n  <Collection>\n'
            f"{entries}  </Collection>\n</VTKFile>\n",
            encoding="utf-8",
        )


def _by_meshio(path: Path, suffix: str) -> Parsed:
    """Have meshio read a file; whatever goes wrong becomes a MeshError that names the file."""
    if suffix == ".vtu":
        refuse_document_type(path)
    import meshio

    read = meshio.vtu.read if suffix == ".vtu" else meshio.gmsh.read
    remarks = io.StringIO()
    try:
        with redirect_stderr(remarks):
            file = read(str(path))
            blocks = [
                Block(_OUR_NAMES.get(b.type, b.type), np.asarray(b.data, dtype=np.int64)) for b in file.cells
            ]
    except Exception as error:
        why = " ".join(str(error).split()) or type(error).__name__
        raise MeshError(
            f"{path}: truncated or not a {suffix} file that can be read ({why}); export it again "
            "(gmsh: Mesh.MshFileVersion = 2.2 or 4.1, Mesh.SaveAll = 0)"
        ) from error
    finally:
        if remarks.getvalue():
            logger.warning("%s: %s", path, " ".join(remarks.getvalue().split()))
    groups = _flagged(file) if suffix == ".vtu" else _physical(file)
    return Parsed(np.asarray(file.points, dtype=float), blocks, groups)


def _physical(file: "meshio.Mesh") -> dict[str, Named]:
    """The elements of each named physical group."""
    numbers = file.cell_data.get("gmsh:physical")
    groups = {}
    for name, (tag, dimension) in file.field_data.items():
        rows = []
        for i, block in enumerate(file.cells):
            if name in file.cell_sets:
                inside = np.asarray(file.cell_sets[name][i], dtype=np.int64)
            else:
                inside = (
                    np.flatnonzero(np.asarray(numbers[i]) == tag)
                    if numbers and block.dim == dimension
                    else []
                )
            rows += [(i, row) for row in inside]
        groups[name] = Named(elements=np.array(rows, dtype=np.int64).reshape(-1, 2))
    return groups


def _flagged(file: "meshio.Mesh") -> dict[str, Named]:
    """The facets of each cell array that is 1 on some of them and 0 elsewhere."""
    dimension = max((block.dim for block in file.cells), default=0)
    groups = {}
    for name, parts in file.cell_data.items():
        flags = [np.asarray(part) for part in parts]
        if any(part.ndim != 1 or not np.isin(part, (0, 1)).all() for part in flags):
            continue
        if any(part.any() for part, block in zip(flags, file.cells, strict=True) if block.dim == dimension):
            continue
        rows = [(i, row) for i, part in enumerate(flags) for row in np.flatnonzero(part)]
        groups[name] = Named(elements=np.array(rows, dtype=np.int64).reshape(-1, 2))
    return groups


def _write_by_meshio(path: Path, suffix: str, mesh: Mesh) -> None:
    """Write a .vtu file, or a .msh file of format 2.2: the facets, boundary by boundary, then the elements."""
    import meshio

    kind = KINDS[mesh.kind]
    blocks = [(_THEIR_NAMES[kind.facet], nodes) for nodes in mesh.boundaries.values()]
    blocks.append((kind.meshio, mesh.cells))
    file = meshio.Mesh(_spatial(mesh.points), blocks)
    if suffix == ".vtu":
        file.cell_data = {
            name: [np.full(len(nodes), i == j, np.int32) for j, (_, nodes) in enumerate(blocks)]
            for i, name in enumerate(mesh.boundaries)
        }
        meshio.vtu.write(path, file)
        return
    numbers = [np.full(len(nodes), i, np.int32) for i, (_, nodes) in enumerate(blocks, 1)]
    file.cell_data = {"gmsh:physical": numbers, "gmsh:geometrical": numbers}
    file.field_data = {name: np.array([i, kind.dimension - 1]) for i, name in enumerate(mesh.boundaries, 1)}
    file.field_data["body"] = np.array([len(blocks), kind.dimension])
    meshio.gmsh.write(path, file, fmt_version="2.2", binary=False)


def _suffix(path: Path) -> str:
    """The lower-case suffix; raises MeshError when it is none of SUFFIXES."""
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        nearest = get_close_matches(suffix, SUFFIXES, 1) or [" or ".join(SUFFIXES)]
        raise MeshError(f"{path}: unknown mesh format '{suffix}'; use {nearest[0]}")
    return suffix


def _spatial(points: np.ndarray) -> np.ndarray:
    """Points (n, 2 or 3) with three coordinates, which both formats need."""
    return points if points.shape[1] == 3 else np.column_stack([points, np.zeros(len(points))])


def _vtk_column(values: np.ndarray) -> np.ndarray:
    """Values in a shape and type that VTK knows: at most two dimensions, no booleans."""
    values = values.astype(np.int32) if values.dtype == bool else values
    return values.reshape(len(values), -1) if values.ndim > 2 else values
