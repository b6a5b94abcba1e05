"""`[[programs]]`: every mistake is told with its place and remedy."""

import pytest

from fleet_tui.config.load import from_text
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.text.errors import ConfigError

FLEET = '[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n'


def problems(text: str) -> list[str]:
    try:
        from_text(FLEET + text)
    except ConfigError as refused:
        return refused.problems
    return []


def entry(**keys: object) -> str:
    lines = {"name": "p", **keys}
    return "[[programs]]\n" + "".join(f"{key} = {value!r}\n" for key, value in lines.items()).replace(
        "True", "true"
    )


def test_every_form_is_read() -> None:
    text = entry(name="a", unit="nav.service", user=True) + entry(
        name="b", start=["roslaunch", "x"], host="server"
    )
    text += entry(name="c", start=["s"], stop=["t"], status=["u"], log=["l"], needs=["a", "b"])
    unit, kept, own = from_text(FLEET + text).programs
    assert unit == ProgramEntry("a", unit="nav.service", user=True)
    assert kept.is_kept and not unit.is_kept and not own.is_kept
    assert own.needs == ["a", "b"]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (entry(), "programs[0].start: missing: set unit"),
        (
            entry(unit="a.service", start=["x"]),
            "programs[0].unit: use unit or start, stop and status, not both",
        ),
        (entry(start=["x"], stop=["y"]), "programs[0].status: missing: stop needs it"),
        (entry(start=["x"], status=["y"]), "programs[0].stop: missing: status needs it"),
        (entry(start=["x"], user=True), "programs[0].user: only for a unit"),
        (entry(start=[""]), "programs[0].start: begins with an empty text"),
        (entry(name="-rf", start=["x"]), "programs[0].name: '-rf'"),
        (entry(name="../x", start=["x"]), "programs[0].name: '../x'"),
        (entry(unit="--all"), "programs[0].unit: '--all' is not the name of a unit"),
        (entry(unit="ros*"), "programs[0].unit: 'ros*'"),
        (entry(start=["x"], host="-oProxyCommand=x"), "programs[0].host: '-oProxyCommand=x' is not a host"),
        (entry(start=["x"], host="a;b"), "programs[0].host: 'a;b'"),
        (entry(start=["x"], needs=["p"]), "programs[0].needs: p needs itself"),
        (entry(start=["x"]) + entry(start=["y"]), "programs: name p used 2 times"),
        (
            entry(name="bridge", start=["x"], needs=["brige"]),
            "programs[0].needs: unknown program 'brige', did you",
        ),
        ("".join(entry(name=f"p{n}", start=["x"]) for n in range(101)), "programs: 101 entries, at most 100"),
        ('[[programs]]\nname = "p"\nstart = ["a\\u0000b"]\n', "programs[0].start: contains a null character"),
        ('[[programs]]\nname = "p"\nstart = "ls; rm"\n', "programs[0].start: expected a list"),
        ('[[programs]]\nname = "p"\nstart = ["x"]\nshell = true\n', "programs[0].shell: unknown key"),
    ],
)
def test_a_mistake_is_named(text: str, problem: str) -> None:
    assert any(found.startswith(problem) for found in problems(text)), problems(text)
