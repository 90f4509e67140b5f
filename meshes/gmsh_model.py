"""gmsh as a guest: a model of our own that leaves no trace in the terminal or in the caller's own models."""

import ctypes
import signal
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import ModuleType

import numpy as np

from core_models.errors import MeshError
from meshes.kinds import KINDS
from meshes.patch import Patch

_ONE_AT_A_TIME = threading.Lock()
"""gmsh keeps its state in global variables, so models are built one after the other."""

_OPTIONS = {
    "General.Terminal": 0,
    "Mesh.Algorithm": 6,  # frontal Delaunay
    "Mesh.Algorithm3D": 1,  # Delaunay
    "Mesh.AngleToleranceFacetOverlap": 0.1,
    "Mesh.CompoundClassify": 1,
    "Mesh.ElementOrder": 1,
    "Mesh.MeshSizeExtendFromBoundary": 1,
    "Mesh.MeshSizeFactor": 1.0,
    "Mesh.MeshSizeFromCurvature": 0,
    "Mesh.MeshSizeFromPoints": 1,
    "Mesh.MeshSizeMax": 1e22,
    "Mesh.MeshSizeMin": 0.0,
    "Mesh.Optimize": 1,
    "Mesh.OptimizeNetgen": 1,
    "Mesh.RandomSeed": 1,
    "Mesh.RecombinationAlgorithm": 3,  # blossom, all quads
    "Mesh.RecombineAll": 0,
    "Mesh.Smoothing": 1,
    "Mesh.SubdivisionAlgorithm": 0,
}
"""All that decides on a mesh here, so that nothing which the caller has set does."""

SIGACTION_BYTES = 512
"""More than any system's struct sigaction has."""

_GMSH_NAMES = {"line2": "Line", "tri3": "Triangle", "quad4": "Quadrangle", "tet4": "Tetrahedron"}

_INSTALL = "apt-get install libglu1-mesa libgl1 libgomp1 libxft2 libxcursor1 libxinerama1 libxfixes3"


@contextmanager
def gmsh_model(name: str) -> Iterator[ModuleType]:
    """Give gmsh with a new, empty, current model; afterwards everything is as it was before.

    Works from any thread, touches no signal handler, prints nothing, and keeps what the caller has open.
    Raises MeshError when gmsh cannot be loaded, and in place of gmsh's errors.
    """
    gmsh = _load_gmsh()
    with _ONE_AT_A_TIME, _opened(gmsh):
        gmsh.model.add(name)
        try:
            yield gmsh
        except Exception as error:
            if type(error) is not Exception:  # gmsh's own
                raise
            raise MeshError(
                f"{name}: gmsh cannot mesh it ({error}); change sizes, counts or grading"
            ) from None
        finally:
            gmsh.model.remove()


def read_out(gmsh: ModuleType, kind: str, named: Mapping[str, Sequence[int]]) -> Patch:
    """Nodes and elements of a linear kind of the current model, and the facets on entities: name -> their tags.

    Nodes are numbered in gmsh's order, elements too.
    """
    dimension, mesh = KINDS[kind].dimension, gmsh.model.mesh

    def elements(name: str, tag: int = -1) -> np.ndarray:
        count = KINDS[name].nodes if name in KINDS else 2
        return mesh.getElementsByType(mesh.getElementType(_GMSH_NAMES[name], 1), tag)[1].reshape(-1, count)

    tags, coordinates, _ = mesh.getNodes()
    cells = elements(kind)
    used = np.isin(tags, cells)
    number = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    number[tags[used]] = np.arange(used.sum())
    boundaries = {
        name: number[np.concatenate([elements(KINDS[kind].facet, tag) for tag in on])]
        for name, on in named.items()
    }
    return Patch(coordinates.reshape(-1, 3)[used, :dimension], number[cells], boundaries)


def _load_gmsh() -> ModuleType:
    """Import gmsh, late since it takes a quarter of a second and needs system libraries."""
    try:
        import gmsh
    except (ImportError, OSError) as error:
        raise MeshError(f"gmsh cannot be loaded ({error}); on Debian: {_INSTALL}") from None
    return gmsh


@contextmanager
def _opened(gmsh: ModuleType) -> Iterator[None]:
    """Open gmsh and close it again; where it is open already, restore its current model and options."""
    if not gmsh.isInitialized():
        with _signals_left_alone():
            gmsh.initialize([], readConfigFiles=False, interruptible=False)
        try:
            _set(gmsh, _OPTIONS)
            yield
        finally:
            gmsh.finalize()
        return
    before = {name: gmsh.option.getNumber(name) for name in _OPTIONS}
    current = gmsh.model.getCurrent()
    _set(gmsh, _OPTIONS)
    try:
        yield
    finally:
        _set(gmsh, before)
        gmsh.model.setCurrent(current)


@contextmanager
def _signals_left_alone() -> Iterator[None]:
    """Take back what gmsh does to signals: without Python's knowledge it lets SIGPIPE and SIGTERM end the process."""
    # Not signal.signal, which only the main thread may call and which does not see what C code has set.
    sigaction = ctypes.CDLL(None).sigaction
    before = {number: ctypes.create_string_buffer(SIGACTION_BYTES) for number in signal.valid_signals()}
    for number, action in before.items():
        sigaction(int(number), None, action)
    try:
        yield
    finally:
        for number, action in before.items():
            sigaction(int(number), action, None)


def _set(gmsh: ModuleType, options: Mapping[str, float]) -> None:
    for name, value in options.items():
        gmsh.option.setNumber(name, value)
