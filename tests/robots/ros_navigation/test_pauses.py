"""Substitutes for a pause: which one a profile asks for, also where it is only half written."""

from msgspec.structs import replace

from fleet_tui.model import kind
from fleet_tui.model.commands import PauseRobot, ResumeRobot
from fleet_tui.model.kind import PAUSE
from fleet_tui.model.navigation import ReportedMotion
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.robots.adapter import Publication, ServiceCall, Site
from fleet_tui.robots.nav2.adapter import Nav2
from fleet_tui.robots.nav2.goals import CANCEL_TYPE
from fleet_tui.robots.profile import Profile
from tests.support.nav2_adapter import adapter, robot

ROBOT = Robot("tb2", 1, "rosbridge", {})


def test_a_lock_without_its_topic_is_no_pause_and_says_what_lacks() -> None:
    it = Nav2(Profile(kind="nav2", settings={"nav2": {"pause": "lock"}}), Site())
    assert PAUSE not in it.kind.accepts
    assert it.kind.lack(PAUSE) == "profile.topics.pause_navigation is empty: no pause"


def test_a_pause_service_without_one_to_resume_is_not_called() -> None:
    it = Nav2(Profile(kind="nav2", services={"pause": "/{robot}/pause"}), Site())
    assert it.kind.holds
    calls = it.outgoing(PauseRobot("tb2"), 1, ROBOT)
    assert {call.type for call in calls if isinstance(call, ServiceCall)} == {CANCEL_TYPE}


def locks(command_id: int, at: float) -> bool:
    """Whether a pause locks a robot that was paused at second 0 and moves at another."""
    motion = Reading(ReportedMotion(True, 0.0), at)
    moving = replace(robot(), paused_by_us=True, paused_since=0.0, motion=motion)
    it = adapter(topics={"pause_navigation": "/{robot}/lock"})
    return any(isinstance(one, Publication) for one in it.outgoing(PauseRobot("tb2"), command_id, moving))


class TestPauses:
    def test_hold_is_what_stands_in(self) -> None:
        assert adapter().kind.holds and adapter().kind.can(kind.PAUSE)

    def test_a_lock_is_published(self) -> None:
        it = adapter(topics={"pause_navigation": "/{robot}/lock"}, settings={"nav2": {"pause": "lock"}})
        assert not it.kind.holds and it.kind.can(kind.PAUSE)
        said = [it.outgoing(one, 1, robot()) for one in (PauseRobot("tb2"), ResumeRobot("tb2"))]
        assert said == [
            (Publication("/tb2/lock", "std_msgs/Bool", {"data": True}),),
            (Publication("/tb2/lock", "std_msgs/Bool", {"data": False}),),
        ]

    def test_a_second_pause_locks_a_robot_that_the_first_one_did_not_stop(self) -> None:
        it = adapter(topics={"pause_navigation": "/{robot}/lock"})
        locked, released = (Publication("/tb2/lock", "std_msgs/Bool", {"data": one}) for one in (True, False))
        paused = replace(robot(), paused_by_us=True, paused_since=0.0)
        moving, standing = (
            replace(paused, motion=Reading(ReportedMotion(is_moving, 0.0), 4.0))
            for is_moving in (True, False)
        )
        assert it.kind.holds and it.kind.may_lock
        assert list(it.publications("tb2")) == [("/tb2/lock", "std_msgs/Bool")]
        assert it.outgoing(PauseRobot("tb2"), 1, moving)[0] == locked
        for one in (replace(moving, paused_by_us=False), standing, paused):
            assert locked not in it.outgoing(PauseRobot("tb2"), 1, one)
        locked_by_us = replace(moving, locked_by_us=True)
        assert it.outgoing(ResumeRobot("tb2"), 1, locked_by_us) == [released]

    def test_a_pause_given_twice_while_the_robot_brakes_locks_nothing(self) -> None:
        assert not locks(1, at=2.9)

    def test_a_pause_that_the_console_repeats_by_itself_locks_nothing(self) -> None:
        assert locks(1, at=4.0) and not locks(0, at=4.0)

    def test_a_resume_leaves_the_lock_of_another(self) -> None:
        it = adapter(topics={"pause_navigation": "/{robot}/lock"})
        assert not it.outgoing(ResumeRobot("tb2"), 1, replace(robot(), paused_by_us=True))

    def test_two_services_come_before_hold(self) -> None:
        it = adapter(services={"pause": "/{robot}/hold", "resume": "/{robot}/go"})
        assert not it.kind.holds
        assert it.outgoing(PauseRobot("tb2"), 1, robot()) == (
            ServiceCall("/tb2/hold", "std_srvs/Trigger", {}),
        )

    def test_without_any_this_kind_has_no_pause(self) -> None:
        it = adapter(settings={"nav2": {"pause": ""}})
        assert not it.kind.can(kind.PAUSE) and it.kind.lack(kind.PAUSE) == "this kind has no pause"
