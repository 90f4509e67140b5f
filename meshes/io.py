"""Mesh and point files in and out: gmsh's .msh and VTK's .vtu and .pvd. The only module that knows meshio.

How a file names the boundaries foot, side, rear and axis:
  .msh  by physical groups of dimension 1 (gmsh: Physical Curve("foot") = {...};);
  .vtu  by line cells, and per boundary one cell array of its name that is 1 on its lines and 0 elsewhere.
"""

import io
import logging
from collections.abc import Iterable, Mapping
from contextlib import redirect_stderr
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING
from xml.sax.saxutils import quoteattr

import numpy as np

from core_models.atomic import replacing
from core_models.errors import MeshError
from meshes.mesh import Mesh
from meshes.xml_guard import refuse_document_type

if TYPE_CHECKING:
    import meshio

LARGEST_FILE = 256 * 2**20
"""Bytes; a larger mesh file is refused before it is parsed."""

SUFFIXES = (".msh", ".vtu")
"""Mesh file formats, by the end of the file's name."""

IN_PLANE = 1e-9
"""Largest third coordinate of a plane mesh, as a part of the largest coordinate."""

logger = logging.getLogger(__name__)


def read_mesh(path: Path | str) -> Mesh:
    """Read an axisymmetric mesh of quads with named boundaries; r is x, z is y, lengths in metres.

    Nodes that no quad uses are left out; elements keep the file's order.
    Raises MeshError, naming the file: not there, too large, truncated or not a mesh; cells other than
    4-node quads and 2-node lines; out of the plane; and whatever Mesh refuses.
    """
    path = Path(path)
    parsed = _parse(path)
    cells = parsed.cells_dict
    for kind in cells:
        if kind not in ("quad", "line", "vertex"):
            raise MeshError(
                f"{path}: holds cells of type {kind}; mesh with 4-node quads only "
                "(gmsh: Mesh.RecombineAll = 1, Mesh.ElementOrder = 1)"
            )
    if "quad" not in cells:
        raise MeshError(f"{path}: holds no quads; export the surface too (gmsh: Physical Surface)")
    points = _plane(path, parsed.points)
    used, quads = np.unique(cells["quad"], return_inverse=True)
    new_number = np.full(len(points), -1)
    new_number[used] = np.arange(len(used))
    boundaries = {name: new_number[pairs] for name, pairs in _named_lines(path, parsed).items()}
    return Mesh(points[used], "quad4", quads.reshape(-1, 4), boundaries, source=str(path))


def write_mesh(path: Path | str, mesh: Mesh) -> None:
    """Write a mesh with its boundaries, as .msh (format 2.2, text) or .vtu; read_mesh gives it back equal.

    Raises MeshError for another suffix, OutputError when the file cannot be written.
    """
    import meshio

    path = Path(path)
    suffix = _suffix(path)
    lines = np.concatenate(list(mesh.boundaries.values()))
    number = np.repeat(
        np.arange(len(mesh.boundaries)) + 1, [len(pairs) for pairs in mesh.boundaries.values()]
    )
    numbers = [number.astype(np.int32), np.zeros(len(mesh.cells), np.int32)]
    file = meshio.Mesh(_spatial(mesh.points), [("line", lines), ("quad", mesh.cells)])
    if suffix == ".vtu":
        file.cell_data = {
            name: [(block == i).astype(np.int32) for block in numbers]
            for i, name in enumerate(mesh.boundaries, 1)
        }
        with replacing(path) as temporary:
            meshio.vtu.write(temporary, file)
        return
    body = len(mesh.boundaries) + 1
    numbers[1] += body
    file.cell_data = {"gmsh:physical": numbers, "gmsh:geometrical": numbers}
    file.field_data = {name: np.array([i, 1]) for i, name in enumerate(mesh.boundaries, 1)}
    file.field_data["body"] = np.array([body, 2])
    with replacing(path) as temporary:
        meshio.gmsh.write(temporary, file, fmt_version="2.2", binary=False)


