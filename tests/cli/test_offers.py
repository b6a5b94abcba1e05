"""Offers of the shell completion, asked for as the script asks."""

from pathlib import Path

import pytest

from tests.support.command_line import run

CONFIG = """
[[floors]]
name = "floor_0"
graph = "hall.graph"
[[robots]]
name = "robot_0"
[[robots]]
name = "carrier"
[[programs]]
name = "laser"
start = ["true"]
"""

GRAPH = """fleet_tui_graph: 1
floors:
  floor_0:
    vertices:
      - {id: 1, x: 0, y: 0, label: Base}
      - {id: 2, x: 1, y: 0, label: Store}
      - {id: 3, x: 2, y: 0, label: Dock 7}
      - {id: 4, x: 3, y: 0}
    edges: []
"""


def offered(place: Path, *words: str) -> list[str]:
    """The offers behind these words; the last one is being typed."""
    line = " ".join(["fleet-tui", *words])
    asked = {"_FLEET_TUI_COMPLETE": "bash_complete", "COMP_WORDS": line, "COMP_CWORD": str(len(words))}
    done = run(cwd=place, **asked)
    assert done.stderr == ""
    return done.stdout.split()


@pytest.fixture
def place(tmp_path: Path) -> Path:
    (tmp_path / "config.toml").write_text(CONFIG)
    (tmp_path / "hall.graph").write_text(GRAPH)
    (tmp_path / "routines").mkdir()
    (tmp_path / "routines" / "morning.routine").touch()
    return tmp_path


@pytest.mark.parametrize(
    ("words", "names"),
    [
        (("pause", ""), ["plain,robot_0", "plain,carrier"]),
        (("order", "rob"), ["plain,robot_0"]),
        (("order", "robot_0", ""), ["plain,Base", "plain,Store"]),
        (("order", "robot_0", "Base", "S"), ["plain,Store"]),
        (("goto", "robot_0", "B"), ["plain,Base"]),
        (("doctor", "--robot", "c"), ["plain,carrier"]),
        (("programs", "start", ""), ["plain,laser"]),
        (("routine", "run", ""), ["plain,morning"]),
        (("map", "info", "hall"), ["file,hall"]),
        (("config", "init", "--output", ""), ["file,"]),
        (("--config", "other.toml", "pause", ""), []),
        (("demo", "--kind", "nav2", "--fault", "lost,foreign-g"), ["plain,lost,foreign-goal"]),
    ],
)
def test_names_of_the_configuration_and_of_the_simulator(
    place: Path, words: tuple[str, ...], names: list[str]
) -> None:
    assert offered(place, *words) == names


def test_an_invalid_configuration_offers_what_can_be_read(place: Path) -> None:
    (place / "config.toml").write_text(CONFIG + "[ui]\nspeed = 3\n")
    assert offered(place, "pause", "c") == ["plain,carrier"]
    (place / "config.toml").write_text("[[robots\n")
    assert offered(place, "pause", "") == []


def test_without_a_readable_graph_file_no_place_is_offered(place: Path) -> None:
    (place / "hall.graph").write_text("{")
    assert offered(place, "order", "robot_0", "") == []
    (place / "hall.graph").unlink()
    assert offered(place, "order", "robot_0", "") == []


@pytest.mark.parametrize(
    "name",
    [
        "a\\u001b]2;x\\u0007",
        "b c",
        "x$(id)",
        "x`id`",
        "x;id",
        "x|id",
        "x&id",
        "x>f",
        "x*",
        "~x",
        "x'",
        'x\\"',
        "!x",
        "x{a,b}",
        "-x",
        "=x",
        "x\\\\y",
        "x#y",
        "x?",
        "[x]",
        "x^y",
    ],
)
def test_a_name_that_a_shell_reads_as_more_is_not_offered(place: Path, name: str) -> None:
    """The configuration of a folder may be somebody else's; what Tab has put into a line is run by Enter."""
    (place / "config.toml").write_text(f'[[robots]]\nname = "{name}"\n[[programs]]\nname = "{name}"\n')
    assert offered(place, "pause", "") == []
    assert offered(place, "programs", "start", "") == []


def test_letters_of_any_language_are_offered(place: Path) -> None:
    (place / "config.toml").write_text('[[robots]]\nname = "célula_7"\n')
    assert offered(place, "pause", "c") == ["plain,célula_7"]
