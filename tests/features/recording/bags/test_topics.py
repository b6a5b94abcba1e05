"""Topics of a bag that are read, and notes on all others."""

from pathlib import Path

import pytest

from fleet_tui.features.recording.bags.convert import convert
from fleet_tui.features.recording.bags.opening import BagError
from tests.support.bag_replay import MAP, made_of, played, pose
from tests.support.bags import Said, bag_config, written
from tests.support.fleets import F0, R0


def test_another_type_is_not_read_and_the_remedy_is_said(tmp_path: Path) -> None:
    said = [pose(0), Said(1, f"/{R0}/battery", "std_msgs/msg/Float64", {"data": 5.0})]
    report, recording = made_of(written(tmp_path, "ros1", said), bag_config("ros1"), tmp_path / "r.jsonl.gz")
    problem = (
        "/robot_0/battery has type std_msgs/msg/Float64, not std_msgs/Float32:"
        " correct profile.topics.battery or profile.types.battery"
    )
    assert problem in report.notes and report.messages == 1
    robot = played(recording).robots[R0]
    assert robot.battery is None and robot.last_fault == problem


def test_what_is_missing_is_said_once_with_the_nearest_name(tmp_path: Path) -> None:
    said = [
        pose(0),
        Said(0, f"/{R0}/action_queue", "ActionQueue", {}),
        Said(0, "/tf\x1b[2J", "std_msgs/msg/Bool", {}),
    ]
    config = bag_config("ros1", robots=3)
    report, _ = made_of(written(tmp_path, "ros1", said), config, tmp_path / "r.jsonl.gz")
    assert report.notes[1:] == [
        "not in the bag: robot_1, robot_2",
        "not in the bag: /robot_0/queue, did you mean /robot_0/action_queue?, /robot_0/obstacle,"
        " /robot_0/battery, /robot_0/cargo, /robot_0/floor_0/graph and 3 more (correct [profile.topics])",
        "in the bag, not used: /robot_0/action_queue, /tf\x1b[2J",
    ]


def test_a_bag_of_other_robots_is_refused(tmp_path: Path) -> None:
    bag = written(tmp_path, "ros1", [pose(0, robot="agv_1")])
    with pytest.raises(BagError) as raised:
        convert(bag, bag_config("ros1"), tmp_path / "r.jsonl.gz")
    assert str(raised.value) == (
        f"{bag}: none of the configured topics is in the bag: not /robot_0/pose;"
        " it has /agv_1/pose: correct [profile.topics] or [[robots]]"
    )
    assert not (tmp_path / "r.jsonl.gz").exists()


def test_of_many_live_maps_the_first_robots_stay(tmp_path: Path) -> None:
    grid = {"info": {"resolution": 1.0, "width": 2, "height": 1, "origin": {"orientation": {"w": 1.0}}}}
    said = [Said(0, f"/robot_{n}/{F0}/map", MAP, {**grid, "data": [n, n]}) for n in range(6)]
    config = bag_config("mcap", robots=6)
    report, recording = made_of(written(tmp_path, "mcap", said), config, tmp_path / "r.jsonl.gz")
    robots = played(recording).robots
    assert [name for name, robot in robots.items() if robot.maps[F0].grid] == [f"robot_{n}" for n in range(4)]
    assert f"4 of 6 live maps read, not /robot_4/{F0}/map, /robot_5/{F0}/map" in report.notes
