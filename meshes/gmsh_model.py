"""gmsh as a guest: a model of our own that leaves no trace in the terminal or in the caller's own models."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType

from core_models.errors import MeshError

_ONE_AT_A_TIME = threading.Lock()
"""gmsh keeps its state in global variables, so models are built one after the other."""

_INSTALL = "apt-get install libglu1-mesa libgl1 libgomp1 libxft2 libxcursor1 libxinerama1 libxfixes3"


@contextmanager
def gmsh_model(name: str) -> Iterator[ModuleType]:
    """Give gmsh with a new, empty, current model; afterwards everything is as it was before.

    Works from any thread, touches no signal handler, prints nothing, and keeps what the caller has open.
    Raises MeshError when gmsh cannot be loaded.
    """
    gmsh = _load_gmsh()
    with _ONE_AT_A_TIME, _opened(gmsh):
        gmsh.model.add(name)
        try:
            yield gmsh
        finally:
            gmsh.model.remove()


def _load_gmsh() -> ModuleType:
    """Import gmsh, late since it takes a quarter of a second and needs system libraries."""
    try:
        import gmsh
    except (ImportError, OSError) as error:
        raise MeshError(f"gmsh cannot be loaded ({error}); on Debian: {_INSTALL}") from None
    return gmsh


@contextmanager
def _opened(gmsh: ModuleType) -> Iterator[None]:
    """Open gmsh and close it again; where it is open already, restore its current model and option."""
    if not gmsh.isInitialized():
        gmsh.initialize([], readConfigFiles=False, interruptible=False)
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            yield
        finally:
            gmsh.finalize()
        return
    terminal = gmsh.option.getNumber("General.Terminal")
    current = gmsh.model.getCurrent()
    gmsh.option.setNumber("General.Terminal", 0)
    try:
        yield
    finally:
        gmsh.option.setNumber("General.Terminal", terminal)
        gmsh.model.setCurrent(current)