def write_polygons_vtu(path: Path | str, polygons: np.ndarray, cell_data: Mapping[str, np.ndarray]) -> None:
    """Write separate quadrilaterals, such as the domains of material points, with their data for ParaView.

    Parameters: polygons (n, 4, 2), corners r, z [m]; cell_data: arrays of n rows, where tensors (n, 3, 3)
    become 9 columns.
    Raises MeshError when an array has another number of rows, OutputError when the file cannot be written.
    """
    import meshio

    count = len(polygons)
    for name, values in cell_data.items():
        if len(values) != count:
            raise MeshError(
                f"{path}: '{name}' has {len(values)} rows for {count} polygons; give one row each"
            )
    columns = {name: [_vtk_column(np.asarray(values))] for name, values in cell_data.items()}
    cells = [("quad", np.arange(4 * count).reshape(count, 4))]
    file = meshio.Mesh(_spatial(np.reshape(polygons, (-1, 2))), cells, cell_data=columns)
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


def _parse(path: Path) -> "meshio.Mesh":
    """Have meshio read a file; whatever goes wrong becomes a MeshError that names the file."""
    suffix = _suffix(path)
    if not path.is_file():
        raise MeshError(f"{path}: no such file; give the path of a {' or '.join(SUFFIXES)} file")
    if path.stat().st_size > LARGEST_FILE:
        raise MeshError(f"{path}: is larger than {LARGEST_FILE >> 20} MiB; give a coarser mesh")
    if suffix == ".vtu":
        refuse_document_type(path)
    import meshio

    read = meshio.vtu.read if suffix == ".vtu" else meshio.gmsh.read
    remarks = io.StringIO()
    try:
        with redirect_stderr(remarks):
            return read(str(path))
    except Exception as error:
        why = " ".join(str(error).split()) or type(error).__name__
        raise MeshError(
            f"{path}: truncated or not a {suffix} file that can be read ({why}); export it again "
            "(gmsh: Mesh.MshFileVersion = 2.2 or 4.1, Mesh.SaveAll = 0)"
        ) from error
    finally:
        if remarks.getvalue():
            logger.warning("%s: %s", path, " ".join(remarks.getvalue().split()))


def _suffix(path: Path) -> str:
    """The lower-case suffix; raises MeshError when it is none of SUFFIXES."""
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        nearest = get_close_matches(suffix, SUFFIXES, 1) or [" or ".join(SUFFIXES)]
        raise MeshError(f"{path}: unknown mesh format '{suffix}'; use {nearest[0]}")
    return suffix


def _named_lines(path: Path, parsed: "meshio.Mesh") -> dict[str, np.ndarray]:
    """Node pairs of each named group of lines in a file."""
    lines = parsed.cells_dict.get("line", np.empty((0, 2), dtype=np.int64))
    data = {name: blocks["line"] for name, blocks in parsed.cell_data_dict.items() if "line" in blocks}
    if _suffix(path) == ".vtu":
        return {name: lines[flags != 0] for name, flags in data.items() if flags.ndim == 1 and flags.any()}
    number = data.get("gmsh:physical", np.zeros(len(lines)))
    return {
        name: lines[number == tag] for name, (tag, dimension) in parsed.field_data.items() if dimension == 1
    }


def _plane(path: Path, points: np.ndarray) -> np.ndarray:
    """The first two coordinates; raises MeshError when the third is not zero."""
    if points.shape[1] == 3 and np.abs(points[:, 2]).max() > IN_PLANE * np.abs(points).max():
        raise MeshError(
            f"{path}: does not lie in the plane of x = r and y = z; set every third coordinate to 0"
        )
    return points[:, :2]


def _spatial(points: np.ndarray) -> np.ndarray:
    """Points (n, 2) with a third coordinate of 0, which both formats need."""
    return np.column_stack([points, np.zeros(len(points))])


def _vtk_column(values: np.ndarray) -> np.ndarray:
    """Values in a shape and type that VTK knows: at most two dimensions, no booleans."""
    values = values.astype(np.int32) if values.dtype == bool else values
    return values.reshape(len(values), -1) if values.ndim > 2 else values
