"""The top-level packages have generic names: check that they are ours before anything of them is used."""

from importlib.util import find_spec
from pathlib import Path


class ShadowedPackage(ImportError):
    """Another package is found instead of ours; not a MatpointError, since core_models may be that package."""

    exit_status = 2


PACKAGES = ("core_models", "mpm", "fem", "meshes", "studies")
MARK = "matpoint"  # every package's __init__ names the distribution


def check_own_packages() -> None:
    """Raise ShadowedPackage when an import would find another package; imports none of them."""
    ours = Path(__file__).resolve().parent.parent
    for name in PACKAGES:
        found = _location(name)
        if found is None:
            raise ShadowedPackage(f"package {name} is missing from {ours}: install matpoint again")
        if found.parent.parent != ours or MARK not in found.read_text(encoding="utf-8"):
            raise ShadowedPackage(
                f"package {name} at {found.parent} shadows matpoint's at {ours / name}: "
                "uninstall it, or run from another folder without PYTHONPATH"
            )


def _location(name: str) -> Path | None:
    spec = find_spec(name)
    return Path(spec.origin).resolve() if spec is not None and spec.origin else None
