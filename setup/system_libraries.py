"""See to the system libraries that the wheels of gmsh and VTK load but do not bring.

Installs what is missing where it may (root, apt-get); else prints the line to type and ends with status 1.
Uses the standard library only, since it runs before anything is installed.
"""

import ctypes
import os
import platform
import shutil
import subprocess
import sys

PACKAGE_OF = {
    ("libGLU.so.1",): "libglu1-mesa",
    ("libGL.so.1",): "libgl1",
    ("libgomp.so.1",): "libgomp1",
    ("libXft.so.2",): "libxft2",
    ("libXcursor.so.1",): "libxcursor1",
    ("libXinerama.so.1",): "libxinerama1",
    ("libXfixes.so.3",): "libxfixes3",
    ("libEGL.so.1", "libOSMesa.so.8"): "libegl1",
}
"""Debian package per library; where several libraries are named, any one of them will do."""


def loads(library: str) -> bool:
    """Whether the dynamic linker finds a library and everything it needs."""
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def missing_packages() -> list[str]:
    """Debian packages to install."""
    return [package for libraries, package in PACKAGE_OF.items() if not any(map(loads, libraries))]


def install(packages: list[str]) -> None:
    """Install packages with apt-get, without questions."""
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    for arguments in (["update"], ["install", "--yes", "--no-install-recommends", *packages]):
        command = ["apt-get", "--quiet", "--quiet", *arguments]
        subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, check=True)


def main() -> int:
    """Check, install where possible, check again; the exit status."""
    packages = missing_packages() if platform.system() == "Linux" else []
    if not packages:
        return 0
    if os.geteuid() == 0 and shutil.which("apt-get"):
        print("installing system libraries:", *packages, flush=True)
        try:
            install(packages)
        except subprocess.CalledProcessError as error:
            print("apt-get ended with status", error.returncode, file=sys.stderr)
        packages = missing_packages()
    if packages:
        command = f"sudo apt-get install --yes {' '.join(packages)}"
        print(
            f"gmsh and VTK need system libraries that are not here; type:\n\n    {command}\n", file=sys.stderr
        )
    return 1 if packages else 0


if __name__ == "__main__":
    sys.exit(main())
