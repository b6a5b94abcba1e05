"""Pauses and resumes: what telemetry says of whether they were carried out."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import CommandPathChanged, PausedReported, PoseReported, TimePassed
from fleet_tui.model.geometry import Pose
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.link import HALF_DEAD, CommandPath
from fleet_tui.model.navigation_events import OdometryReported
from fleet_tui.model.order import OrderState
from fleet_tui.situation.activity import activity
from fleet_tui.situation.alarms.trouble import is_odd
from fleet_tui.situation.pauses import own_pause_text
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.lines.status import console_notes
from tests.support.fleets import LINK, R0, T0, commanded, pose, reduced, tick
from tests.support.legs import goal, lived, site
from tests.support.one_command import ACCEPTED, NO_ANSWER, PATIENCE, SENT, only, up


@pytest.mark.parametrize(("command", "says"), [(PauseRobot(R0), True), (ResumeRobot(R0), False)])
def test_the_robots_own_word_confirms_a_pause(command: Command, says: bool) -> None:
    state = up(PausedReported(R0, T0, not says), *commanded(1, command, SENT, ACCEPTED))
    assert only(reduced(state, tick(T0 + 1))).stage is ACCEPTED
    assert only(reduced(state, PausedReported(R0, T0 + 1, says), tick(T0 + 1))).stage is Stage.CONFIRMED
    against = reduced(state, PausedReported(R0, T0 + 1, not says), tick(T0 + PATIENCE))
    assert only(against).stage is Stage.NOT_CONFIRMED and "reported" in only(against).detail


@pytest.mark.parametrize("command", [PauseRobot(R0), ResumeRobot(R0)])
def test_where_nothing_shows_it_an_accepted_pause_is_only_accepted(command: Command) -> None:
    parked = up(pose(T0 - 50), pose(T0), *commanded(1, command, SENT, ACCEPTED), tick(T0))
    assert only(parked).stage is Stage.UNVERIFIABLE
    assert "accepted" in Stage.UNVERIFIABLE.value


def test_a_pause_that_a_topic_is_to_show_waits_for_it() -> None:
    """A pause given before anything was heard, as from a shell, is not taken for one that nothing shows."""
    state = up()
    state = replace(state, robots={R0: replace(state.robots[R0], says_paused=True)})
    state = reduced(state, *commanded(1, PauseRobot(R0), SENT, ACCEPTED), tick(T0))
    assert only(state).stage is ACCEPTED
    assert only(reduced(state, PausedReported(R0, T0 + 1, True), tick(T0 + 1))).stage is Stage.CONFIRMED
    silent = only(reduced(state, tick(T0 + PATIENCE)))
    assert (silent.stage, silent.detail) == (Stage.NOT_CONFIRMED, "accepted; no message on the pause topic")


def test_a_robot_that_was_driving_and_stands_still_is_seen_to_have_paused() -> None:
    driving = up(pose(T0 - 0.1), pose(T0, 0.2), *commanded(1, PauseRobot(R0), SENT, ACCEPTED), tick(T0))
    assert only(driving).stage is ACCEPTED
    stopped = reduced(driving, pose(T0 + 0.1, 0.3), pose(T0 + 1.2, 0.31), tick(T0 + 1.2))
    assert (only(stopped).stage, only(stopped).detail) == (Stage.CONFIRMED, "the robot stopped")
    rolling = [pose(T0 + n / 2, 0.2 + n) for n in range(1, 12)]
    on = reduced(driving, *rolling, tick(T0 + PATIENCE))
    assert only(on).stage is Stage.NOT_CONFIRMED and "kept moving" in only(on).detail


def test_a_robot_that_stops_at_once_and_reports_no_further_place_has_paused() -> None:
    driving = up(pose(T0 - 0.1), pose(T0 - 0.05, 0.2), *commanded(1, PauseRobot(R0), SENT, ACCEPTED))
    assert (
        only(reduced(driving, pose(T0 + 0.5, 0.2), tick(T0 + 3))).stage is ACCEPTED
    )  # silence is no standing
    stopped = reduced(driving, pose(T0 + 0.5, 0.2), pose(T0 + 1.1, 0.2), tick(T0 + 1.2))
    assert (only(stopped).stage, only(stopped).detail) == (Stage.CONFIRMED, "the robot stopped")


def test_what_is_seen_after_the_opposite_took_effect_is_not_the_doing_of_a_pause() -> None:
    driving = up(pose(T0 - 0.1), pose(T0, 0.2), *commanded(1, PauseRobot(R0), SENT, ACCEPTED))
    refused = reduced(
        driving, *commanded(2, ResumeRobot(R0), SENT, Stage.REFUSED, at=T0 + 0.2), tick(T0 + 0.3)
    )
    assert refused.commands[0].stage is ACCEPTED
    resumed = reduced(driving, *commanded(2, ResumeRobot(R0), SENT, ACCEPTED, at=T0 + 0.2), tick(T0 + 0.3))
    assert resumed.commands[0].stage is Stage.UNVERIFIABLE
    quick = up(PausedReported(R0, T0, False), *commanded(1, PauseRobot(R0), SENT, ACCEPTED))
    quick = reduced(quick, *commanded(2, ResumeRobot(R0), SENT, ACCEPTED, at=T0 + 0.2))
    quick = reduced(quick, PausedReported(R0, T0 + 0.5, False), tick(T0 + PATIENCE))
    assert [one.stage for one in quick.commands] == [Stage.UNVERIFIABLE, Stage.CONFIRMED]


def test_a_robot_that_stood_all_the_time_is_not_said_to_move() -> None:
    parked = up(pose(T0 - 50), pose(T0), *commanded(1, PauseRobot(R0), SENT, NO_ANSWER), pose(T0 + 4))
    end = only(reduced(parked, tick(T0 + PATIENCE)))
    assert (end.stage, end.detail.rpartition("; ")[2]) == (Stage.NOT_CONFIRMED, "no evidence in telemetry")


@pytest.mark.parametrize("command", [PauseRobot(R0), ResumeRobot(R0)])
@pytest.mark.parametrize("says", [True, False])
def test_the_end_of_a_pause_does_not_read_as_if_it_were_paused(command: Command, says: bool) -> None:
    asked = up(PausedReported(R0, T0, not says), *commanded(1, command, SENT, ACCEPTED))
    end = only(reduced(asked, PausedReported(R0, T0 + 1, says), tick(T0 + PATIENCE)))
    assert end.is_decided and "paused" not in end.detail


@pytest.mark.parametrize("seconds", [0.1, 0.2, 0.5, 1.0, 1.2, 2.0])
@pytest.mark.parametrize("phase", [n / 10 for n in range(10)])
def test_a_driving_robot_whose_poses_come_seldom_is_seen_to_stop(seconds: float, phase: float) -> None:
    speed, given = 1.2, T0 + (10 + phase) * seconds
    times = [T0 + n * seconds for n in range(int(8 / seconds) + 12)]
    poses = [pose(at, speed * (min(at, given) - T0)) for at in times]
    ticks = [tick(given + n / 10) for n in range(int(PATIENCE * 10))]
    facts: list[PoseReported | TimePassed] = sorted([*poses, *ticks], key=lambda one: one.at)
    driven = [one for one in facts if one.at < given]
    state = up(*driven, *commanded(1, PauseRobot(R0), SENT, ACCEPTED, at=given))
    paused = reduced(state, *facts[len(driven) :])
    assert only(paused).stage is Stage.CONFIRMED
    assert paused.robots[R0].paused_by_us


def test_a_robot_that_drives_on_despite_our_pause_is_not_paused() -> None:
    state = up(pose(T0 - 1), pose(T0, 1.0), *commanded(1, PauseRobot(R0), SENT, ACCEPTED))
    assert reduced(state, pose(T0 + 1, 2.0)).robots[R0].paused_by_us
    assert not reduced(state, pose(T0 + 1, 2.0), pose(T0 + 2, 3.0)).robots[R0].paused_by_us


def test_a_pause_over_a_half_dead_bridge_blames_no_robot() -> None:
    half_dead = CommandPathChanged(LINK, CommandPath.DEAD, HALF_DEAD, True)
    asked = reduced(site(), *commanded(1, PauseRobot(R0), SENT, Stage.UNKNOWN, at=T0 + 90), half_dead)
    end = only(reduced(asked, tick(T0 + 90 + PATIENCE), tick(T0 + 200)))
    assert end.stage is Stage.NOT_CONFIRMED and HALF_DEAD in end.detail, end


def test_a_paused_robot_that_another_clients_goal_drives_says_so() -> None:
    paused = (*commanded(1, PauseRobot(R0), SENT, ACCEPTED, Stage.CONFIRMED, at=T0), tick(T0))
    state = reduced(site(), *paused)
    assert own_pause_text(state, state.robots[R0]) == "stopped, no goal to keep"
    assert activity(state, state.robots[R0]) is Activity.PAUSED and not is_odd(state, state.robots[R0])
    state = lived(state, T0 + 3, goal("foreign"))
    state = reduced(state, OdometryReported(R0, T0 + 4, Pose(2.0, 0.0), T0 + 4), tick(T0 + 4))
    robot = state.robots[R0]
    assert own_pause_text(state, robot) == "driving despite pause"
    assert activity(state, robot) is Activity.DRIVING and is_odd(state, robot)
    assert not any("PAUSED" in note for note in console_notes(state, False, True, 0.0))
    found, *_ = reasons(state, robot)
    assert "pause" in found.keys and "another client" in found.evidence
    for stage in (SENT, ACCEPTED, NO_ANSWER, Stage.REFUSED, Stage.NOT_SENT):
        tried = reduced(state, *commanded(2, PauseRobot(R0), SENT, stage, at=T0 + 4))
        assert own_pause_text(tried, tried.robots[R0]) == "driving despite pause", stage
    later = lived(reduced(state, tick(T0 + 2000)), T0 + 2001, goal("foreign"))
    assert own_pause_text(later, later.robots[R0]) == "another goal despite pause", "it stands"
    assert not any(one.condition.kind == "pause" and one.holds for one in later.alarms)
    queued = lived(reduced(site(), *paused), T0 + 3, goal("foreign", OrderState.QUEUED))
    assert own_pause_text(queued, queued.robots[R0]) == "stopped, no goal to keep"
    again = lived(state, T0 + 5, goal("foreign", OrderState.CANCELLED))
    assert own_pause_text(again, again.robots[R0]) == "stopped, no goal to keep"
