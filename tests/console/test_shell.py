"""Commands without a screen: their options, and what is passed on of them."""

from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner, Result

from fleet_tui.config.schema import Config, RecordingConfig
from fleet_tui.console.shell import headless

CONFIG = Config(recording=RecordingConfig(rotate_mb=7, rotate_minutes=2, keep=3))


def invoked(*args: str) -> Result:
    return CliRunner().invoke(headless, args)


@pytest.fixture
def passed(monkeypatch: pytest.MonkeyPatch) -> list[tuple[Any, ...]]:
    """The arguments of each command."""
    found: list[tuple[Any, ...]] = []

    def run(*arguments: Any) -> int:
        found.append(arguments)
        return 0

    monkeypatch.setattr("fleet_tui.config.log_file.log_to_file", lambda _debug: None)
    monkeypatch.setattr("fleet_tui.cli.chosen.chosen", lambda *_: CONFIG)
    monkeypatch.setattr("fleet_tui.cli.chosen.chosen_to_examine", lambda *_: (CONFIG, "nobody"))
    for name in ("features.recording.cli.record", "features.doctor.run.doctor", "cli.status.status.status"):
        monkeypatch.setattr(f"fleet_tui.{name}", run)
    return found


def test_json_is_no_one_line() -> None:
    found = invoked("status", "--json", "--oneline")
    assert (found.exit_code, found.stdout) == (2, "") and "exclude each other" in found.stderr


@pytest.mark.parametrize(
    ("options", "limits"),
    [((), (7e6, 120.0, 3)), (("--rotate-mb", "2", "--rotate-every", "30m", "--keep", "0"), (2e6, 1800.0, 0))],
)
def test_limits_of_a_recording_are_the_configurations_unless_given(
    passed: list[tuple[Any, ...]], options: tuple[str, ...], limits: tuple[float, float, int]
) -> None:
    assert invoked("record", "x.gz", "--for", "45s", *options).exit_code == 0
    ((config, path, found, seconds, *_),) = passed
    assert (config, path, seconds) == (CONFIG, Path("x.gz"), 45.0)
    assert (found.part_bytes, found.part_seconds, found.kept) == limits


def test_the_doctor_gets_the_time_that_is_left_and_its_words_are_packed(
    passed: list[tuple[Any, ...]], monkeypatch: pytest.MonkeyPatch
) -> None:
    def doctor(*arguments: Any) -> int:
        passed.append(arguments)
        arguments[3](click.style("1 ok", fg="green"))
        return 1

    packed: list[tuple[str, str]] = []
    monkeypatch.setattr("fleet_tui.features.doctor.run.doctor", doctor)

    def pack(_config: object, report: str, form: str) -> str:
        packed.append((report, form))
        return "packed as x.zip"

    monkeypatch.setattr("fleet_tui.features.recording.bundle.pack", pack)
    found = invoked("doctor", "--bundle", "--timeout", "9", "--robot", "robot_0")
    ((_, timeout, as_json, _, robot, unnamed),) = passed
    assert 8.0 < timeout <= 9.0 and (as_json, robot, unnamed) == (False, "robot_0", "nobody")
    assert found.exit_code == 1 and found.stdout.endswith("packed as x.zip\n")
    assert packed == [("1 ok\n", "txt")], "without colours"
    whole = invoked("doctor", "--bundle", "--json")
    assert "packed" not in whole.stdout and "packed" in whole.stderr


def test_words_and_options_of_the_audit_are_one_search(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[str, bool, bool]] = []

    def write(words: str, as_csv: bool, demo: bool, _out: object) -> str:
        asked.append((words, as_csv, demo))
        return "no such log\x1b"

    monkeypatch.setattr("fleet_tui.features.audit.cli.write_records", write)
    found = invoked("audit", "refused", "order", "--robot", "robot_0", "--since", "2h", "--csv")
    assert asked == [("refused order robot:robot_0 since:2h", True, False)]
    assert found.stdout == "" and "no such log" in found.stderr and "\x1b" not in found.stderr
