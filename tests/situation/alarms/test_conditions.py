"""Conditions of alarms: their begin, their end, and those that share one alarm."""

import pytest
from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import NO_REPLY, CommandPath, Phase
from fleet_tui.model.navigation_events import ErrorReported
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.errors import STOPPED, UNANSWERED
from fleet_tui.text.language import Message
from tests.support.alarms import alarm, alarms, up
from tests.support.fleets import LINK, R0, T0, battery, pose, queue, reduced, tick

ORDER = (12, 1, 2, "W")


def contact(at: float, seconds: float) -> events.ObstacleReported:
    return events.ObstacleReported(R0, at, seconds)


# Chatter


def test_a_contact_that_comes_and_goes_is_one_alarm_with_a_count() -> None:
    state = reduced(up(), contact(T0, 33.2), tick(T0), desk_events.AlarmAcknowledged(R0, "obstacle"))
    for n in range(1, 101):
        state = reduced(state, contact(T0 + n / 10, 0.0 if n % 2 else 33.2), tick(T0 + n / 10))
        assert list(alarms(state)) == [(R0, "obstacle")]
        assert state.unacknowledged == 0
    assert alarm(state, "obstacle").count == 51


def test_its_word_goes_at_once_though_the_alarm_stays() -> None:
    state = reduced(up(), contact(T0, 34.2), tick(T0))
    assert alarm(state, "obstacle").text == "obstacle 34 s"
    state = reduced(state, contact(T0 + 0.1, 0.0), tick(T0 + 0.1))
    assert (alarm(state, "obstacle").text, alarm(state, "obstacle").stage) == (
        "cleared: obstacle",
        AlarmStage.UNACKNOWLEDGED,
    )
    assert alarm(reduced(state, tick(T0 + 2.9)), "obstacle").stage is AlarmStage.UNACKNOWLEDGED
    assert alarms(reduced(state, tick(T0 + 3.1))) == {}


def test_a_battery_around_its_limit_is_one_alarm_that_never_ends_in_the_band() -> None:
    state = up()
    for n in range(100):
        at = T0 + n * 4.0
        state = reduced(state, battery(at, 19.9 if n % 2 else 21.9), tick(at))
    assert [(one.key, one.count) for one in state.alarms] == [((R0, "battery"), 1)]
    assert alarm(state, "battery").text == "battery 19 %"
    state = reduced(state, battery(T0 + 397, 22.0), tick(T0 + 397))
    assert alarm(state, "battery").text == "battery charging or recovered"
    # Left once, the band is no reason to come back.
    state = reduced(state, battery(T0 + 398, 21.0), tick(T0 + 398), tick(T0 + 401))
    assert (R0, "battery") not in alarms(state)


def test_a_battery_that_gets_critical_needs_another_look_once() -> None:
    state = reduced(up(), battery(T0, 15.0), tick(T0), desk_events.AlarmAcknowledged(R0, "battery"))
    assert state.unacknowledged == 0
    state = reduced(state, battery(T0, 9.9), tick(T0 + 1))
    assert (alarm(state, "battery").condition.priority.name, state.unacknowledged) == ("MEDIUM", 1)
    state = reduced(state, desk_events.AlarmAcknowledged())
    for n, percent in enumerate((10.5, 9.5, 11.9, 9.9)):
        state = reduced(state, battery(T0 + n, percent), tick(T0 + n))
        assert (alarm(state, "battery").condition.priority.name, state.unacknowledged) == ("MEDIUM", 0)
    state = reduced(state, battery(T0 + 9, 12.0), tick(T0 + 9))
    assert alarm(state, "battery").condition.priority.name == "LOW"


def test_an_old_battery_value_says_how_old() -> None:
    state = reduced(up(), battery(T0, 15.0), tick(T0 + 41))
    assert alarm(state, "battery").text == "battery 15 %, 41 s ago"


# A robot that has an order and does not move


def driving(at: float, x: float = 0.0) -> tuple[events.Event, ...]:
    return pose(at, x), queue(at, ORDER, current=12), tick(at)


def stood(state: FleetState, seconds: int, start: float = T0) -> FleetState:
    for n in range(seconds + 1):
        state = reduced(state, *driving(start + n))
    return state


