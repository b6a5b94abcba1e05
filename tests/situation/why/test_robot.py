"""Reasons that a robot itself gives: what it says, how late, and where it jumped."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import BridgeAnswered, CommandAdvanced, Event, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.situation.facts import NO_POSE
from fleet_tui.situation.why.reason import Strength
from fleet_tui.situation.why.robot import stale_pose
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    battery,
    commanded,
    fleet,
    link_up,
    of_kinds,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.planted_fleet import Planted
from tests.support.situations import driving, first, names


def test_a_pause_names_where_it_came_from_and_the_key() -> None:
    elsewhere = first(driving(then="paused").run(3))
    assert (elsewhere.evidence, elsewhere.keys) == ("not sent by this console", ("resume",))
    planted = driving().command(PauseRobot(R0))
    at = planted.now
    here = first(planted.run(3))
    assert here.evidence == "sent by this console"
    assert here.since == pytest.approx(at)


def test_a_refused_resume_is_named_beside_the_pause() -> None:
    facts = commanded(1, ResumeRobot(R0), Stage.SENT, Stage.REFUSED, detail="key switch is off")
    state = reduced(fleet(), link_up(T0), PausedReported(R0, T0, True), pose(T0), *facts, tick(T0 + 2))
    found = reasons(state, state.robots[R0])
    assert [reason.name for reason in found][:2] == ["paused (elsewhere)", "refused: resume"]
    assert found[1].evidence == "key switch is off"


def test_poses_that_come_late_are_told_from_poses_that_stay_away() -> None:
    """A clogged way: each pose is ten seconds old when it arrives, everything else is fresh."""
    fresh = [pose(T0 + n / 10, stamp=n / 10) for n in range(20)]
    late = [pose(T0 + 12 + n / 10, stamp=2 + n / 10) for n in range(20)]
    facts: list[Event] = [link_up(T0), *fresh, *late, battery(T0 + 14), queue(T0 + 14), tick(T0 + 14)]
    alone = reduced(fleet(), *facts)
    assert reasons(alone, alone.robots[R0])[0].evidence == "poses repeat at rest: their time stamps lag"
    state = reduced(alone, BridgeAnswered(LINK, T0 + 14, 10.0), tick(T0 + 14))
    found = reasons(state, state.robots[R0])[0]
    assert (found.name, found.evidence) == ("messages 10 s late", "bridge of rosbridge overloaded")
    assert "[links]" in found.remedy


def test_a_pose_that_never_came_is_named_with_its_topic() -> None:
    state = reduced(fleet(), link_up(T0), queue(T0 + 4), tick(T0 + 4))
    found = stale_pose(state, state.robots[R0])
    assert found is not None and found.name == "pose missing"
    assert "no pose on /robot_0/pose:" in found.evidence
    assert found.remedy == NO_POSE.action
    bare = of_kinds(state, Kind(reports=("pose",)))
    found = stale_pose(bare, bare.robots[R0])
    assert found is not None and found.evidence == "other reports received, no pose: position unknown"


def test_one_correction_of_the_pose_is_no_jumping() -> None:
    state = reduced(fleet(), link_up(T0), pose(T0), pose(T0 + 0.1, x=30.0), queue(T0), tick(T0 + 2))
    assert [reason.name for reason in reasons(state, state.robots[R0])] == ["no orders"]
    assert len(state.robots[R0].jumps) == 1


def test_a_fast_robot_and_a_long_silence_are_no_jumps() -> None:
    state = reduced(fleet(), *(pose(T0 + n / 10, x=0.4 * n) for n in range(50)), pose(T0 + 60, x=90.0))
    assert state.robots[R0].jumps == ()


def test_leaps_of_long_ago_are_forgotten() -> None:
    leaps = [pose(T0 + n, x=20.0 * (n % 2)) for n in range(5)]
    still = [pose(T0 + 5 + n) for n in range(12)]
    state = reduced(fleet(), link_up(T0), *leaps, *still, queue(T0 + 16), tick(T0 + 16.5))
    assert [reason.name for reason in reasons(state, state.robots[R0])] == ["no orders"]


@pytest.mark.parametrize(
    ("stages", "name"),
    [
        ([Stage.SENT], "pause from this console: sent"),
        ([Stage.SENT, Stage.NO_ANSWER], "pause from this console: no answer"),
        ([Stage.SENT, Stage.UNKNOWN], "pause from this console: outcome unknown"),
    ],
)
def test_a_pause_from_here_that_may_hold_it_is_named_with_the_key(stages: list[Stage], name: str) -> None:
    facts = commanded(1, PauseRobot(R0), *stages)
    still: list[Event] = [pose(T0 - 9), pose(T0 + 1), queue(T0 + 1, (1, 1, 2, "W"), current=1)]
    state = reduced(fleet(), link_up(T0 - 9), *facts, *still, tick(T0 + 2))
    found = reasons(state, state.robots[R0])
    assert found[0].name == name and found[0].keys == ("resume",)


def test_a_pause_that_was_obeyed_late_is_named() -> None:
    facts = commanded(1, PauseRobot(R0), Stage.SENT, Stage.NO_ANSWER)
    state = reduced(fleet(), link_up(T0 - 9), pose(T0 - 9), *facts, pose(T0 + 6), tick(T0 + 6))
    assert state.commands[0].stage is Stage.NOT_CONFIRMED
    assert "pause from this console: not confirmed" in [one.name for one in reasons(state, state.robots[R0])]
    state = reduced(
        state, CommandAdvanced(1, Stage.ACCEPTED, T0 + 12, Message("paused")), pose(T0 + 12), tick(T0 + 12)
    )
    assert reasons(state, state.robots[R0])[0].name == "paused (by us)"


def test_an_obstacle_offers_to_look_and_to_cancel_an_order() -> None:
    with_order, without = driving(then="obstacle:robot_0").run(5), Planted("obstacle:robot_0").run(6)
    assert first(with_order).keys == ("centre", "camera", "laser", "cancel")
    assert first(without).keys == ("centre", "camera", "laser")


def test_no_orders_is_not_told_below_a_certain_cause() -> None:
    assert names(Planted("obstacle:robot_0").run(6).state)[0].startswith("obstacle")
    assert "no orders" not in names(Planted("obstacle:robot_0").run(6).state)
    assert "no orders" in names(Planted().run(6).state)


def late_and_silent(late: float) -> FleetState:
    state = reduced(fleet(2), link_up(T0), pose(T0), pose(T0, robot="robot_1"), tick(T0 + 20))
    return replace(state, links={name: replace(link, late=late) for name, link in state.links.items()})


def test_silence_behind_a_bridge_that_is_late_is_laid_to_the_bridge() -> None:
    bridge, silence = reasons(late_and_silent(25.0), late_and_silent(25.0).robots[R0])[:2]
    assert (bridge.name, bridge.strength) == ("messages 25 s late", Strength.CERTAIN)
    assert (silence.name, silence.strength) == ("silent 20 s", Strength.POSSIBLE)
    assert reasons(late_and_silent(0.0), late_and_silent(0.0).robots[R0])[0].name == "offline 20 s"


def test_silence_of_all_robots_of_a_link_points_to_what_they_share() -> None:
    alone = reduced(late_and_silent(0.0), pose(T0 + 20, robot="robot_1"))
    assert reasons(alone, alone.robots[R0])[0].remedy == CLASSES["offline"].action
    both = late_and_silent(0.0)
    assert reasons(both, both.robots[R0])[0].remedy.startswith("All 2 robots of rosbridge are silent")


def test_an_obstacle_of_an_old_report_is_possible_not_certain() -> None:
    state = Planted("obstacle:robot_0").run(6).state
    later = state.now + 60.0
    known = state.robots[R0].pose
    assert known is not None
    same = (pose(later - 60.0 + n, known.value.x, known.value.y) for n in range(61))
    state = reduced(state, *same, tick(later))
    found = reasons(state, state.robots[R0])[0]
    assert found.name.startswith("contact for") and found.name.endswith("60 s ago")
    assert found.strength is Strength.POSSIBLE
