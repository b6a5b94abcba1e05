"""Why nothing current is known of a robot: decided once, with the same words for every reader."""

import pytest

from fleet_tui.cli.status.report import attention
from fleet_tui.commands.checks import problems
from fleet_tui.model.events import BridgeAnswered, MessageRejected, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.alarms.trouble import to_look_at
from fleet_tui.situation.fact import FactKind
from fleet_tui.situation.facts import (
    AGE_UNKNOWN,
    BAD_DATA,
    FACTS,
    NEVER_SEEN,
    OLD_STAMPS,
    REPEATED_POSE,
    SILENT,
    UNDATED_POSE,
)
from fleet_tui.situation.robots import absence
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    battery,
    fleet,
    link_up,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)

SITE = 5_000.0
"""The clock of the site at T0."""
BAD = Message("/robot_0/battery: percentage is missing")


def silent_robot() -> FleetState:
    return reduced(fleet(), link_up(T0 - 60), battery(T0 - 20), tick(T0))


def never_seen() -> FleetState:
    return reduced(fleet(), link_up(T0 - 60), tick(T0))


def undated() -> FleetState:
    return reduced(fleet(), link_up(T0 - 60), pose(T0, stamp=SITE - 40.0), tick(T0))


def undated_and_silent() -> FleetState:
    """A pose of unknown age, and a battery that came long ago."""
    facts = (pose(T0 - 20, stamp=SITE - 40.0), battery(T0 - 20))
    return reduced(fleet(), link_up(T0 - 60), *facts, tick(T0))


def unreadable() -> FleetState:
    bad = (event for n in range(5) for event in (tick(T0 - 16 + 4 * n), MessageRejected(R0, BAD)))
    return reduced(fleet(), link_up(T0 - 60), battery(T0 - 20), *bad, tick(T0 + 0.1))


def repeated() -> FleetState:
    site = BridgeAnswered(LINK, T0 - 0.9, 0.004, SITE - 0.9)
    state = reduced(fleet(), link_up(T0 - 60), site)
    return reduced(state, *(pose(T0 - 0.4 + n / 10, stamp=SITE - 15.0) for n in range(4)), tick(T0))


def with_order(state: FleetState) -> FleetState:
    return reduced(state, queue(T0, (1, 2, 3, "w"), current=1), tick(T0 + 0.1))


STATES = {
    SILENT: (silent_robot(), "offline 20 s", "robot_0 is offline 20 s"),
    NEVER_SEEN: (never_seen(), "never seen", "robot_0 was never seen"),
    AGE_UNKNOWN: (undated(), "age unknown", "the one message of robot_0 is of unknown age"),
    BAD_DATA: (unreadable(), "bad data x5", f"no message of robot_0 is readable: {BAD}"),
}


def asked(state: FleetState) -> list[tuple[str, str]]:
    request = Request((place_order(R0, 1, 2),))
    return [(one.check, one.text) for one in problems(state, request, Permissions(False, True))]


@pytest.mark.parametrize("kind", STATES, ids=lambda kind: str(kind.word))
def test_every_reader_has_the_words_of_the_one_fact(kind: FactKind) -> None:
    state, text, question = STATES[kind]
    robot = state.robots[R0]
    fact = absence(state, robot)
    assert fact is not None and fact.kind is kind and kind in FACTS
    assert next(news(state, robot))[0] == text == fact.short
    assert f"robot_0: {text}" in attention(state) or f"robot_0: {fact.text}" in attention(state)
    assert (kind.word, question) in asked(state)
    reason = reasons(state, robot)[0]
    assert reason.evidence == fact.evidence and reason.name in (text, kind.word)


def test_a_robot_that_spoke_once_and_fell_silent_is_offline_for_row_and_check_alike() -> None:
    state = undated_and_silent()
    assert next(news(state, state.robots[R0]))[0] == "offline 20 s"
    assert ("offline", "robot_0 is offline 20 s") in asked(state)


