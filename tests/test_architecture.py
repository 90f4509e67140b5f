"""Rules of the code base as a whole: who may import whom, what a wheel holds, what every file must have."""

import ast
import importlib
import pkgutil
import re
import subprocess
import sys
import tomllib
from fnmatch import fnmatch
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

MAY_IMPORT = {
    "core_models": set(),
    "meshes": {"core_models"},
    "mpm": {"core_models", "meshes"},
    "fem": {"core_models", "meshes"},
    "studies": {"core_models", "meshes", "mpm", "fem"},
}
"""Packages, and which of the others each may import: one way only."""

SOURCES = [path for package in MAY_IMPORT for path in sorted((ROOT / package).rglob("*.py"))]

REGISTRY_HOST = re.compile(r"pypi\.org|pythonhosted\.org|npmjs\.org|debian\.org|anaconda\.org|crates\.io")
MACHINE_PATH = re.compile(r"(?<![\w./])/(?:home|root|work|tmp|Users|opt)/\w")
TEXT_SUFFIXES = {".py", ".md", ".toml", ".txt", ".xml", ".cfg", ".yml", ".css", ".html", ".csv", ".js", ""}


def relative(path):
    """A path as a test's name shows it."""
    return path.relative_to(ROOT).as_posix()


def imported_packages(path):
    """Top-level names of all imports in a file, wherever they stand."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (name.name.split(".")[0] for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{relative(path)}:{node.lineno}: write the whole name of the package"
            yield node.module.split(".")[0]


def made_by_tools(path):
    """Whether a path is hidden (but for .ci), a cache, a result or the product of a build."""
    parts = path.relative_to(ROOT).parts
    return any(
        part in {"results", "build", "dist", "__pycache__"}
        or part.endswith(".egg-info")
        or (part.startswith(".") and part != ".ci")
        for part in parts
    )


def own_text_files():
    """Every text file of the project."""
    for path in sorted(ROOT.rglob("*")):
        if path.is_file() and path.suffix in TEXT_SUFFIXES and not made_by_tools(path):
            yield path


def test_imports_go_one_way():
    """Studies import solvers and meshes, these import core_models; mpm and fem never import each other."""
    wrong = [
        f"{relative(path)} imports {name}"
        for path in SOURCES
        for name in imported_packages(path)
        if name in {*MAY_IMPORT, "tests"} - MAY_IMPORT[relative(path).split("/")[0]]
        and name != relative(path).split("/")[0]
    ]
    assert wrong == []


def test_core_models_needs_only_numpy_and_numba():
    """`import core_models` works where nothing but numpy and numba can be imported."""
    code = """
import sys
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in {"scipy", "skfem", "meshio", "gmsh", "lxml", "matplotlib", "pyvista"}:
            raise ModuleNotFoundError(name)
sys.meta_path.insert(0, Absent())
import core_models.material, core_models.points
"""
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True)


def test_only_meshes_io_knows_meshio():
    """The mesh file library is imported by one module, so that it can be replaced."""
    assert [relative(path) for path in SOURCES if "meshio" in imported_packages(path)] == ["meshes/io.py"]


def test_law_classes_have_names_of_their_own():
    """No two NamedTuple classes share a name, in any slot: the compiler would take them for one type."""
    names = [
        node.name
        for path in SOURCES
        if relative(path).startswith("core_models/")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ClassDef) and any(ast.unparse(base) == "NamedTuple" for base in node.bases)
    ]
    assert len(names) == len(set(names)), sorted(name for name in names if names.count(name) > 1)


@pytest.mark.parametrize("package", MAY_IMPORT)
def test_every_module_can_be_imported(package):
    """No module has a broken import, also those that nothing else imports."""
    for module in pkgutil.walk_packages([str(ROOT / package)], prefix=f"{package}."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)


def test_wheel_holds_the_packages_and_their_data_without_tests():
    """The build takes our packages only, so no tests, docs or set-up, and every card and scene in them."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]
    patterns = settings["packages"]["find"]["include"]
    folders = [path.name for path in ROOT.iterdir() if path.is_dir()]
    found = {name for name in folders if any(fnmatch(name, pattern) for pattern in patterns)}
    assert found == set(MAY_IMPORT)
    suffixes = {pattern.removeprefix("*") for pattern in settings["package-data"]["*"]} | {".py"}
    left_out = [
        relative(path)
        for package in MAY_IMPORT
        for path in (ROOT / package).rglob("*")
        if path.is_file() and path.suffix not in suffixes and not made_by_tools(path)
    ]
    assert left_out == []


def test_everything_public_has_a_docstring():
    """Modules, classes and functions without a leading underscore say what they are for."""
    kinds = (ast.Module, ast.ClassDef, ast.FunctionDef)
    missing = [
        f"{relative(path)}: {getattr(node, 'name', 'module')}"
        for path in SOURCES
        for node in public_nodes(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, kinds) and not ast.get_docstring(node)
    ]
    assert missing == []


def public_nodes(module):
    """The module, its public classes and functions, and the public methods of its public classes."""
    yield module
    for node in module.body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and not node.name.startswith("_"):
            yield node
            if isinstance(node, ast.ClassDef):
                yield from (
                    method
                    for method in node.body
                    if isinstance(method, ast.FunctionDef) and not method.name.startswith("_")
                )


def test_no_file_names_a_registry_or_a_machine():
    """Nothing in the project depends on where packages come from or where it was written."""
    wrong = [
        f"{relative(path)}:{number}: {line.strip()}"
        for path in own_text_files()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if REGISTRY_HOST.search(line) or MACHINE_PATH.search(line)
    ]
    assert wrong == []


def test_every_installed_package_is_pinned_once_per_python():
    """Constraints are plain names and versions, and cover every dependency that pyproject names."""
    lines = [line for line in (ROOT / "constraints.txt").read_text().splitlines() if line and line[0] != "#"]
    pin = re.compile(r"([a-z0-9_-]+)==[0-9][0-9.]*( ; python_version (<|>=) \"3\.\d+\")?")
    assert [line for line in lines if not pin.fullmatch(line)] == []
    keys = [(pin.fullmatch(line)[1], pin.fullmatch(line)[3]) for line in lines]
    assert len(keys) == len(set(keys))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    wanted = project["dependencies"] + sum(project["optional-dependencies"].values(), [])
    names = {re.match(r"[a-z0-9-]+", requirement)[0] for requirement in wanted} - {"matpoint"}
    assert names - {name for name, _ in keys} == set()
