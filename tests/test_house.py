"""The rules of the house that an import checker cannot see: names, purity, complete matches."""

import ast
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import pytest

from fleet_tui.model.commands import Command
from fleet_tui.model.events import Event
from fleet_tui.robots.registry import KINDS

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "fleet_tui"
FILES = sorted(PACKAGE.rglob("*.py"))
PURE = [
    "text",
    "model",
    "keys",
    "orders",
    "situation",
    "commands",
    "robots",
    "state",
    "maps/formats",
    "links/rates",
    "ui/view",
    "features/graphs/rules",
    "features/routines/rules",
    "features/history/report",
]
PURE_SIMULATOR = [
    *(
        "world.py",
        "messages.py",
        "oh_ressources/world.py",
        "warehouse.py",
        "robot.py",
        "floorplan.py",
        "ros/goals.py",
        "ros/actionlib.py",
    ),
    *(f"navigating/{name}.py" for name in ("world", "robot", "paths", "messages")),
    *("nav2/navigation.py", "nav2/messages.py", "move_base/navigation.py"),
]
FORBIDDEN_NAMES = ("Manager", "Helper", "Utils", "Handler", "Data", "Info")
IMPURE_CALLS = {"open", "print", "input", "now", "today", "monotonic", "perf_counter", "time_ns", "read_text"}


def _class_names() -> list[str]:
    """The names alone: what is found without parsing everything once more."""
    return [name for path in FILES for name in re.findall(r"^ *class (\w+)", path.read_text(), re.MULTILINE)]


def test_no_two_classes_share_a_name() -> None:
    names = Counter(_class_names())
    assert len(names) > 500
    assert [name for name, count in names.items() if count > 1] == []


def test_no_vague_names() -> None:
    assert [name for name in _class_names() if name.endswith(FORBIDDEN_NAMES)] == []


def _pure_files() -> Iterator[Path]:
    for package in PURE:
        path = PACKAGE / package
        yield from [path] if path.is_file() else path.rglob("*.py")
    yield from (PACKAGE / "simulator" / name for name in PURE_SIMULATOR)


@pytest.mark.parametrize("path", list(_pure_files()), ids=lambda path: str(path.relative_to(PACKAGE)))
def test_pure_modules_touch_nothing(path: Path) -> None:
    tree = ast.parse(path.read_text())
    imported = {
        alias.name.partition(".")[0]
        for part in ast.walk(tree)
        if isinstance(part, ast.Import)
        for alias in part.names
    } | {(part.module or "").partition(".")[0] for part in ast.walk(tree) if isinstance(part, ast.ImportFrom)}
    assert imported.isdisjoint(
        {"time", "datetime", "logging", "os", "pathlib", "socket", "asyncio", "threading"}
    )
    called = {
        part.func.id if isinstance(part.func, ast.Name) else part.func.attr
        for part in ast.walk(tree)
        if isinstance(part, ast.Call) and isinstance(part.func, ast.Name | ast.Attribute)
    }
    assert called.isdisjoint(IMPURE_CALLS)


def test_only_the_transport_knows_roslibpy() -> None:
    knows = [
        str(path.relative_to(PACKAGE))
        for path in FILES
        if any(
            f"{word} {name}" in path.read_text()
            for word in ("import", "from")
            for name in ("roslibpy", "autobahn")
        )
    ]
    assert knows == ["links/transports/rosbridge/library.py"]


def test_a_kind_of_robot_is_a_folder() -> None:
    folders = {path.parent.name for path in (PACKAGE / "robots").glob("*/adapter.py")}
    assert set(KINDS) == folders


def test_every_exception_to_the_rules_has_its_reason() -> None:
    for path in [*FILES, *(ROOT / "tests").rglob("*.py")]:
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for mark in ("# type: " + "ignore", "# no" + "qa"):
                if mark in line:
                    assert "  # " in line.split(mark, 1)[1], f"{path.name}:{number} gives no reason"


def test_matches_over_commands_and_events_are_complete() -> None:
    """Each ends in assert_never, so that the type checker names it where a command or an event is added."""
    flat: set[type] = set(get_args(Command))
    for kind in get_args(Event):
        flat |= set(get_args(kind)) or {kind}
    names = {kind.__name__ for kind in flat}
    open_ended = [
        f"{path.name}:{part.lineno}"
        for path in FILES
        if re.search(r"^ *match ", text := path.read_text(), re.MULTILINE)
        for part in ast.walk(ast.parse(text))
        if isinstance(part, ast.Match) and _classes_of(part) & names and not _ends_in_assert_never(part)
    ]
    assert open_ended == []


def _classes_of(match: ast.Match) -> set[str]:
    """The classes that the cases themselves are, not those within them."""
    patterns = [one for case in match.cases for one in [case.pattern, *getattr(case.pattern, "patterns", [])]]
    classes = [ast.unparse(one.cls) for one in patterns if isinstance(one, ast.MatchClass)]
    return {name.rpartition(".")[2] for name in classes}


def _ends_in_assert_never(match: ast.Match) -> bool:
    return ast.unparse(match.cases[-1].body[-1]).startswith("assert_never(")


def test_tests_share_what_is_in_support() -> None:
    """No test imports from another one; the benchmarks and their short form are programs of their own."""
    shared = ("tests.support", "tests.bench")
    foreign = [
        f"{path.relative_to(ROOT)}: {module}"
        for path in (ROOT / "tests").rglob("*.py")
        for module in re.findall(r"^ *from (tests\.\S+) import", path.read_text(), re.MULTILINE)
        if not module.startswith(shared)
    ]
    assert foreign == []
