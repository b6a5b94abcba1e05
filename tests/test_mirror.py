"""Tests lie as the package lies: `<package>/test_<module>.py`, beside it `test_<module>_<aspect>.py`."""

import ast
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).parent.parent
PACKAGE, TESTS = ROOT / "fleet_tui", ROOT / "tests"
MODULES = {
    path.relative_to(PACKAGE).as_posix(): path
    for path in PACKAGE.rglob("*.py")
    if path.name not in ("__init__.py", "__main__.py")
}

ACROSS = {
    "scenarios/": "several modules at once, from keys to the wire and back",
    "faults/": "what networks, bridges, robots and processes do to the whole",
    "test_house.py": "the rules of the house",
    "test_mirror.py": "the rules of the tests",
    "test_packaging.py": "the wheel",
    "test_packaging_single_file.py": "what is released beside the wheel",
    "test_soak.py": "a short form of a benchmark",
    "test_terminal_injection.py": "everything that is shown, in a real terminal",
}
"""Test files that belong to no module, and what they are about."""


def _has_logic(path: Path) -> bool:
    """Tell whether a module has a function that does something: declarations and protocols need no test."""
    return any(
        not isinstance(statement, ast.Pass)
        and not (isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant))
        for part in ast.walk(ast.parse(path.read_text()))
        if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef)
        for statement in part.body
    )


def _mirror(module: str) -> Path:
    path = TESTS / module
    return path.with_name(f"test_{path.name}")


def test_every_module_has_its_test_file() -> None:
    assert [name for name, path in MODULES.items() if _has_logic(path) and not _mirror(name).exists()] == []


def test_every_test_file_is_called_as_the_module_it_tests() -> None:
    lost, in_folder = [], defaultdict[str, set[str]](set)
    for module in map(Path, MODULES):
        in_folder[module.parent.as_posix()].add(module.stem)
    for path in TESTS.rglob("test_*.py"):
        name = path.relative_to(TESTS).as_posix()
        folder, stem = path.relative_to(TESTS).parent.as_posix(), path.stem.removeprefix("test_")
        modules = in_folder[folder]
        is_of_module = stem in modules or any(stem.startswith(f"{module}_") for module in modules)
        if not is_of_module and not name.startswith(tuple(ACROSS)):
            lost.append(name)
    assert lost == []
    assert [name for name in ACROSS if not (TESTS / name).exists()] == []
