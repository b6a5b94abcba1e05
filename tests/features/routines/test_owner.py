"""One owner of a robot at a time, whatever process it runs in."""

import subprocess
import sys
from pathlib import Path

import pytest

from fleet_tui.features.routines.owner import RobotLocks, owner_of
from fleet_tui.text.errors import RoutineError

ROBOTS = {"robot_0": "ws://a", "robot_1": "ws://a"}
HOLDER = """
import sys
from pathlib import Path
from fleet_tui.features.routines.owner import RobotLocks
RobotLocks(Path(sys.argv[1]), {"robot_1": "ws://a"}, "ana\\x1b[2J (process 7)").claim()
print("claimed", flush=True)
sys.stdin.read()
"""


def test_another_process_is_named(tmp_path: Path) -> None:
    holder = subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(tmp_path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    assert holder.stdout is not None and holder.stdout.readline() == b"claimed\n"
    with pytest.raises(RoutineError, match="robot_1 is run by ana") as refused:
        RobotLocks(tmp_path, ROBOTS, "eva").claim()
    assert "\x1b" not in str(refused.value)
    assert owner_of(tmp_path, "robot_1", "ws://a").endswith("(process 7)")
    assert owner_of(tmp_path, "robot_0", "ws://a") == "", "what was claimed before the refusal is free again"
    holder.communicate()
    RobotLocks(tmp_path, ROBOTS, "eva").claim()


def test_robots_of_two_sites_may_share_a_name(tmp_path: Path) -> None:
    one = RobotLocks(tmp_path, {"robot_0": "ws://a"}, "ana")
    one.claim()
    RobotLocks(tmp_path, {"robot_0": "ws://b"}, "eva").claim()
    assert owner_of(tmp_path, "robot_0", "ws://a") == "ana"
    one.release()
    assert owner_of(tmp_path, "robot_0", "ws://a") == ""


def test_a_folder_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RoutineError, match="make it writable"):
        RobotLocks(tmp_path / "file", ROBOTS, "ana").claim()
