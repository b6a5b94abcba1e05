"""A pose that only the wheels of a robot tell: its localisation is silent while it moves."""

import pytest
from msgspec.structs import replace

from fleet_tui.cli.status.report import attention, navigation
from fleet_tui.model.events import Event, TimePassed, TopicNotAllowed, TopicsDropped
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Progress
from fleet_tui.model.navigation_events import (
    LocalisationReported,
    OdometryReported,
    OriginReported,
    ProgressReported,
)
from fleet_tui.situation.facts import ADRIFT, LOST_SUBSCRIPTIONS, NOT_ALLOWED
from fleet_tui.situation.robots import adrift
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.units import age
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import LINK, R0, T0, WALL, fleet, link_up, of_kinds, reduced

SPEED = 0.5
NAV2 = Kind(
    "nav2",
    ("odometry", "pose"),
    keeps_goals=True,
    pose_topic="/{robot}/amcl_pose",
    odometry_topic="/{robot}/odom",
)


def driven(seconds: float, is_transform: bool, localised_for: float = 2.0) -> FleetState:
    """A robot after so many seconds of driving, whose localisation falls silent during that."""
    state = reduced(of_kinds(fleet(), NAV2), link_up(T0))
    for tenth in range(round(seconds * 10) + 1):
        at = T0 + tenth / 10
        x = SPEED * tenth / 10
        facts: list[Event] = [OdometryReported(R0, at, Pose(x, 0.0), at, is_transform)]
        if tenth / 10 <= localised_for and is_transform:
            facts.append(OriginReported(R0, at, Pose(3.0, 0.0), "map"))
        elif tenth / 10 <= localised_for and tenth % 5 == 0:
            facts.append(LocalisationReported(R0, at, Pose(3.0 + x, 0.0), "map", at, 0.0))
        state = reduced(state, *facts, TimePassed(at, WALL + at))
    return state


@pytest.mark.parametrize("is_transform", [False, True])
def test_a_localisation_that_falls_silent_is_told_everywhere_in_the_same_words(is_transform: bool) -> None:
    state = driven(20.0, is_transform)
    robot = state.robots[R0]
    assert robot.pose is not None and robot.pose.value.x == pytest.approx(13.0, abs=0.2)
    fact = adrift(state, robot)
    assert fact is not None and fact.text.startswith("pose estimated, localisation silent for 1")
    (alarm,) = [one for one in state.alarms if one.holds]
    assert (alarm.text, alarm.condition.kind) == (fact.text, "localisation")
    assert alarm.condition.remedy == fact.action == ADRIFT.action
    assert fact.short in [text for text, _ in news(state, robot)]
    (why,) = [one for one in reasons(state, robot) if one.name == fact.short]
    assert (why.evidence, why.remedy) == (fact.evidence, fact.action)
    assert any(fact.text in line for line in attention(state))
    assert robot.located_at is not None and state.now - robot.located_at == pytest.approx(18.0, abs=0.5)
    assert fact.text == f"pose estimated, localisation silent for {age(state.now - robot.located_at)}"
    assert navigation(state, robot)["localisation_silent_s"] == round(state.now - robot.located_at, 1)


@pytest.mark.parametrize("is_transform", [False, True])
def test_it_is_over_with_the_next_localised_pose(is_transform: bool) -> None:
    state = driven(20.0, is_transform)
    at, here = T0 + 20.1, Pose(13.0, 0.0)
    back: Event = LocalisationReported(R0, at, here, "map", at, 0.0)
    if is_transform:
        back = OriginReported(R0, at, Pose(3.0, 0.0), "map")
    state = reduced(state, back, OdometryReported(R0, at, Pose(10.0, 0.0), at, is_transform))
    assert adrift(state, state.robots[R0]) is None


