"""`fleet-tui history`: what it prints of a shift, as text, JSON and CSV."""

import csv
import io
import json
from pathlib import Path

import pytest

from tests.support.command_line import run
from tests.support.routine_files import ONE_ROBOT
from tests.support.shift import an_hour_ago, shift, written


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "config.toml").write_text(ONE_ROBOT)
    written(tmp_path, [*shift(an_hour_ago()), *shift(an_hour_ago() + 1, "robot_1")])
    return tmp_path


def test_everything_oldest_first_and_nothing_that_acts_on_the_terminal(site: Path) -> None:
    done = run("history", cwd=site)
    *lines, last = done.stdout.splitlines()
    assert done.returncode == 0 and len(lines) == 15 and "\x1b" not in done.stdout
    assert last.startswith("nobody watches since ") and last.endswith("fleet-tui history --collect`")
    assert lines[2].endswith("robot_0 order 1 Base -> Store: done (waited 10 s, driven in 60 s)")
    assert sum(line.endswith("rosbridge link: lost (connection refused)") for line in lines) == 2
    assert sorted(line[:14] for line in lines) == [line[:14] for line in lines]


def test_by_robot_words_and_time(site: Path) -> None:
    of_robot = run("history", "--robot", "robot_1", "lost", cwd=site).stdout.splitlines()
    assert len(of_robot) == 2 and "robot_1 order 2 Store -> Base: lost (left the queue" in of_robot[0]
    without = run("history", "!order", "!link", "!robot_1", cwd=site).stdout
    assert "order" not in without and "stuck alarm" in without
    assert run("history", "--since", "2m", cwd=site).stdout.startswith("nothing happened since ")


def test_json_has_events_and_seconds_of_each_robot(site: Path) -> None:
    told = json.loads(run("history", "--json", "--robot", "robot_0", cwd=site).stdout)
    assert told["version"] == 1
    assert told["robots"] == {"robot_0": {"driving": 60.0, "blocked": 300.0, "idle": 1420.0}}
    done, lost, alarm, command = told["events"]
    assert (done["kind"], done["outcome"], done["trouble"]) == ("order", "done", False)
    assert (lost["outcome"], lost["trouble"]) == ("lost", True) and "left the queue" in lost["detail"]
    assert alarm["what"] == "stuck alarm, stuck for 60 s" and command["operator"] == "ana"
    assert done["time"] < done["ended"]


def test_csv_is_for_a_spreadsheet_and_runs_nothing(site: Path) -> None:
    rows = list(csv.DictReader(io.StringIO(run("history", "--csv", cwd=site).stdout)))
    assert len(rows) == 15 and {row["kind"] for row in rows} == {"order", "alarm", "command", "link", "note"}


@pytest.mark.parametrize(
    ("args", "code", "said"),
    [
        (("--json", "--csv"), 2, "--json and --csv exclude each other"),
        (("--since", "yesterday"), 2, "'yesterday' is not a time: use 30m, 2h"),
        (("--since", "2999-01-01"), 2, "2999-01-01 is not in the past"),
        (("--url", "ws://127.0.0.1:1"), 1, "no history of ws://127.0.0.1:1 yet"),
    ],
)
def test_what_can_not_be_answered(site: Path, args: tuple[str, ...], code: int, said: str) -> None:
    done = run("history", *args, cwd=site)
    assert (done.returncode, done.stdout) == (code, "") and said in done.stderr