def test_old_stamps_are_the_robots_with_an_order_and_nothing_at_rest() -> None:
    state = repeated()
    fact = absence(state, state.robots[R0])
    assert fact is not None and fact.kind is REPEATED_POSE
    assert not any("old" in line for line in attention(state))
    state = with_order(state)
    robot = state.robots[R0]
    fact = absence(state, robot)
    assert fact is not None and fact.kind is OLD_STAMPS and fact.short == "pose 15 s old"
    assert ("pose 15 s old") in [text for text, _ in news(state, robot)]
    assert "robot_0: pose 15 s old" in attention(state)
    told = [(one.name, one.evidence) for one in reasons(state, robot)]
    assert ("pose 15 s old", "poses arrive late: their time stamps lag") in told
    later = reduced(state, *(pose(T0 + n / 2, stamp=SITE - 15.0) for n in range(1, 60)), tick(T0 + 29.6))
    alarm = next(alarm for alarm in later.alarms if alarm.condition.kind == OLD_STAMPS.name)
    assert alarm.text == "poses arrive 45 s old"


def test_status_tells_the_silence_that_a_late_bridge_does_not_explain() -> None:
    late = BridgeAnswered(LINK, T0 + 1, 2.0)
    state = reduced(fleet(2), link_up(T0 - 60), battery(T0), tick(T0), late)
    states = [reduced(state, tick(T0 + after)) for after in (6.0, 8.1)]
    may_be_on_its_way, is_not = ([line for line in attention(s) if "robot_0" in line] for s in states)
    assert may_be_on_its_way == [] and is_not == ["robot_0: offline 8 s"]


def test_one_pose_of_unknown_age_is_told_alike_by_all_while_the_robot_speaks_of_other_things() -> None:
    state = reduced(undated(), battery(T0 + 0.1), tick(T0 + 0.2))
    fact = absence(state, state.robots[R0])
    assert fact is not None and fact.kind is UNDATED_POSE and fact.short == "pose of unknown age"
    assert fact.short in [text for text, _ in news(state, state.robots[R0])]
    assert not any("old" in one.name for one in reasons(state, state.robots[R0]))
    assert f"robot_0: {fact.short}" not in attention(state), "it has no order"
    assert f"robot_0: {fact.short}" in attention(with_order(state))


def test_a_robot_that_was_offline_and_now_sends_only_bad_data_is_never_well() -> None:
    state = reduced(silent_robot(), tick(T0 + 1))
    assert "robot_0: offline 21 s" in attention(state)
    for n in range(30):
        state = reduced(state, MessageRejected(R0, BAD), tick(T0 + 1.1 + n / 10))
        assert any(line.startswith("robot_0: ") for line in attention(state)), n


def test_who_sent_bad_data_alone_and_then_nothing_was_seen() -> None:
    bad = (event for n in range(5) for event in (MessageRejected(R0, BAD), tick(T0 + n)))
    state = reduced(fleet(), link_up(T0 - 60), *bad, tick(T0 + 30))
    assert next(news(state, state.robots[R0]))[0] == "offline 27 s"


def test_status_names_whom_the_top_line_counts_to_look_at() -> None:
    state = reduced(fleet(), link_up(T0 - 60), pose(T0), battery(T0), queue(T0), tick(T0))
    state = reduced(state, PausedReported(R0, T0 + 0.1, True), tick(T0 + 0.2))
    assert to_look_at(state) == (R0,)
    assert "robot_0: paused (elsewhere)" in attention(state)


def test_a_robot_that_speaks_again_and_only_rubbish_is_not_back() -> None:
    state = reduced(silent_robot(), tick(T0 + 1))
    for n in range(30):
        state = reduced(state, MessageRejected(R0, BAD), tick(T0 + 1.1 + n / 10))
        (alarm,) = (one for one in state.alarms if one.condition.kind == "offline")
        assert alarm.holds and "back online" not in alarm.text and "power" not in action_of(alarm.condition)
    state = reduced(state, battery(T0 + 5), tick(T0 + 5.1))
    assert next(one.text for one in state.alarms if one.condition.kind == "offline") == "back online"


def test_what_is_missing_is_named_once() -> None:
    state = reduced(fleet(), link_up(T0 - 60), battery(T0), queue(T0), tick(T0))
    assert to_look_at(state) == (R0,)
    assert [line for line in attention(state) if "pose" in line] == [
        "robot_0: pose, cargo, obstacle, graph of floor_0, labels of floor_0 missing"
    ]
