"""Whatever stands on the command line: a documented exit code, soon, and text that acts on nobody."""

import json
import os
import subprocess
import sys
import unicodedata
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import click
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from fleet_tui.main import commands

pytestmark = pytest.mark.nightly

CODES = {0, 1, 2, 3, 130}
"""docs/commands.md, README."""

Run = Callable[[list[str]], dict[str, Any]]

# No path out of the folder it runs in, nor to another's home.
LETTERS = st.characters(exclude_characters="/~\0", exclude_categories=()).filter(
    lambda letter: not 0xD800 <= ord(letter) < 0xDC80 and not 0xDCFF < ord(letter) < 0xE000
)
WORDS = """
- -- -h -= --help --debug nan 1e999 -1 0 1_0 0x10 99999999999999999999 %s [[ ² ws://[ ws://a:99999
ws://127.0.0.1:1 fine.toml bad.toml /dev/null/x /proc/nowhere robot_0 all Base 2h 12:00 json
stuck:robot_0 late=2 robot:x by: since:zz
"""
ODD = ["", " ", "\n", "\x1b]52;c;eA==\x07", "\u202e", "\udcff\udc9b31m", "x" * 100_000]
HOSTILE = st.sampled_from(WORDS.split() + ODD)
TEXT = HOSTILE | st.text(LETTERS, max_size=20)


def leaves(
    command: click.Command, path: tuple[str, ...] = ()
) -> Iterator[tuple[tuple[str, ...], click.Command]]:
    """Every command with what is typed to reach it, groups too."""
    yield path, command
    if isinstance(command, click.Group):
        context = click.Context(command)
        for name in command.list_commands(context):
            found = command.get_command(context, name)
            assert found is not None
            yield from leaves(found, (*path, name))


def value(kind: Any) -> st.SearchStrategy[str]:
    """Mostly what is asked for, and anything else."""
    if isinstance(kind, click.Choice):
        return st.sampled_from([str(choice) for choice in kind.choices]) | TEXT
    if isinstance(kind, click.types.IntParamType):
        return st.integers(-2, 30).map(str) | TEXT
    if isinstance(kind, click.types.FloatParamType):
        return st.sampled_from(["0.1", "0.3", "1"]) | st.floats().map(str) | TEXT
    return TEXT


def part(param: click.Parameter) -> st.SearchStrategy[list[str]]:
    """An option with its value, or an argument."""
    if isinstance(param, click.Option):
        name = st.sampled_from(param.opts)
        return (
            name.map(lambda opt: [opt])
            if param.is_flag
            else st.builds(lambda *two: [*two], name, value(param.type))
        )
    return st.lists(TEXT, max_size=3)


def lines(path: tuple[str, ...], command: click.Command) -> st.SearchStrategy[list[str]]:
    """Command lines for a command: some of what it takes, in any order, and sometimes something else."""
    parts = st.one_of([part(param) for param in command.params] + [TEXT.map(lambda text: [text])])
    return st.lists(parts, max_size=5).map(
        lambda found: [*path, *(word for words in found for word in words)]
    )


LINES = st.sampled_from(list(leaves(commands))).flatmap(lambda one: lines(*one))


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Run]:
    folder = tmp_path_factory.mktemp("fuzz")
    fine = '[rosbridge]\nurl = "ws://127.0.0.1:1"\n[[floors]]\nname = "f"\n[[robots]]\nname = "robot_0"\n'
    (folder / "config.toml").write_text(fine)
    (folder / "fine.toml").write_text(fine)
    (folder / "bad.toml").write_text("x = \x01")
    home = {name: str(folder) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME")}
    root = str(Path(__file__).parents[1])
    with subprocess.Popen(
        [sys.executable, "-m", "tests.support.forked_cli"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=folder,
        env={**os.environ, **home, "PYTHONUTF8": "1", "PYTHONPATH": root},
        text=True,
    ) as child:
        assert child.stdin is not None and child.stdout is not None

        def ask(arguments: list[str]) -> dict[str, Any]:
            assert child.stdin is not None and child.stdout is not None
            child.stdin.write(json.dumps(arguments) + "\n")
            child.stdin.flush()
            answer: dict[str, Any] = json.loads(child.stdout.readline())
            return answer

        yield ask
        child.stdin.close()


@pytest.mark.timeout(300)
@settings(max_examples=60, suppress_health_check=list(HealthCheck))
@given(arguments=LINES)
@example(arguments=["order", "robot_0", "\udcff", "--timeout", "nan"])
@example(arguments=["--config", "\udc9b"])
@example(arguments=["config", "init", "--from-live", "ws://["])
def test_any_command_line(run: Run, arguments: list[str]) -> None:
    done = run(arguments)
    said = done["said"].encode("latin-1").decode("utf-8")
    assert done["code"] in CODES and "Traceback" not in said, said
    assert done["took"] < 15.0
    letters = {unicodedata.category(letter) for letter in set(said.replace("\r\n", "\n")) - {"\n"}}
    assert not letters & {"Cc", "Cf", "Cs", "Co", "Cn"}, said
