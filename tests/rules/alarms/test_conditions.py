"""What raises an alarm, what ends it, and what is one alarm only."""

import pytest
from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.alarm import Alarm, AlarmStage
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    WALL,
    battery,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    tick,
    told,
)

ORDER = (12, 1, 2, "W")


def alarms(state: FleetState) -> dict[tuple[str, str], Alarm]:
    return {alarm.key: alarm for alarm in state.alarms}


def alarm(state: FleetState, kind: str, source: str = R0) -> Alarm:
    return alarms(state)[source, kind]


def contact(at: float, seconds: float) -> events.ObstacleReported:
    return events.ObstacleReported(R0, at, seconds)


def up(robots: int = 1) -> FleetState:
    """A link that is up for long, and robots that just spoke."""
    spoke = (battery(T0, robot=f"robot_{n}") for n in range(robots))
    return told(fleet(robots), link_up(T0 - 100), *spoke, tick(T0))


# Chatter


def test_a_contact_that_comes_and_goes_is_one_alarm_with_a_count() -> None:
    state = told(up(), contact(T0, 33.2), tick(T0), events.AlarmAcknowledged(R0, "obstacle"))
    for n in range(1, 101):
        state = told(state, contact(T0 + n / 10, 0.0 if n % 2 else 33.2), tick(T0 + n / 10))
        assert list(alarms(state)) == [(R0, "obstacle")]
        assert state.unacknowledged == 0
    assert alarm(state, "obstacle").count == 51


def test_its_word_goes_at_once_though_the_alarm_stays() -> None:
    state = told(up(), contact(T0, 34.2), tick(T0))
    assert alarm(state, "obstacle").text == "obstacle 34.2 s"
    state = told(state, contact(T0 + 0.1, 0.0), tick(T0 + 0.1))
    assert (alarm(state, "obstacle").text, alarm(state, "obstacle").stage) == (
        "obstacle cleared",
        AlarmStage.UNACKNOWLEDGED,
    )
    assert alarm(told(state, tick(T0 + 2.9)), "obstacle").stage is AlarmStage.UNACKNOWLEDGED
    assert alarms(told(state, tick(T0 + 3.1))) == {}


def test_a_battery_around_its_limit_is_one_alarm_that_never_ends_in_the_band() -> None:
    state = up()
    for n in range(100):
        at = T0 + n * 4.0
        state = told(state, battery(at, 19.9 if n % 2 else 21.9), tick(at))
    assert [(one.key, one.count) for one in state.alarms] == [((R0, "battery"), 1)]
    assert alarm(state, "battery").text == "battery 19 %"
    state = told(state, battery(T0 + 397, 22.0), tick(T0 + 397))
    assert alarm(state, "battery").text == "battery is charged again"
    # Left once, the band is no reason to come back.
    state = told(state, battery(T0 + 398, 21.0), tick(T0 + 398), tick(T0 + 401))
    assert (R0, "battery") not in alarms(state)


def test_a_battery_that_gets_critical_needs_another_look_once() -> None:
    state = told(up(), battery(T0, 15.0), tick(T0), events.AlarmAcknowledged(R0, "battery"))
    assert state.unacknowledged == 0
    state = told(state, battery(T0, 9.9), tick(T0 + 1))
    assert (alarm(state, "battery").condition.priority.name, state.unacknowledged) == ("MEDIUM", 1)
    state = told(state, events.AlarmAcknowledged())
    for n, percent in enumerate((10.5, 9.5, 11.9, 9.9)):
        state = told(state, battery(T0 + n, percent), tick(T0 + n))
        assert (alarm(state, "battery").condition.priority.name, state.unacknowledged) == ("MEDIUM", 0)
    state = told(state, battery(T0 + 9, 12.0), tick(T0 + 9))
    assert alarm(state, "battery").condition.priority.name == "LOW"


def test_an_old_battery_value_says_how_old() -> None:
    state = told(up(), battery(T0, 15.0), tick(T0 + 41))
    assert alarm(state, "battery").text == "battery 15 %, 41 s ago"


# A robot that has an order and does not move


def driving(at: float, x: float = 0.0) -> tuple[events.Event, ...]:
    return pose(at, x), queue(at, ORDER, current=12), tick(at)


def stood(state: FleetState, seconds: int, start: float = T0) -> FleetState:
    for n in range(seconds + 1):
        state = told(state, *driving(start + n))
    return state


def test_an_order_without_movement_is_an_alarm_after_its_delay() -> None:
    state = stood(up(), 59)
    assert (R0, "stuck") not in alarms(state)
    state = stood(state, 3, T0 + 59)
    assert alarm(state, "stuck").text == "order 12, but not moved for 62 s"
    state = told(state, *driving(T0 + 63, x=0.5))
    assert alarm(state, "stuck").text == "no longer stuck"


