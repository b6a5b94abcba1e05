"""Fleets are found in messages, not by names of topics."""

from fleet_tui.adapters.discovery import Listed
from fleet_tui.adapters.rmf.discovery import discover


def test_topics_name_no_robot() -> None:
    assert not discover(Listed({"/fleet_states": "rmf_fleet_msgs/msg/FleetState"}, {})).robots