def test_a_localisation_that_the_bridge_lost_is_mended_at_the_bridge() -> None:
    state = reduced(driven(20.0, is_transform=False), TopicsDropped(LINK, (R0,)))
    fact = adrift(state, state.robots[R0])
    assert fact is not None and fact.action == LOST_SUBSCRIPTIONS.action
    assert [one.remedy for one in reasons(state, state.robots[R0]) if one.name == fact.short] == [fact.action]
    state = reduced(state, TopicsDropped(LINK, ()))
    fact = adrift(state, state.robots[R0])
    assert fact is not None and fact.action == ADRIFT.action


@pytest.mark.parametrize(
    ("topic", "action"), [("/robot_0/amcl_pose", NOT_ALLOWED.action), ("/robot_0/battery", ADRIFT.action)]
)
def test_only_the_topic_that_places_a_robot_explains_a_pose_that_its_feedback_repeats(
    topic: str, action: str
) -> None:
    state = reduced(fed(lag=20.0), TopicNotAllowed(LINK, topic, (R0,)))
    fact = adrift(state, state.robots[R0])
    assert fact is not None and fact.action == action


def test_a_robot_that_stands_may_hear_nothing_of_its_localisation() -> None:
    state = driven(2.0, is_transform=False)
    for second in range(1, 600):
        at = T0 + 2.0 + second
        state = reduced(state, OdometryReported(R0, at, Pose(1.0, 0.0), at), TimePassed(at, WALL + at))
    assert adrift(state, state.robots[R0]) is None and not state.alarms


def test_one_that_has_only_just_moved_on_may_wait_for_the_next_scan() -> None:
    state = driven(2.0, is_transform=False, localised_for=0.0)
    assert adrift(state, state.robots[R0]) is None


def test_a_fixed_origin_is_no_localisation_that_could_fall_silent() -> None:
    state = reduced(of_kinds(fleet(), NAV2), link_up(T0))
    for tenth in range(300):
        at = T0 + tenth / 10
        facts: list[Event] = [OdometryReported(R0, at, Pose(tenth / 20, 0.0), at, is_transform=True)]
        if not tenth:
            facts = [OriginReported(R0, at, Pose(3.0, 0.0), "map", is_fixed=True), *facts]
        state = reduced(state, *facts, TimePassed(at, WALL + at))
    robot = state.robots[R0]
    assert robot.pose is not None and robot.pose.value.x == pytest.approx(17.95)
    assert adrift(state, robot) is None


def test_old_poses_are_another_fact() -> None:
    state = driven(20.0, is_transform=False)
    later = replace(state, now=state.now + 60.0)
    assert adrift(later, later.robots[R0]) is None


def fed(lag: float, seconds: float = 2.0) -> FleetState:
    """A robot first seen while it drives a goal, whose feedback has a pose of so many seconds ago."""
    state = reduced(of_kinds(fleet(), NAV2), link_up(T0))
    for tenth in range(round(seconds * 10)):
        at = T0 + tenth / 10
        was = min(at, T0 + 1.0) - lag if lag else at
        state = reduced(
            state,
            OdometryReported(R0, at, Pose(SPEED * tenth / 10, 0.0), at),
            LocalisationReported(R0, at, Pose(3.0, 0.0), "map", was, None, is_feedback=True),
            ProgressReported(R0, at, Progress("1", metres=5.0)),
            TimePassed(at, WALL + at),
        )
    return state


def test_feedback_that_repeats_an_old_pose_is_told_at_the_first_look() -> None:
    state = fed(lag=20.0)
    fact = adrift(state, state.robots[R0])
    assert fact is not None and fact.text.startswith("pose estimated, localisation silent for 2")
    assert fact.evidence.endswith("its feedback repeats the last pose")
    assert any(fact.short in line for line in attention(state))


def test_feedback_that_repeats_a_pose_stops_no_wheels() -> None:
    robot = fed(lag=20.0, seconds=6.0).robots[R0]
    assert robot.pose is not None and robot.pose.value.x > 4.0


def test_feedback_with_new_poses_is_a_localisation() -> None:
    state = fed(lag=0.0)
    assert adrift(state, state.robots[R0]) is None
