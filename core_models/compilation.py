"""Where compiled kernels live on disk, and how functions that run inside them are declared.

Numba's disk cache watches only the file of the cached function, not the laws which that function calls. The cache
folder is therefore keyed by a hash of every source file that can end up in a kernel: an edited law starts from an
empty folder and can never run its old machine code.
"""

import hashlib
import logging
import os
import shutil
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numba
from llvmlite import binding
from numba import njit
from numba.extending import register_jitable

logger = logging.getLogger(__name__)

KERNEL_PACKAGES = ("core_models", "fem", "mpm")
UNUSED_CACHE_LIFETIME = 30 * 24 * 3600.0  # s
CHUNK = 256  # points; fixed, so that sums over chunks do not depend on the number of threads

_per_material_kernels: list = []
_own_laws: list[str] = []  # hashes of the users' files with laws


def inside_kernel(function: Callable) -> Callable:
    """Declare a function that kernels call; in plain Python it stays what it is."""
    return register_jitable(error_model="numpy", boundscheck=False, forceinline=True)(function)


def beside_kernel(function: Callable) -> Callable:
    """Declare a function that kernels call rarely: it stays out of their loops, which keeps those short."""
    return register_jitable(error_model="numpy", boundscheck=False)(function)


def kernel(function: Callable) -> Callable:
    """Compile a range kernel: cached on disk, releases the interpreter lock, IEEE arithmetic without fast-math.

    Kernels own no memory, so Numba's reference counts are switched off: their atomic increments took a third of the
    time of a point update.
    """
    return njit(cache=True, nogil=True, error_model="numpy", boundscheck=False, _nrt=False)(function)


def material_kernel(function: Callable) -> Callable:
    """Compile a kernel whose machine code depends on the laws of a material; see `rekey_cache`."""
    compiled = kernel(function)
    _per_material_kernels.append(compiled)
    if _own_laws:
        _use_own_folder(compiled)
    return compiled


def source_hash() -> str:
    """Hash of all sources that can be inlined in a kernel, and of the compiler's version."""
    digest = hashlib.sha256(numba.__version__.encode())
    root = Path(__file__).resolve().parent.parent
    for package in KERNEL_PACKAGES:
        for path in sorted((root / package).rglob("*.py")):
            digest.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def cache_root() -> Path:
    """Folder that holds all kernel caches: NUMBA_CACHE_DIR, else the user's cache folder."""
    given = os.environ.get("NUMBA_CACHE_DIR")
    if given:
        return Path(given)
    return Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "matpoint"


def use_source_keyed_cache() -> None:
    """Point Numba's disk cache at a folder named after the sources; to be called before anything is compiled."""
    root = cache_root()
    folder = root / source_hash()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        os.utime(folder)
        _remove_unused_caches(root)
    except OSError as reason:
        folder = Path(tempfile.mkdtemp(prefix="matpoint-kernels-"))
        logger.warning("kernel cache %s cannot be used (%s): compiling into %s", root, reason, folder)
    numba.config.CACHE_DIR = str(folder)


def use_whole_registers() -> None:
    """Let the compiler put as many numbers side by side as the registers hold; to be called before the first kernel.

    Of processors with AVX-512 it uses half the width, because the first of them slowed down otherwise; nowadays that
    costs a sixth of the time of a point update. The bits of the results do not depend on it.
    """
    features = binding.get_host_cpu_features()
    if numba.config.CPU_FEATURES is None and features.get("avx512f"):
        numba.config.CPU_FEATURES = f"{features.flatten()},-prefer-256-bit"


def rekey_cache(extra: bytes) -> None:
    """Give the kernels that depend on laws a cache folder that also depends on `extra` (sources of a user's laws)."""
    _own_laws.append(hashlib.sha256(extra).hexdigest()[:16])
    for compiled in _per_material_kernels:
        _use_own_folder(compiled)


def _use_own_folder(compiled) -> None:
    """Cache a kernel under the users' laws; the kernels that no law enters stay where everybody finds them."""
    if not hasattr(compiled, "enable_caching"):
        return
    shared = numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(Path(shared).joinpath(*(f"laws-{digest}" for digest in _own_laws)))
    compiled.enable_caching()
    numba.config.CACHE_DIR = shared


def _remove_unused_caches(root: Path) -> None:
    for folder in root.iterdir():
        is_ours = folder.is_dir() and len(folder.name) == 16
        if is_ours and time.time() - folder.stat().st_mtime > UNUSED_CACHE_LIFETIME:
            shutil.rmtree(folder, ignore_errors=True)
