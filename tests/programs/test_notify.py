"""Alarms for a program of the operator's own."""

import json
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from fleet_tui.config.schema import Notify
from fleet_tui.model import events
from fleet_tui.model.desk.events import AlarmAcknowledged
from fleet_tui.model.fleet import FleetState
from fleet_tui.programs.notify import EVERY, MOST, AlarmProgram
from tests.support.fleets import T0, battery, fleet, link_up, reduced, tick
from tests.support.polling import eventually
from tests.support.users import give, two_users

KEEP = "import sys; open('given', 'a').write(sys.stdin.read() + '--\\n')"


def low(at: float, *robots: int, count: int = 3) -> FleetState:
    """A fleet of which these robots have an empty battery."""
    given = (battery(at, 5.0 if n in robots else 80.0, f"robot_{n}") for n in range(count))
    return reduced(fleet(count), link_up(T0), *given, tick(at))


def said_by(look: Callable[[FleetState], None], said: list[str]) -> list[str]:
    """What is said after looks at an alarm."""

    def come() -> bool:
        look(low(T0, 0))
        return bool(said)

    eventually(come)
    return said


class Night:
    """A console's program, and what came to it."""

    def __init__(self, folder: Path, script: str = KEEP, classes: Sequence[str] = ("battery",)) -> None:
        self.said: list[str] = []
        notify = Notify([sys.executable, "-c", script], list(classes))
        self._program = AlarmProgram(notify, folder, self.said.append)
        self._file = folder / "given"

    def look(self, *states: FleetState) -> None:
        for state in states:
            self._program.look(state)

    @property
    def runs(self) -> list[list[dict[str, object]]]:
        """The lines of each run."""
        given = self._file.read_text().split("--\n")[:-1] if self._file.exists() else []
        return [[json.loads(line) for line in run.splitlines()] for run in given]

    def look_until(self, runs: int, state: FleetState) -> None:
        def come() -> bool:
            self.look(state)
            return len(self.runs) == runs

        eventually(come)

    def names(self, runs: int) -> list[list[object]]:
        eventually(lambda: len(self.runs) == runs)
        return [[line["robot"] for line in run] for run in self.runs]


def test_each_new_alarm_is_a_line_of_json_and_those_of_a_moment_one_run(tmp_path: Path) -> None:
    night = Night(tmp_path)
    night.look(low(T0), low(T0 + 1, 0), low(T0 + 1.5, 0), low(T0 + 2, 0, 1), low(T0 + 3, 0, 1, 2))
    assert night.names(runs=1) == [["robot_0"]]
    line = night.runs[0][0]
    assert line["kind"] == "battery" and line["priority"] == "medium" and line["source"] == "robot_0"
    assert str(line["text"]).startswith("battery") and str(line["time"]).endswith("+00:00")
    night.look_until(2, low(T0 + 1 + EVERY, 0, 1, 2))
    assert night.names(runs=2) == [["robot_0"], ["robot_1", "robot_2"]]


def test_an_alarm_that_comes_back_is_new_and_one_that_was_acknowledged_is_not(tmp_path: Path) -> None:
    night = Night(tmp_path)
    night.look(low(T0, 0), low(T0 + 20), low(T0 + 40, 0))
    seen = reduced(low(T0 + 60, 1), AlarmAcknowledged("robot_1", "battery"), tick(T0 + 60.1))
    night.look_until(2, seen)
    assert night.names(runs=2) == [["robot_0"], ["robot_0"]]


def test_only_wanted_priorities_and_classes(tmp_path: Path) -> None:
    night = Night(tmp_path, classes=["obstacle", "low"])
    night.look(low(T0, 0))
    contact = events.ObstacleReported("robot_1", T0 + 9, 60.0)
    night.look(reduced(low(T0 + 9, 0), contact, tick(T0 + 9)))
    assert night.names(runs=1) == [["robot_1"]]


def test_a_flood_is_bounded_and_what_is_left_out_is_counted(tmp_path: Path) -> None:
    night = Night(tmp_path)
    night.look(low(T0, 0, count=MOST + 50), low(T0 + 1, *range(MOST + 50), count=MOST + 50))
    night.look_until(2, low(T0 + 9, 0, count=MOST + 50))
    assert len(night.runs[1]) == MOST + 1 and night.runs[1][-1] == {"left_out": 49}


def test_a_program_that_fails_hangs_or_does_not_exist_is_told_once_and_nothing_waits(tmp_path: Path) -> None:
    night = Night(tmp_path, "raise SystemExit(3)")
    assert said_by(night.look, night.said) == [
        f"notify: {sys.executable} ended with exit status 3: see the log file"
    ]
    missing: list[str] = []
    program = AlarmProgram(Notify(["no-such-program"], ["medium"]), tmp_path, missing.append)
    said_by(program.look, missing)
    assert missing[0].startswith("notify: no-such-program: not found: install it")


def test_a_program_that_reads_nothing_is_no_failure(tmp_path: Path) -> None:
    night = Night(tmp_path, "open('given', 'a').write('--\\n')")
    night.look(low(T0, 0))
    eventually(lambda: (tmp_path / "given").exists())
    night.look(low(T0 + 1, 0))
    assert night.said == []


def test_without_a_command_nothing_starts(tmp_path: Path) -> None:
    program = AlarmProgram(Notify(), tmp_path, print)
    program.look(low(T0, 0))


@two_users
def test_a_script_that_another_user_made_since_the_start_does_not_run(tmp_path: Path) -> None:
    script = tmp_path / "later.py"
    program = Notify([sys.executable, str(script)], ["low", "medium", "high"])
    said: list[str] = []
    notifying = AlarmProgram(program, tmp_path, said.append)
    script.write_text(f"open({str(tmp_path / 'ran')!r}, 'w')")
    give(script)
    assert said_by(notifying.look, said)[0].startswith("notify: ") and "is not owned by root" in said[0]
    assert not (tmp_path / "ran").exists()
