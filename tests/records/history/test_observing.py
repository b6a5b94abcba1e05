"""The history that states tell, one after the other."""

from collections.abc import Iterator
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import structs

from fleet_tui.model.alarm import Alarm, Condition, Priority
from fleet_tui.model.commands import CancelOrder, Stage
from fleet_tui.model.desk.desk import CommandElsewhere
from fleet_tui.model.desk.events import CommandedElsewhere
from fleet_tui.model.events import Event, MessageRejected, QueueReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity, Charge, LaterCause, LinkChange, OrderChange, Span
from fleet_tui.records.history.observing import EVERY, HOUR, SLEPT, Fact, Observer
from fleet_tui.text.language import Message
from tests.support.fleets import (
    R0,
    T0,
    WALL,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    order_queue,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.planted_fleet import Planted
from tests.support.situations import AWAY


def told(observer: Observer, state: FleetState) -> list[Fact]:
    return list(observer.observe(state))


def of_orders(facts: list[Fact]) -> list[tuple[str, str]]:
    return [(fact.order, fact.stage) for fact in facts if isinstance(fact, OrderChange)]


def lived(planted: Planted, seconds: int, observer: Observer) -> Iterator[Fact]:
    for _ in range(seconds):
        planted.run(1)
        yield from observer.observe(planted.state)


def test_an_order_is_told_from_its_queue_to_its_end() -> None:
    planted, observer = Planted().run(1), Observer()
    told(observer, planted.state)
    facts = list(lived(planted.command(AWAY), 300, observer))
    changes = [fact for fact in facts if isinstance(fact, OrderChange)]
    assert [change.stage for change in changes] == ["queued", "begun", "done"]
    assert {change.way for change in changes} == {"Consumidores -> Base"}
    assert changes[0].at <= changes[1].at < changes[2].at
    assert changes[-1].reason == "driven to the end"
    assert changes[-1].request is not None


def test_an_order_of_another_client_has_no_request() -> None:
    state = reduced(fleet(), link_up(T0), graph(1, 2), labels({1: "Base"}), pose(T0), tick(T0))
    observer = Observer()
    told(observer, state)
    state = reduced(state, queue(T0 + 1, (7, 1, 2, "Q")), tick(T0 + 1))
    (change,) = (fact for fact in told(observer, state) if isinstance(fact, OrderChange))
    assert (change.order, change.way, change.request) == ("7", "Base -> 2", None)
    assert change.at == WALL + T0 + 1


def test_an_order_that_vanishes_is_lost() -> None:
    state = reduced(fleet(), link_up(T0), graph(1, 2), pose(T0), queue(T0, (7, 1, 2, "Q")), tick(T0))
    observer = Observer()
    assert of_orders(told(observer, state)) == [("7", "queued")]
    state = reduced(state, queue(T0 + 1), pose(T0 + 1), tick(T0 + 1))
    assert of_orders(told(observer, state)) == [("7", Stage.LOST.value)]
    assert of_orders(told(observer, state)) == []


def test_an_order_that_this_console_cancelled_is_not_lost() -> None:
    state = reduced(
        fleet(), link_up(T0), graph(1, 2), pose(T0), queue(T0, (7, 1, 2, "Q"), (8, 2, 1, "Q")), tick(T0)
    )
    observer = Observer()
    told(observer, state)
    cancel = commanded(1, CancelOrder(R0, "7"), Stage.SENT, Stage.ACCEPTED, at=T0 + 0.5)
    state = reduced(state, *cancel, queue(T0 + 1, (8, 2, 1, "Q")), pose(T0 + 1), tick(T0 + 1))
    (change,) = (fact for fact in told(observer, state) if isinstance(fact, OrderChange))
    assert (change.stage, change.reason) == ("cancelled", "by this console")


def test_the_command_that_placed_an_order_is_named() -> None:
    state = reduced(fleet(), link_up(T0), graph(1, 2), pose(T0), queue(T0), tick(T0))
    sent = commanded(3, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED, at=T0)
    state = reduced(state, *sent, queue(T0 + 1, (4, 1, 2, "Q")), tick(T0 + 1))
    (change,) = (fact for fact in Observer().observe(state) if isinstance(fact, OrderChange))
    assert change.request == 3


def test_links_come_and_go() -> None:
    observer = Observer()
    state = fleet()
    assert told(observer, state) == []
    state = reduced(state, link_up(T0), tick(T0 + 1))
    assert told(observer, state) == [LinkChange("rosbridge", WALL + T0, True)]
    state = reduced(state, link_lost(T0 + 2), tick(T0 + 3))
    assert told(observer, state) == [LinkChange("rosbridge", WALL + T0 + 2, False, "connection refused")]
    assert told(observer, state) == []


def test_a_link_that_is_down_from_the_start_is_told() -> None:
    state = reduced(fleet(), link_lost(T0), tick(T0 + 1))
    assert told(Observer(), state) == [LinkChange("rosbridge", WALL + T0, False, "connection refused")]


def test_the_time_for_which_a_machine_slept_is_nothing_that_a_robot_did() -> None:
    observer, state = Observer(), reduced(fleet(), link_up(T0), pose(T0), tick(T0))
    told(observer, state)
    facts: list[Fact] = []
    for at in (T0 + 5, T0 + 5 + 2 * SLEPT, T0 + 10 + 2 * SLEPT):
        state = reduced(state, pose(at), tick(at))
        facts += told(observer, state)
    facts += observer.finish()
    spans = {fact.began: fact.ended for fact in facts if isinstance(fact, Span)}
    watched = sum(ended - began for began, ended in spans.items())
    assert watched == 10.0


def test_a_robot_behind_a_lost_link_may_work_on_unseen() -> None:
    observer, state = Observer(), reduced(fleet(), link_up(T0), pose(T0), tick(T0))
    told(observer, state)
    state = reduced(state, tick(T0 + 1))
    told(observer, state)
    state = reduced(state, link_lost(T0 + 5), tick(T0 + 30))
    assert WALL + T0 + 1 in [fact.ended for fact in told(observer, state) if isinstance(fact, Span)]
    state = reduced(state, tick(T0 + 60))
    assert [*told(observer, state), *observer.finish()] == []


def test_a_battery_is_told_at_a_change_and_each_minute() -> None:
    observer, state = Observer(), reduced(fleet(), link_up(T0), pose(T0))

    def charges(at: float, percent: float) -> list[float]:
        nonlocal state
        state = reduced(state, battery(at, percent), tick(at))
        return [fact.percent for fact in told(observer, state) if isinstance(fact, Charge)]

    assert charges(T0 + 1, 80.0) == [80.0]
    assert charges(T0 + 2, 79.5) == []
    assert charges(T0 + 3, 78.9) == [78.9]
    assert charges(T0 + 3 + EVERY, 78.9) == [78.9]


def test_an_old_battery_is_not_told_as_a_new_one() -> None:
    observer, state = Observer(), reduced(fleet(), link_up(T0), pose(T0), battery(T0), tick(T0))
    told(observer, state)
    late = T0 + 2 * EVERY
    state = reduced(state, pose(late), tick(late))
    assert not [fact for fact in told(observer, state) if isinstance(fact, Charge)]


def test_what_goes_on_is_told_each_minute_and_cut_at_full_hours() -> None:
    state = reduced(fleet(), link_up(T0), pose(T0), tick(T0))
    observer, spans = Observer(), []
    at = T0
    while at < T0 + 2 * HOUR:
        at += 30.0
        state = reduced(state, pose(at), tick(at))
        spans += [fact for fact in told(observer, state) if isinstance(fact, Span)]
    by_begin = {span.began: span for span in spans}
    assert len(spans) > len(by_begin)
    lasting = sorted(by_begin.values(), key=lambda span: span.began)
    assert [one.ended for one in lasting[:-1]] == [other.began for other in lasting[1:]]
    assert all(span.ended // HOUR - span.began // HOUR <= 1 for span in lasting)


def test_robots_that_were_never_heard_have_no_history() -> None:
    assert told(Observer(), reduced(fleet(3), link_up(T0), tick(T0 + 60)))[1:] == []


@given(st.lists(st.floats(-7200.0, 7200.0), max_size=20))
def test_no_clock_makes_a_span_end_before_it_begins(steps: list[float]) -> None:
    observer, at = Observer(), T0
    state = reduced(fleet(), link_up(T0), pose(T0), tick(T0))
    facts = told(observer, state)
    for n, step in enumerate(steps):
        at += 20.0
        state = reduced(state, *(() if n % 3 else (pose(at, x=float(n)),)))
        moved = tick(at)
        state = reduced(state, type(moved)(at, moved.wall + step))
        facts += told(observer, state)
    facts += observer.finish()
    spans = [fact for fact in facts if isinstance(fact, Span)]
    assert all(span.ended >= span.began for span in spans)
    assert {span.activity for span in spans} <= set(Activity)


def test_spans_of_a_run_follow_each_other() -> None:
    planted, observer = Planted("paused:robot_0").run(1), Observer()
    facts = [*observer.observe(planted.state), *lived(planted.command(AWAY), 120, observer)]
    facts += observer.finish()
    ours = {fact.began: fact for fact in facts if isinstance(fact, Span) and fact.robot == R0}
    spans = [ours[began] for began in sorted(ours)]
    assert all(one.ended == other.began for one, other in pairwise(spans))
    assert Activity.PAUSED in {span.activity for span in spans}


def test_the_cause_of_an_alarm_that_came_later_is_told_once() -> None:
    def held(text: str, *, holds: bool = True) -> FleetState:
        condition = Condition(R0, "order", Priority.HIGH, Message(text), Message("over"))
        alarm = Alarm(condition, 1.0, 1.0, 1.0, holds=holds, first_text=Message("failed: no reason reported"))
        return structs.replace(reduced(fleet(), link_up(T0), tick(T0)), alarms=(alarm,))

    observer, found = Observer(), []
    for state in (
        held("failed: no reason reported"),
        held("failed: No progress"),
        held("failed: No progress"),
        held("failed: No progress", holds=False),
    ):
        found += [fact for fact in observer.observe(state) if isinstance(fact, LaterCause)]
    assert found == [LaterCause(R0, "order", "failed: No progress")]


def test_an_end_that_another_console_caused_is_told_so_once_also_if_that_is_known_later() -> None:
    state = reduced(fleet(), link_up(T0), graph(1, 2), pose(T0), queue(T0, (7, 1, 2, "Q")), tick(T0))
    observer = Observer()
    told(observer, state)
    state = reduced(state, QueueReported(R0, T0 + 1, order_queue(7, -1)), pose(T0 + 1), tick(T0 + 1))
    assert of_orders(told(observer, state)) == []  # evidence may come
    state = reduced(state, tick(T0 + 3))
    assert of_orders(told(observer, state)) == [("7", "left the queue")]
    removal = CommandElsewhere("run 9", R0, "", "ben", "pc:7", T0 + 0.9, Stage.SENT, "clear")
    state = reduced(state, CommandedElsewhere(removal), tick(T0 + 4))
    (change,) = (fact for fact in told(observer, state) if isinstance(fact, OrderChange))
    assert (change.stage, change.reason) == ("cancelled elsewhere", "cleared by ben at pc:7")
    assert of_orders(told(observer, state)) == []
    state = reduced(state, queue(T0 + 9, (7, 1, 2, "D")), tick(T0 + 9))
    assert of_orders(told(observer, state)) == [("7", "done")]


def test_a_clear_of_another_console_is_no_cause_of_the_end_of_what_was_ordered_after_it() -> None:
    state = reduced(fleet(), link_up(T0), graph(1, 2), pose(T0), queue(T0, (7, 1, 2, "Q")), tick(T0))
    observer = Observer()
    told(observer, state)
    clear = CommandElsewhere("run 9", R0, "", "ben", "pc:7", T0 + 1, Stage.CONFIRMED, "clear")
    gone = QueueReported(R0, T0 + 1.2, order_queue(7, -1))
    state = reduced(state, CommandedElsewhere(clear), gone, pose(T0 + 1.2), tick(T0 + 1.2))
    assert of_orders(told(observer, state)) == [("7", "cancelled elsewhere")]
    state = reduced(state, queue(T0 + 2, (8, 1, 2, "w"), current=8), pose(T0 + 2, 1.0), tick(T0 + 2))
    told(observer, state)
    state = reduced(state, QueueReported(R0, T0 + 9, order_queue(8, -1)), pose(T0 + 9, 1.0), tick(T0 + 9))
    assert of_orders(told(observer, reduced(state, tick(T0 + 12)))) == [("8", "done")]


@pytest.mark.parametrize("told_of", [MessageRejected(R0, Message("/robot_0/pose: x is missing")), None])
def test_time_in_which_nothing_tells_what_a_robot_does_is_no_time_offline(told_of: Event | None) -> None:
    """It sends only what nobody can read, or its one message is of unknown age."""
    observer = Observer()
    state = reduced(fleet(), link_up(T0 - 60), pose(T0 - 0.1, stamp=900.0), tick(T0))
    for n in range(1, 40):
        event = told_of or tick(T0 + n / 10)
        state = reduced(state, event, tick(T0 + n / 10))
        told(observer, state)
    assert [span.activity for span in observer.finish() if isinstance(span, Span)] == []
