"""States of lifts, doors, dispensers and lanes, one in each message."""

from typing import Any

import pytest

from fleet_tui.model.fleets.events import FacilityReported
from fleet_tui.model.fleets.facility import Facility
from fleet_tui.text.errors import WireError
from tests.support.rmf import adapter, read


def told(key: str, message: dict[str, Any]) -> Facility:
    (event,) = read(adapter(), key, message)
    assert isinstance(event, FacilityReported)
    return event.facility


def lift(**more: Any) -> dict[str, Any]:
    usual = {"lift_name": "a", "current_floor": "L1", "destination_floor": "L1", "door_state": 0}
    return {**usual, "motion_state": 0, "current_mode": 2, "session_id": "", **more}


@pytest.mark.parametrize(
    ("changed", "state", "fault"),
    [
        ({}, "at L1, doors closed", ""),
        ({"destination_floor": "L3", "door_state": 1}, "L1 to L3, doors moving", ""),
        ({"current_mode": 3, "door_state": 2}, "fire mode, at L1, doors open", "fire mode"),
        ({"current_mode": 1}, "human mode, at L1, doors closed", ""),
        ({"current_mode": 77, "current_floor": "", "destination_floor": ""}, "mode 77, doors closed", ""),
    ],
)
def test_a_lift_is_told_with_its_mode_place_and_doors(
    changed: dict[str, Any], state: str, fault: str
) -> None:
    one = told("lifts", lift(**changed))
    assert (one.sort, one.name, one.state, one.fault) == ("lift", "a", state, fault)


def test_a_lift_names_the_robot_that_has_it() -> None:
    assert told("lifts", lift(session_id="tiny/t1")).user == "tiny/t1"


def test_doors_dispensers_and_ingestors_are_told_by_their_modes() -> None:
    door = told("doors", {"door_name": "d", "current_mode": {"value": 3}})
    assert (door.sort, door.state, door.fault) == ("door", "offline", "offline")
    busy = {"guid": "g", "mode": 1, "request_guid_queue": ["a", "b"], "seconds_remaining": 12.4}
    assert told("dispensers", busy).state == "busy, 2 requests, 12 s left"
    assert told("ingestors", {"guid": "g", "mode": 2}).fault == "offline"


def test_closed_lanes_are_the_numbers_of_their_fleet() -> None:
    lanes = told("lanes", {"fleet_name": "tiny", "closed_lanes": [3, 5], "speed_limits": []})
    assert (lanes.name, lanes.closed) == ("tiny", ("3", "5"))


def test_a_message_without_a_name_is_none_and_a_broken_one_is_named() -> None:
    assert read(adapter(), "lifts", lift(lift_name="")) == []
    with pytest.raises(WireError, match="current_mode"):
        read(adapter(), "doors", {"door_name": "d"})
