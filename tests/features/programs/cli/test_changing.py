"""`fleet-tui programs start|stop|restart`: permitted, audited, with its outcome."""

from pathlib import Path

import click
import pytest
from msgspec.structs import replace

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.schema import Config, Operator
from fleet_tui.features.programs.cli import changing
from fleet_tui.features.programs.cli.changing import change_program
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.reader import AuditReader
from tests.support.stand_ins import with_status


@pytest.fixture
def state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    return tmp_path / "fleet-tui"


def config(program: ProgramEntry, **operator: bool) -> Config:
    fleet = Config(floors=[FloorEntry("f")], robots=[RobotEntry("r")])
    return replace(fleet, operator=Operator("ana", **operator), programs=[program])


def said(lines: list[tuple[str, bool]]) -> changing.Say:
    return lambda text, err=False: lines.append((text, err))


def test_a_change_is_confirmed_and_in_the_audit_log(state: Path, tmp_path: Path) -> None:
    nav, lines = with_status(tmp_path), list[tuple[str, bool]]()
    assert change_program(config(nav), nav, "start", 20.0, True, said(lines)) == 0
    assert lines == [("nav: start confirmed", False)]
    records = [one for one in AuditReader(state / FILE_NAME).newest_first() if "program" in one.change]
    assert [(one.change, one.words, one.operator) for one in records] == [
        ("program start", "nav: confirmed", "ana"),
        ("program start", "nav: sent", "ana"),
    ]


@pytest.mark.parametrize(("key", "reason"), [("read_only", "is read-only"), ("armed", "is not armed")])
def test_who_may_not_command_starts_nothing(state: Path, tmp_path: Path, key: str, reason: str) -> None:
    nav, lines = with_status(tmp_path), list[tuple[str, bool]]()
    permitted = config(nav, **{key: key == "read_only"})
    assert change_program(permitted, nav, "start", 20.0, True, said(lines)) == 1
    assert reason in lines[0][0] and lines[0][1] and not (tmp_path / "runs").exists()


def test_a_failure_is_1_and_nobody_to_ask_is_usage(
    state: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines: list[tuple[str, bool]] = []
    gone = ProgramEntry("gone", start=["no-such-program"], stop=["x"], status=["false"])
    assert change_program(config(gone), gone, "start", 20.0, True, said(lines)) == 1
    assert "refused (no-such-program: not found" in lines[0][0] and lines[0][1]
    monkeypatch.setattr("sys.stdin.isatty", lambda: False, raising=False)
    with pytest.raises(click.UsageError, match="use --yes"):
        change_program(config(gone), gone, "start", 20.0, False, said(lines))


def test_a_no_at_a_terminal_changes_nothing(
    state: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []

    def refuses(text: str, err: bool) -> bool:
        asked.append(text)
        return False

    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr(click, "confirm", refuses)
    nav = with_status(tmp_path)
    assert change_program(config(nav), nav, "start", 20.0, False, said([])) == 1
    assert asked == ["Start nav? It is stopped."] and not (tmp_path / "runs").exists()
