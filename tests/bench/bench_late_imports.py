"""Processor time and memory that each import inside a function saves a start which never calls it.

No target: such an import stays where it and those that a start leaves out with it save 100 ms or 10 MB."""

import ast
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from tests.bench.rows import Row, row

PACKAGE = Path(__file__).parents[2] / "fleet_tui"
IMPORT_ALL = """
import importlib, pathlib, sys, time
pages = lambda: int(pathlib.Path("/proc/self/statm").read_text().split()[1])
importlib.import_module(sys.argv[1])
began, before = time.process_time(), pages()
for name in sys.argv[2:]:
    importlib.import_module(name)
print(time.process_time() - began, (pages() - before) * 4096 / 1e6)
"""


def late_imports() -> Iterator[tuple[str, str, list[str]]]:
    """Yield each function with imports of ours inside: its module, its name, the modules it imports."""
    for file in sorted(PACKAGE.rglob("*.py")):
        module = ".".join(file.relative_to(PACKAGE.parent).with_suffix("").parts).removesuffix(".__init__")
        for made in ast.walk(ast.parse(file.read_text())):
            if isinstance(made, ast.FunctionDef | ast.AsyncFunctionDef):
                inside = [one.module for one in ast.walk(made) if isinstance(one, ast.ImportFrom)]
                ours = [name for name in inside if name and name.startswith(PACKAGE.name)]
                if ours:
                    yield module, made.name, ours


def main() -> list[Row]:
    """A row for each function, beside an interpreter that imports nothing more."""
    rows = []
    for module, function, late in late_imports():
        command = [sys.executable, "-c", IMPORT_ALL, module, *late]
        seconds, megabytes = subprocess.check_output(command, text=True).split()
        what = f"{module.removeprefix('fleet_tui.')}.{function}: {float(megabytes):.0f} MB and"
        rows.append(row("L7", what, float(seconds) * 1e3, "ms"))
    return rows


if __name__ == "__main__":
    main()
