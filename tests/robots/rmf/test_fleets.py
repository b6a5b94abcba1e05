"""States of fleets: each robot by its name, as old as its driver says, and no bad one at the others' cost."""

from typing import Any

import pytest

from fleet_tui.model.events import MessageRejected
from fleet_tui.model.fleets.events import MemberReported, StatusReported
from fleet_tui.model.geometry import Pose
from fleet_tui.text.errors import WireError
from tests.support.rmf import TINY, adapter, member, read, text


def test_a_fleet_reports_its_own_robots_with_the_clock_of_their_driver() -> None:
    (found,) = read(adapter(), "fleets", {"name": "tiny", "robots": [member("t1"), member("stranger")]})
    assert found == MemberReported(TINY, 5.0, Pose(1.0, 2.0, 0.5), "L2", 7.0, 80.0, "moving", "")


@pytest.mark.parametrize(
    ("more", "mode"),
    [
        ({"mode": {"mode": 5, "performing_action": ""}}, "emergency"),
        ({"mode": {"mode": 10, "performing_action": "clean"}}, "performing clean"),
        ({"mode": {"mode": 77}}, "mode 77"),
    ],
)
def test_modes_have_words(more: dict[str, Any], mode: str) -> None:
    (found,) = read(adapter(), "fleets", {"name": "tiny", "robots": [member("t1", **more)]})
    assert isinstance(found, MemberReported) and found.mode == mode


def test_a_bad_robot_costs_only_itself() -> None:
    robots = [member("t1", battery_percent=300.0), member("t2")]
    bad, good = read(adapter(), "fleets", {"name": "tiny", "robots": robots})
    assert isinstance(bad, MessageRejected) and (bad.robot, bad.text) == (
        TINY,
        "battery is 300 %, not between 0 and 100",
    )
    assert isinstance(good, MemberReported) and good.robot == "tiny/t2"
    with pytest.raises(WireError, match="fleet tiny: robots"):
        read(adapter(), "fleets", {"name": "tiny", "robots": [{"name": "t1"}]})


def test_a_battery_of_the_adapter_is_0_to_1_and_one_of_the_driver_0_to_100() -> None:
    place = {"map": "L1", "x": 1.0, "y": 0.0, "yaw": 0.0}
    issues = [{"category": "lift", "detail": {"name": "L"}}, "odd", {}]
    robot = {"status": "working", "task_id": "p1", "battery": 0.8, "location": place, "issues": issues}
    data = {"name": "tiny", "robots": {"t1": robot, "stranger": {}}}
    (found,) = read(adapter(), "statuses", text({"type": "fleet_state_update", "data": data}))
    assert found == StatusReported(
        TINY, 5.0, "working", "p1", ("lift: name: L", "odd"), Pose(1.0, 0.0), "L1", 80.0
    )


def test_a_robot_without_a_position_costs_no_other_of_its_fleet() -> None:
    place = {"x": None, "y": 0.0, "yaw": 0.0}  # NaN, as its JSON has it
    data = {"name": "tiny", "robots": {"t1": {"location": place}, "t2": {"status": "idle"}}}
    bad, good = read(adapter(), "statuses", text({"data": data}))
    assert isinstance(bad, MessageRejected) and bad.robot == TINY and "location.x" in bad.text
    assert isinstance(good, StatusReported) and (good.robot, good.status) == ("tiny/t2", "idle")


def test_a_place_that_is_none_is_refused() -> None:
    data = {"name": "tiny", "robots": {"t1": {"location": {"x": 1e99, "y": 0.0, "yaw": 0.0}}}}
    (found,) = read(adapter(), "statuses", text({"data": data}))
    assert isinstance(found, MessageRejected) and "location" in found.text