def test_an_order_without_movement_is_an_alarm_after_its_delay() -> None:
    state = stood(up(), 59)
    assert (R0, "stuck") not in alarms(state)
    state = stood(state, 3, T0 + 59)
    assert alarm(state, "stuck").text == "stuck for 62 s (order 1 -> 2)"
    state = reduced(state, *driving(T0 + 63, x=0.5))
    assert alarm(state, "stuck").text == "no longer stuck"


def test_idle_before_an_order_does_not_count() -> None:
    state = reduced(up(), pose(T0))
    state = reduced(state, pose(T0 + 500), tick(T0 + 500))
    assert (R0, "stuck") not in alarms(stood(state, 50, T0 + 500))


def test_a_pause_or_an_obstacle_explains_why_it_stands() -> None:
    paused = stood(reduced(up(), events.PausedReported(R0, T0 + 1000, True)), 100)
    assert (R0, "stuck") not in alarms(paused)
    state = up()
    for n in range(100):
        state = reduced(state, contact(T0 + n, 34.0), *driving(T0 + n))
    assert list(alarms(state)) == [(R0, "obstacle")]


def test_contact_that_comes_and_goes_hides_no_robot_that_stands() -> None:
    state = up()
    for n in range(100):
        state = reduced(state, contact(T0 + n, float(n % 25)), *driving(T0 + n))
    assert list(alarms(state)) == [(R0, "stuck")]


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (ErrorReported(R0, T0 + 61, "drive: motor fault", is_diagnosed=True), ": drive: motor fault"),
        (ErrorReported(R0, T0 + 50, "drive: motor fault", is_diagnosed=True), ""),
        (ErrorReported(R0, T0 + 10, "no valid control"), ": no valid control"),
        (ErrorReported(R0, T0 - 20, "of an earlier drive"), ""),
    ],
)
def test_a_stuck_robot_has_the_error_that_it_reports_about_itself_as_cause(
    error: ErrorReported, told: str
) -> None:
    state = reduced(stood(up(), 62), error, tick(T0 + 62))
    assert alarm(state, "stuck").text == f"stuck for 62 s{told} (order 1 -> 2)"


def test_once_stuck_an_obstacle_or_silence_does_not_end_it() -> None:
    state = stood(up(), 70)
    state = reduced(state, contact(T0 + 71, 9.0), *driving(T0 + 71))
    assert alarm(state, "stuck").holds
    state = reduced(state, tick(T0 + 100))
    assert alarm(state, "stuck").text == "order 1 -> 2: not moving at last report"


def test_a_pause_does_not_cure_a_stuck_robot_and_makes_none() -> None:
    state = stood(up(), 70)
    state = reduced(state, events.PausedReported(R0, T0 + 71, True), *driving(T0 + 71))
    assert alarm(state, "stuck").holds
    assert alarm(state, "stuck").text == "paused, stuck for 71 s (order 1 -> 2)"
    resumed = reduced(state, events.PausedReported(R0, T0 + 80, False), *driving(T0 + 80))
    assert alarm(resumed, "stuck").holds
    assert not alarm(reduced(resumed, *driving(T0 + 81, x=0.5)), "stuck").holds
    soon = reduced(stood(up(), 40), events.PausedReported(R0, T0 + 41, True))
    assert (R0, "stuck") not in alarms(stood(soon, 60, T0 + 41))


def test_who_wanders_by_less_than_a_step_stands() -> None:
    state = up()
    for n in range(70):
        state = reduced(state, *driving(T0 + n, x=0.1 * (n % 2)))
    assert (R0, "stuck") in alarms(state)


def test_slow_is_not_stuck() -> None:
    state = up()
    for n in range(200):
        state = reduced(state, *driving(T0 + n, x=0.05 * n))
    assert alarms(state) == {}


# A pause that lasts


def test_a_pause_is_an_alarm_when_it_lasts() -> None:
    state = reduced(up(), events.PausedReported(R0, T0, True), tick(T0))
    for n in range(1, 310):
        state = reduced(state, events.PausedReported(R0, T0 + n, True), tick(T0 + n))
        assert ((R0, "pause") in alarms(state)) is (n > 300)
    assert alarm(state, "pause").text == "paused for 5 min"
    state = reduced(state, events.PausedReported(R0, T0 + 310, False), tick(T0 + 310))
    assert alarm(state, "pause").text == "pause ended"


