"""Pauses of robots with Nav2 whose profile is only half written."""

from fleet_tui.adapters.adapter import ServiceCall, Site
from fleet_tui.adapters.nav2.adapter import Nav2
from fleet_tui.adapters.nav2.goals import CANCEL_TYPE
from fleet_tui.adapters.profile import Profile
from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.kind import PAUSE
from fleet_tui.model.robot import Robot

ROBOT = Robot("tb2", 1, "rosbridge", {})


def test_a_lock_without_its_topic_is_no_pause_and_says_what_lacks() -> None:
    it = Nav2(Profile(kind="nav2", settings={"nav2": {"pause": "lock"}}), Site())
    assert PAUSE not in it.kind.accepts
    assert it.kind.lack(PAUSE) == "profile.topics.pause_navigation is empty: no pause"


def test_a_pause_service_without_one_to_resume_is_not_called() -> None:
    it = Nav2(Profile(kind="nav2", services={"pause": "/{robot}/pause"}), Site())
    assert it.kind.holds
    calls = it.outgoing(PauseRobot("tb2"), 1, ROBOT)
    assert [call.type for call in calls if isinstance(call, ServiceCall)] == [CANCEL_TYPE, CANCEL_TYPE]