def test_idle_before_an_order_does_not_count() -> None:
    state = told(up(), pose(T0))
    state = told(state, pose(T0 + 500), tick(T0 + 500))
    assert (R0, "stuck") not in alarms(stood(state, 50, T0 + 500))


def test_a_pause_or_an_obstacle_explains_why_it_stands() -> None:
    paused = stood(told(up(), events.PausedReported(R0, T0 + 1000, True)), 100)
    assert (R0, "stuck") not in alarms(paused)
    state = up()
    for n in range(100):
        state = told(state, contact(T0 + n, 34.0), *driving(T0 + n))
    assert list(alarms(state)) == [(R0, "obstacle")]


def test_once_stuck_an_obstacle_or_silence_does_not_end_it() -> None:
    state = stood(up(), 70)
    state = told(state, contact(T0 + 71, 9.0), *driving(T0 + 71))
    assert alarm(state, "stuck").holds
    state = told(state, tick(T0 + 100))
    assert alarm(state, "stuck").text == "order 12, had not moved when last heard"


def test_who_wanders_by_less_than_a_step_stands() -> None:
    state = up()
    for n in range(70):
        state = told(state, *driving(T0 + n, x=0.1 * (n % 2)))
    assert (R0, "stuck") in alarms(state)


def test_slow_is_not_stuck() -> None:
    state = up()
    for n in range(200):
        state = told(state, *driving(T0 + n, x=0.05 * n))
    assert alarms(state) == {}


# A pause that lasts


def test_a_pause_is_an_alarm_when_it_lasts() -> None:
    state = told(up(), events.PausedReported(R0, T0, True), tick(T0))
    for n in range(1, 310):
        state = told(state, events.PausedReported(R0, T0 + n, True), tick(T0 + n))
        assert ((R0, "pause") in alarms(state)) is (n > 300)
    assert alarm(state, "pause").text == "paused for 5 min"
    state = told(state, events.PausedReported(R0, T0 + 310, False), tick(T0 + 310))
    assert alarm(state, "pause").text == "pause is over"


def test_a_short_resume_begins_the_delay_anew() -> None:
    state = told(up(), events.PausedReported(R0, T0, True), tick(T0))
    state = told(state, events.PausedReported(R0, T0 + 200, False), tick(T0 + 200))
    state = told(state, events.PausedReported(R0, T0 + 201, True), tick(T0 + 201))
    state = told(state, events.PausedReported(R0, T0 + 400, True), tick(T0 + 400))
    assert (R0, "pause") not in alarms(state)


def test_a_silent_robot_is_not_said_to_be_paused() -> None:
    state = told(up(), events.PausedReported(R0, T0, True), tick(T0))
    state = told(state, events.PausedReported(R0, T0 + 301, True), tick(T0 + 301), tick(T0 + 331))
    assert alarm(state, "pause").text == "pause, last heard of 30 s ago"


# Bad data


def test_bad_data_is_an_alarm_while_it_comes() -> None:
    state = told(up(), events.MessageRejected(R0, "pose: no x"), tick(T0), tick(T0 + 1.1))
    assert alarm(state, "data").text == "bad data x1: pose: no x"
    for n in range(2, 31):
        state = told(state, events.MessageRejected(R0, "pose: no y"), battery(T0 + n), tick(T0 + n))
    assert (alarm(state, "data").text, alarm(state, "data").count) == ("bad data x30: pose: no y", 1)
    state = told(state, battery(T0 + 38.9), tick(T0 + 38.9), battery(T0 + 41), tick(T0 + 41))
    assert alarm(state, "data").text == "no new bad data"


def test_a_bad_frame_is_an_alarm_of_its_link() -> None:
    state = told(up(), events.FrameRejected(LINK, "frame of 3 bytes"), tick(T0), tick(T0 + 1.1))
    assert alarm(state, "frames", LINK).text == "bad data x1: frame of 3 bytes"


# Commands


def ended(id_: int, at: float, *stages: Stage, words: str = "") -> list[events.Event]:
    return [
        events.CommandAdvanced(id_, Stage.SENT, at),
        *(events.CommandAdvanced(id_, stage, at, words) for stage in stages),
    ]


def failed(state: FleetState, id_: int, at: float, *stages: Stage, words: str = "queue full") -> FleetState:
    issued = events.CommandIssued(id_, place_order(R0, 1, 2), at, WALL)
    ends = ended(id_, at, *(stages or (Stage.REFUSED,)), words=words)
    return told(state, battery(at), tick(at), issued, *ends, tick(at))


