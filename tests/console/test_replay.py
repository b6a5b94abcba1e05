"""`fleet-tui replay BAG`: from the command line to the console."""

import subprocess
import sys
from pathlib import Path

import pytest

from fleet_tui.features.recording.bags.convert import convert
from tests.support.bag_replay import night
from tests.support.bags import Said, bag_config, written
from tests.support.replay_console import replayed

CONFIG = """
[[floors]]
name = "floor_0"
[[robots]]
name = "robot_0"
"""


def replay(folder: Path, bag: Path) -> tuple[int, list[str]]:
    """The exit code and what is said on stderr, which is no terminal: so no console opens."""
    (folder / "config.toml").write_text(CONFIG)
    command = [sys.executable, "-m", "fleet_tui", "replay", "--config", str(folder / "config.toml"), str(bag)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=50)
    assert done.stdout == ""
    return done.returncode, done.stderr.splitlines()


def test_what_a_bag_lacks_is_said_and_no_control_character_with_it(tmp_path: Path) -> None:
    bag = written(tmp_path, "ros1", [*night(), Said(1, "/tf\x1b[2J", "std_msgs/msg/Bool", {})])
    code, said = replay(tmp_path, bag)
    assert said == [
        "from ROS bag night.bag: a bag has no console commands and no link states",
        "not in the bag: /robot_0/obstacle (correct [profile.topics])",
        "in the bag, not used: /tf␛[2J",
        "fleet-tui: the console needs a terminal for input, output and errors: over SSH use ssh -t",
    ]
    assert code == 1


def test_a_bag_that_can_not_be_read_is_one_line_and_exit_code_2(tmp_path: Path) -> None:
    bag = tmp_path / "a\x1b[2J.bag"
    bag.write_text("#ROSBAG")
    code, [said] = replay(tmp_path, bag)
    assert code == 2 and said == f"{tmp_path}/a␛[2J.bag: not a bag"


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_the_console_says_that_it_is_a_bag(tmp_path: Path, size: tuple[int, int]) -> None:
    made = tmp_path / "r.jsonl.gz"
    report = convert(written(tmp_path, "ros1", night()), bag_config("ros1"), made)
    async with replayed(made, "+5s", size, report.notes) as running:
        assert "REPLAY 2023-11-1" in running.text.splitlines()[0]
        assert size[0] < 100 or "● rosbag://night.bag" in running.text.splitlines()[0]
        assert "from ROS bag night.bag" in running.text
        await running.shows("25 %")
        await running.shows("Grüße ☃")
