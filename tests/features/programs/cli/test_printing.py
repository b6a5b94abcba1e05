"""`fleet-tui programs log`: the end of a log, or its new lines, with a reason if there is none."""

from pathlib import Path

import pytest

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.features.programs.cli import printing
from fleet_tui.features.programs.cli.printing import print_log
from tests.support.stand_ins import BRIDGE, StandIns


def with_log(*log: str) -> ProgramEntry:
    return ProgramEntry("p", start=["a"], stop=["b"], status=["c"], log=list(log))


async def test_a_units_log_is_printed(stand_ins: StandIns) -> None:
    lines: list[str] = []
    assert await print_log(BRIDGE, False, lines.append, lines.append) == 0
    assert lines == ["2024-05-06 first line", "2024-05-06 \ufffd second\x1b]52;c;eA==\x07"]
    assert "--follow" not in stand_ins.calls[-1]


async def test_a_log_that_follows_ends_when_it_is_quiet() -> None:
    lines: list[str] = []
    assert await print_log(with_log("sh", "-c", "echo a; sleep 60"), False, lines.append, lines.append) == 0
    assert lines == ["a"]


async def test_one_that_floods_ends_as_well(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(printing, "LONGEST", 0.3)
    lines: list[str] = []
    assert await print_log(with_log("yes"), False, lines.append, lines.append) == 0
    assert set(lines) == {"y"}


async def test_a_log_that_fails_says_so(tmp_path: Path) -> None:
    lines, errors = list[str](), list[str]()
    assert await print_log(with_log("sh", "-c", "echo a; exit 2"), True, lines.append, errors.append) == 1
    assert (lines, errors) == (["a"], ["p: the log ended: exit status 2"])
    assert await print_log(with_log("no-such-program"), True, lines.append, errors.append) == 1
    assert errors[1].startswith("p: no-such-program: not found")