def test_a_refused_command_is_an_alarm_in_the_robots_words() -> None:
    state = told(up(), graph(1, 2), labels({1: "Base", 2: "Store"}))
    state = failed(state, 7, T0)
    assert alarm(state, "command").text == "refused: order Base -> Store (queue full)"
    assert alarm(state, "command").condition.priority.name == "MEDIUM"


def test_not_confirmed_is_an_alarm_that_returns_after_a_while_and_stays_until_it_is_seen() -> None:
    state = failed(up(), 7, T0, Stage.ACCEPTED, words="")
    assert alarms(state) == {}
    state = told(state, battery(T0 + 6), tick(T0 + 6))
    text = "not confirmed: order 1 -> 2 (accepted; its queue has not been heard since)"
    assert alarm(state, "command").text == text
    assert alarm(told(state, battery(T0 + 35), tick(T0 + 35)), "command").text == text
    state = told(state, battery(T0 + 40), tick(T0 + 40))
    assert (alarm(state, "command").stage, alarm(state, "command").text) == (
        AlarmStage.RETURNED,
        "failed: order 1 -> 2",
    )
    assert alarms(told(state, events.AlarmAcknowledged())) == {}


def test_further_failures_of_a_robot_count_and_need_another_look() -> None:
    state = told(failed(failed(up(), 7, T0), 8, T0 + 1), events.AlarmAcknowledged())
    assert (alarm(state, "command").count, state.unacknowledged) == (2, 0)
    state = failed(state, 9, T0 + 2)
    assert (alarm(state, "command").count, state.unacknowledged) == (3, 1)
    assert len(state.alarms) == 1


@pytest.mark.parametrize("stage", [Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN, Stage.NOT_SENT])
def test_what_is_not_over_or_never_left_is_no_alarm(stage: Stage) -> None:
    assert alarms(failed(up(), 7, T0, stage)) == {}


def test_a_pause_that_failed_is_urgent_and_for_many_robots_one_alarm() -> None:
    state = up(100)
    state = told(
        state, *(events.CommandIssued(n, PauseRobot(f"robot_{n}"), T0 + n / 1000, WALL) for n in range(100))
    )
    for n in range(100):
        state = told(state, *ended(n, T0, Stage.REFUSED), *[tick(T0 + n / 100)] * (n % 20 == 0))
    state = told(state, tick(T0 + 1))
    assert [one.key for one in state.alarms] == [(LINK, "many commands")]
    assert state.alarms[0].text == "refused: pause of 100 robots"
    assert (state.alarms[0].condition.priority.name, state.alarms[0].count) == ("HIGH", 100)


# Floods


def silence(state: FleetState, gone: set[int], robots: int, start: float, seconds: float) -> FleetState:
    """The others speak on; the writer's clock ticks."""
    for n in range(round(seconds * 10)):
        at = start + n / 10
        state = told(
            state,
            *(battery(at, robot=f"robot_{n}") for n in range(robots) if n not in gone),
            tick(at),
        )
    return state


def offline(state: FleetState) -> list[str]:
    return [one.text for one in state.alarms if one.condition.kind in ("offline", "many offline")]


def test_robots_that_go_together_are_one_alarm_at_every_moment() -> None:
    """100 robots, 37 of them fall silent within two seconds, in no order."""
    state = up(100)
    for n in range(130):
        at = T0 + n / 10
        speak = (k for k in range(100) if k >= 37 or n / 10 <= (k * 7 % 37) / 37 * 2.0)
        state = told(state, *(battery(at, robot=f"robot_{k}") for k in speak), tick(at))
        assert len(offline(state)) == (n / 10 > 5.0)
    assert offline(state) == ["37 robots offline: robot_0, robot_1, robot_2, …"]
    assert [one.key for one in state.alarms] == [(LINK, "many offline")]
    assert sum(not state.is_online(robot) for robot in state.robots.values()) == 37


def test_when_a_group_shrinks_its_row_follows() -> None:
    state = silence(up(20), set(range(10)), 20, T0 + 0.1, 8)
    state = told(state, events.AlarmAcknowledged())
    state = silence(state, {0, 1}, 20, T0 + 9, 1)
    assert offline(state) == ["2 robots offline: robot_0, robot_1"]
    state = silence(state, {1}, 20, T0 + 10, 1)
    assert offline(state) == ["1 robot offline: robot_1"]
    assert state.unacknowledged == 0
    assert offline(silence(state, set(), 20, T0 + 11, 4)) == []


def test_one_more_robot_after_a_flood_is_an_alarm_of_its_own() -> None:
    state = silence(up(20), set(range(10)), 20, T0 + 0.1, 20)
    state = told(state, events.AlarmAcknowledged())
    state = silence(state, set(range(11)), 20, T0 + 20, 8)
    assert offline(state) == ["10 robots offline: robot_0, robot_1, robot_2, …", "offline 8 s"]
    assert state.unacknowledged == 1


