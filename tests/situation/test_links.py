"""Facts about links: alarm, row, reason and status say the same of each."""

import pytest

from fleet_tui.cli.status.report import attention
from fleet_tui.model.events import (
    CommandPathChanged,
    Event,
    MessagesUnsourced,
    TopicNotAllowed,
    TopicsDropped,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import HALF_DEAD, CommandPath
from fleet_tui.situation.why.reason import Strength
from fleet_tui.situation.why.robot import unreachable
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from fleet_tui.ui.view.lines.status import status_line
from tests.support.fleets import LINK, R0, T0, battery, fleet, link_up, pose, queue, reduced, tick

DEAD = CommandPathChanged(LINK, CommandPath.DEAD, Message("no ROS master"), True)
UNREGISTERED = CommandPathChanged(
    LINK, CommandPath.UNREGISTERED, Message("nodes of robot_1 not registered"), True
)
HALF = CommandPathChanged(LINK, CommandPath.DEAD, HALF_DEAD, True)
UNSOURCED = MessagesUnsourced(LINK, "OH_ressources")
LOST = TopicsDropped(LINK, (R0,))
BARRED = TopicNotAllowed(LINK, "/robot_0/pose", (R0,))


def told(*events: Event) -> FleetState:
    """Return a fleet with robot_0 at rest of which only the battery is heard."""
    return reduced(fleet(), link_up(T0 - 60), *events, battery(T0), tick(T0), tick(T0 + 0.1))


@pytest.mark.parametrize(
    ("event", "text"),
    [
        (DEAD, "commands dead: no ROS master"),
        (UNREGISTERED, "nodes of robot_1 not registered"),
        (HALF, "commands dead: rosbridge is half dead: restart it"),
        (UNSOURCED, "rosbridge lacks package OH_ressources: source its workspace and restart rosbridge"),
        (LOST, "rosbridge lost its subscriptions of robot_0: restart it"),
        (BARRED, "the bridge does not allow /robot_0/pose (topics_glob)"),
    ],
)
def test_alarm_top_line_and_status_have_the_same_words(event: Event, text: str) -> None:
    state = told(event)
    assert [alarm.text for alarm in state.alarms if alarm.condition.source == LINK] == [text]
    assert text in "".join(run for run, _ in status_line(state, R0))
    assert [line for line in attention(state) if line.startswith(f"{LINK}: ")] == [f"{LINK}: {text}"]


@pytest.mark.parametrize(
    ("event", "name"),
    [
        (DEAD, "commands dead: no ROS master"),
        (HALF, "rosbridge half dead"),
        (UNSOURCED, "rosbridge lacks a package"),
    ],
)
def test_the_reasons_of_a_robot_have_it_with_the_remedy_of_the_alarm(event: Event, name: str) -> None:
    state = told(event)
    (reason,) = [one for one in reasons(state, state.robots[R0]) if one.name == name]
    assert reason.remedy == next(one.condition.remedy for one in state.alarms if one.condition.source == LINK)


def test_a_pose_that_the_bridge_cannot_read_is_not_the_fault_of_the_localisation() -> None:
    state = told(UNSOURCED)
    assert "localisation" not in " ".join(one.remedy for one in reasons(state, state.robots[R0]))


def test_dead_commands_are_no_likely_cause_for_a_robot_with_an_order() -> None:
    state = reduced(told(DEAD), pose(T0), queue(T0, (1, 0, 1, "c"), current=1))
    found = unreachable(state, state.robots[R0])
    assert found is not None and found.strength is Strength.POSSIBLE