def test_a_short_resume_begins_the_delay_anew() -> None:
    state = reduced(up(), events.PausedReported(R0, T0, True), tick(T0))
    state = reduced(state, events.PausedReported(R0, T0 + 200, False), tick(T0 + 200))
    state = reduced(state, events.PausedReported(R0, T0 + 201, True), tick(T0 + 201))
    state = reduced(state, events.PausedReported(R0, T0 + 400, True), tick(T0 + 400))
    assert (R0, "pause") not in alarms(state)


def test_a_silent_robot_is_not_said_to_be_paused() -> None:
    state = reduced(up(), events.PausedReported(R0, T0, True), tick(T0))
    state = reduced(state, events.PausedReported(R0, T0 + 301, True), tick(T0 + 301), tick(T0 + 331))
    assert alarm(state, "pause").text == "pause last reported 30 s ago"


# Bad data


def test_bad_data_is_an_alarm_while_it_comes() -> None:
    state = reduced(up(), events.MessageRejected(R0, Message("pose: no x")), tick(T0), tick(T0 + 1.1))
    assert alarm(state, "data").text == "bad data x1: pose: no x"
    for n in range(2, 31):
        state = reduced(
            state, events.MessageRejected(R0, Message("pose: no y")), battery(T0 + n), tick(T0 + n)
        )
    assert (alarm(state, "data").text, alarm(state, "data").count) == ("bad data x30: pose: no y", 1)
    state = reduced(state, battery(T0 + 38.9), tick(T0 + 38.9), battery(T0 + 41), tick(T0 + 41))
    assert alarm(state, "data").text == "no new bad data"


def test_a_bad_frame_is_an_alarm_of_its_link() -> None:
    state = reduced(up(), events.FrameRejected(LINK, "frame of 3 bytes"), tick(T0), tick(T0 + 1.1))
    assert alarm(state, "frames", LINK).text == "bad data x1: frame of 3 bytes"


def test_a_shelf_is_for_as_long_as_was_said() -> None:
    state = reduced(up(), battery(T0, 15.0), tick(T0), desk_events.AlarmShelved(R0, "battery", T0 + 60))
    assert (state.unacknowledged, state.shelved) == (0, 1)
    assert reduced(state, tick(T0 + 59)).shelved == 1
    back = reduced(state, battery(T0 + 60, 15.0), tick(T0 + 60))
    assert (back.unacknowledged, back.shelved) == (1, 0)
    off = reduced(state, desk_events.AlarmUnshelved(R0, "battery"))
    assert (off.unacknowledged, off.shelved) == (1, 0)


def test_limits_are_the_operators() -> None:
    state = up()
    state = replace(state, limits=replace(state.limits, stuck_after=5.0, clear_after=0.0, battery_band=0.0))
    state = stood(state, 6)
    assert (R0, "stuck") in alarms(state)
    state = reduced(state, desk_events.AlarmAcknowledged(), *driving(T0 + 7, x=1.0))
    assert alarms(state) == {}


# A bridge that hangs


@pytest.mark.parametrize("reason", [STOPPED, UNANSWERED])
def test_a_bridge_that_takes_connections_and_answers_nothing_may_hang_by_its_executor(
    reason: Message,
) -> None:
    state = reduced(up(), events.LinkChanged(LINK, T0, Phase.WAITING, reason), tick(T0 + 60.0))
    why = reasons(state, state.robots[R0])[0]
    assert alarm(state, "link", LINK).condition.remedy == why.remedy
    assert "use_events_executor" in why.remedy and "network" in why.remedy


def test_one_that_sends_topics_and_answers_no_call_may_too() -> None:
    dead = events.CommandPathChanged(LINK, CommandPath.DEAD, NO_REPLY, True)
    state = reduced(up(), dead, tick(T0 + 1.0))
    assert "use_events_executor" in alarm(state, "commands", LINK).condition.remedy


def test_no_other_loss_of_a_link_names_it() -> None:
    state = reduced(
        up(), events.LinkChanged(LINK, T0, Phase.WAITING, Message("unknown host")), tick(T0 + 60.0)
    )
    assert "use_events_executor" not in alarm(state, "link", LINK).condition.remedy