def test_a_second_flood_needs_another_look() -> None:
    state = told(silence(up(20), set(range(6)), 20, T0 + 0.1, 20), events.AlarmAcknowledged())
    state = silence(state, set(range(12)), 20, T0 + 20, 8)
    assert offline(state) == ["12 robots offline: robot_0, robot_1, robot_2, …"]
    assert state.unacknowledged == 1


def test_few_robots_are_alarms_of_their_own() -> None:
    state = silence(up(20), {3, 4, 5, 6}, 20, T0 + 0.1, 8)
    assert [one.key for one in state.alarms] == [(f"robot_{n}", "offline") for n in (3, 4, 5, 6)]


def test_a_lost_link_is_one_alarm_and_its_robots_no_others() -> None:
    state = told(up(100), link_lost(T0 + 1), tick(T0 + 2))
    for n in range(2, 60):
        state = told(state, tick(T0 + n))
    assert [one.key for one in state.alarms] == [(LINK, "link")]
    # Back, but nobody speaks.
    state = told(state, link_up(T0 + 60), tick(T0 + 60), tick(T0 + 70))
    assert offline(state) == ["100 robots offline: robot_0, robot_1, robot_2, …"]


def test_a_console_that_slept_finds_one_alarm() -> None:
    assert offline(told(up(100), tick(T0 + 600))) == ["100 robots offline: robot_0, robot_1, robot_2, …"]


def test_robots_that_were_never_heard_are_not_said_to_have_gone() -> None:
    state = told(fleet(10), link_up(T0), tick(T0 + 6))
    assert offline(state) == ["10 robots never seen: robot_0, robot_1, robot_2, …"]


def test_a_fleet_that_is_paused_for_long_is_one_alarm() -> None:
    state = up(100)
    for n in range(310):
        speak = (events.PausedReported(f"robot_{k}", T0 + n + k / 100, True) for k in range(100))
        state = told(state, *speak, tick(T0 + n + 1))
    assert [(one.key, one.text) for one in state.alarms] == [
        ((LINK, "many pause"), "100 robots in a long pause: robot_0, robot_1, robot_2, …")
    ]


def test_bad_data_of_all_robots_is_one_alarm() -> None:
    state = up(100)
    for n in range(100):
        state = told(state, events.MessageRejected(f"robot_{n}", "pose: no x"), tick(T0 + n / 50))
    state = told(state, tick(T0 + 3.5))
    assert [one.text for one in state.alarms] == ["100 robots with bad data: robot_0, robot_1, robot_2, …"]


def test_a_fleet_that_stops_at_once_is_one_alarm() -> None:
    state = up(10)
    for n in range(70):
        for k in range(10):
            name = f"robot_{k}"
            state = told(state, pose(T0 + n, robot=name), queue(T0 + n, ORDER, current=12, robot=name))
        state = told(state, tick(T0 + n))
    assert [one.key for one in state.alarms] == [(LINK, "many stuck")]


def test_a_shelved_robot_is_not_taken_into_a_group() -> None:
    state = silence(up(20), {0}, 20, T0 + 0.1, 8)
    state = told(state, events.AlarmShelved(R0, "offline", T0 + 1000))
    state = silence(state, set(range(10)), 20, T0 + 9, 8)
    assert [(one.key, one.stage) for one in state.alarms] == [
        ((R0, "offline"), AlarmStage.SHELVED),
        ((LINK, "many offline"), AlarmStage.UNACKNOWLEDGED),
    ]
    assert alarm(state, "many offline", LINK).text.startswith("9 robots offline")
    assert (state.unacknowledged, state.shelved) == (1, 1)


def test_a_shelf_is_for_as_long_as_was_said() -> None:
    state = told(up(), battery(T0, 15.0), tick(T0), events.AlarmShelved(R0, "battery", T0 + 60))
    assert (state.unacknowledged, state.shelved) == (0, 1)
    assert told(state, tick(T0 + 59)).shelved == 1
    back = told(state, battery(T0 + 60, 15.0), tick(T0 + 60))
    assert (back.unacknowledged, back.shelved) == (1, 0)
    off = told(state, events.AlarmUnshelved(R0, "battery"))
    assert (off.unacknowledged, off.shelved) == (1, 0)


def test_limits_are_the_operators() -> None:
    state = up()
    state = replace(state, limits=replace(state.limits, stuck_after=5.0, clear_after=0.0, battery_band=0.0))
    state = stood(state, 6)
    assert (R0, "stuck") in alarms(state)
    state = told(state, events.AlarmAcknowledged(), *driving(T0 + 7, x=1.0))
    assert alarms(state) == {}
