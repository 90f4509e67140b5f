"""Laws in a user's own file: imported before anything that uses them is compiled."""

import hashlib
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

from core_models.compilation import rekey_cache
from core_models.errors import MaterialError

_loaded: dict[str, ModuleType] = {}


def load(path: Path | str) -> ModuleType:
    """Import a Python file that registers laws, and key the kernel cache with its contents.

    Parameters
    ----------
    path : the file; what it says at import is what its laws are for the rest of the process.

    The module's name holds a hash of the file, and so does the folder of compiled kernels: an edited law never runs
    its old machine code. Loading the same file twice returns the same module.
    Raises MaterialError: no such file, a file that fails at import, or a law's name that is taken.
    """
    path = Path(path)
    try:
        source = path.read_bytes()
    except OSError as reason:
        raise MaterialError(
            f"{path}: cannot be read ({reason.strerror}): name a Python file with laws"
        ) from reason
    name = f"matpoint_laws_{path.stem}_{hashlib.sha256(source).hexdigest()[:12]}"
    if name not in _loaded:
        rekey_cache(source)
        _loaded[name] = _import(name, path)
    return _loaded[name]


def _import(name: str, path: Path) -> ModuleType:
    specification = importlib.util.spec_from_file_location(name, path)
    if specification is None or specification.loader is None:
        raise MaterialError(f"{path}: is no Python file: give its name the ending .py")
    module = importlib.util.module_from_spec(specification)
    sys.modules[name] = module
    try:
        specification.loader.exec_module(module)
    except (Exception, SystemExit) as reason:
        del sys.modules[name]
        if isinstance(reason, MaterialError):
            raise
        told = " ".join(str(reason).split())
        raise MaterialError(f"{path}: importing it failed with {type(reason).__name__}: {told}") from reason
    return module
