"""Orders after `confirmed`: how they end, who ended them, and what is carried out late."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.desk.desk import CommandElsewhere
from fleet_tui.model.desk.events import CommandedElsewhere
from fleet_tui.model.events import CommandAdvanced, Event, PausedReported, QueueReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.text.language import Message
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    graph,
    link_up,
    order,
    order_queue,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)

END = 7  # three metres from where the robot is at first
ORDER = place_order(R0, 0, END)
SENT, ACCEPTED = Stage.SENT, Stage.ACCEPTED
QUEUED, DRIVEN = (5, 0, END, "Q"), (5, 0, END, "W")
PATIENCE = fleet().limits.confirm_after


def gone(at: float, last: int = 5) -> QueueReported:
    """An empty queue that has counted to `last`."""
    return QueueReported(R0, at, order_queue(last, -1))


def driving(at: float) -> QueueReported:
    return queue(at, DRIVEN, current=5)


def given(*facts: Event) -> FleetState:
    """A robot whose queue shows the order that was given at T0."""
    state = reduced(fleet(), link_up(T0 - 9), graph(0, 1, 2, END), pose(T0 - 1), gone(T0 - 1, 4), tick(T0))
    state = reduced(state, *commanded(1, ORDER, SENT, ACCEPTED), queue(T0 + 1, QUEUED), tick(T0 + 1))
    return reduced(state, *facts)


def first(state: FleetState) -> CommandRecord:
    return state.commands[0]


def alarm_texts(state: FleetState) -> list[str]:
    return [alarm.text for alarm in state.alarms]


@pytest.mark.parametrize(
    ("facts", "stage", "reason"),
    [
        (
            [driving(T0 + 2), pose(T0 + 3, 2.0), pose(T0 + 4, 9.0), gone(T0 + 5)],
            Stage.DONE,
            "driven to the end",
        ),
        ([queue(T0 + 2, (5, 0, END, "D"))], Stage.DONE, "as reported by the robot"),
        ([gone(T0 + 2)], Stage.LEFT, "not by this console, before it started"),
        ([driving(T0 + 2), gone(T0 + 3)], Stage.LEFT, "not by this console, with the robot 3 m from its end"),
        ([driving(T0 + 2), gone(T0 + 3, 0)], Stage.LOST, "order ids started over"),
        ([driving(T0 + 2), pose(T0 + 2, 2.9), gone(T0 + 3, 0)], Stage.LOST, "order ids started over"),
        ([queue(T0 + 2, (5, 3, 4, "W"), current=5)], Stage.LOST, "order ids started over"),
        (
            [driving(T0 + 2), gone(T0 + 44)],
            Stage.LOST,
            "no queue was received for 42 s: may have been completed",
        ),
        (
            [*(driving(T0 + n) for n in range(2, 44)), gone(T0 + 44)],
            Stage.LOST,
            "no pose was received for 45 s: may have been completed",
        ),
        ([queue(T0 + 2, (5, 0, END, "C"))], Stage.CANCELLED_ELSEWHERE, "as reported by the robot"),
        ([driving(T0 + 2), pose(T0 + 2, 0.5)], Stage.CONFIRMED, "seen in the queue as order 5"),
    ],
)
def test_the_end_of_an_order_is_told(facts: list[Event], stage: Stage, reason: str) -> None:
    state = given(*facts, tick(T0 + 45))
    record = first(state)
    assert record.stage is stage and reason in record.detail
    needs_somebody = stage in (Stage.LOST, Stage.LEFT, Stage.CANCELLED_ELSEWHERE)
    found = [text for text in alarm_texts(state) if text.startswith(f"{stage.value}: order 0 -> 7")]
    assert len(found) == needs_somebody


def test_an_order_that_begins_at_its_end_is_not_done_until_the_robot_is_back() -> None:
    """Many orders fetch from elsewhere what belongs where the robot is."""
    away = [pose(T0 + 3 + n, 3.0 + 4 * n) for n in range(10)]
    begun: list[Event] = [pose(T0 + 1.5, 3.0), driving(T0 + 2), *away, driving(T0 + 13)]
    left = first(given(*begun, gone(T0 + 14), tick(T0 + 15)))
    assert left.stage is Stage.LEFT and "with the robot 36 m from its end" in left.detail
    back: list[Event] = [pose(T0 + 20, 3.0), pose(T0 + 21, 3.0), gone(T0 + 21.5), tick(T0 + 22)]
    assert first(given(*begun, driving(T0 + 20), *back)).stage is Stage.DONE


def test_a_robot_that_does_not_say_which_order_it_drives_has_driven_the_one_in_process() -> None:
    facts: list[Event] = [
        queue(T0 + 2, DRIVEN),
        pose(T0 + 3, 3.0),
        pose(T0 + 4, 9.0),
        gone(T0 + 4.5),
        tick(T0 + 5),
    ]
    assert first(given(*facts)).stage is Stage.DONE


def test_a_robot_that_waits_at_the_end_for_long_has_driven_there() -> None:
    waits: list[Event] = [fact for n in range(3, 60) for fact in (pose(T0 + n, 3.0), driving(T0 + n))]
    assert first(given(driving(T0 + 2), *waits, gone(T0 + 60), tick(T0 + 60))).stage is Stage.DONE


@pytest.mark.parametrize(("letter", "stage"), [("D", Stage.DONE), ("C", Stage.CANCELLED_ELSEWHERE)])
def test_an_order_that_was_over_when_it_was_first_seen_has_ended(letter: str, stage: Stage) -> None:
    state = reduced(fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0), *commanded(1, ORDER, SENT, ACCEPTED))
    state = reduced(state, queue(T0 + 9, (5, 0, END, letter)), tick(T0 + 9), tick(T0 + 10))
    assert (first(state).stage, first(state).order_id) == (stage, "5")


def test_a_queue_that_came_before_the_tick_that_confirmed_and_was_read_after_it_ends_the_order() -> None:
    state = reduced(fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0), *commanded(1, ORDER, SENT, ACCEPTED))
    state = reduced(state, driving(T0 + 1), tick(T0 + 2))
    assert first(state).stage is Stage.CONFIRMED
    assert first(reduced(state, gone(T0 + 1.9), tick(T0 + 2.1))).stage is Stage.DONE


def test_orders_of_queues_that_can_never_be_read_whole_are_not_kept_for_ever() -> None:
    state = fleet()
    for n in range(9):
        orders = [(1000 * n + i, 0, END, "Q") for i in range(500)]
        state = reduced(state, replace(queue(T0 + n, *orders), fault="bad"))
    kept = state.robots[R0].traces
    assert 500 <= len(kept) <= 1000 and "8499" in kept
    for n in range(9):
        state = reduced(state, queue(T0 + 10 + n, *((1000 * n + i, 0, END, "Q") for i in range(500))))
    assert len(state.robots[R0].gone) <= 1000


def test_a_robot_that_is_not_known_to_be_elsewhere_has_driven_what_it_began() -> None:
    unplaced = reduced(fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0))
    state = reduced(unplaced, *commanded(1, ORDER, SENT, ACCEPTED), driving(T0 + 1), tick(T0 + 1))
    assert first(reduced(state, gone(T0 + 2), tick(T0 + 2))).stage is Stage.DONE


def test_a_queue_that_was_cut_short_ends_no_order() -> None:
    cut = replace(gone(T0 + 2), fault="501 orders, of which 500 are read")
    assert first(given(cut, tick(T0 + 2))).stage is Stage.CONFIRMED
    assert first(given(cut, gone(T0 + 3), tick(T0 + 4))).stage is Stage.LEFT


@pytest.mark.parametrize("removal", [CancelOrder(R0, "5"), ClearOrders(R0)])
@pytest.mark.parametrize("left", [gone(T0 + 3), queue(T0 + 3, (5, 0, END, "C"))])
def test_what_this_console_took_away_is_cancelled_and_no_alarm(removal: Command, left: QueueReported) -> None:
    state = given(*commanded(2, removal, SENT, ACCEPTED, at=T0 + 2), left, tick(T0 + 3))
    assert [record.stage for record in state.commands] == [Stage.CANCELLED, Stage.CONFIRMED]
    assert not alarm_texts(state) and first(state).detail == "order 5: by this console"


def test_a_cancel_that_was_refused_took_nothing_away() -> None:
    refused = commanded(2, CancelOrder(R0, "5"), SENT, Stage.REFUSED, at=T0 + 2)
    assert first(given(*refused, gone(T0 + 3), tick(T0 + 4))).stage is Stage.LEFT


def test_an_order_that_is_done_while_its_cancel_is_refused_is_done() -> None:
    arrived = [driving(T0 + 2), pose(T0 + 2, 3.0), *commanded(2, CancelOrder(R0, "5"), SENT, at=T0 + 2)]
    state = given(*arrived, gone(T0 + 3), tick(T0 + 3))
    assert first(state).stage is Stage.DONE


def not_confirmed(command: Command, *facts: Event) -> FleetState:
    """A command that the robot accepted, and of which nothing was seen."""
    state = reduced(fleet(), link_up(T0 - 9), *facts, tick(T0), *commanded(1, command, SENT, ACCEPTED))
    state = reduced(state, *facts, tick(T0 + PATIENCE + 0.1))
    assert first(state).stage is Stage.NOT_CONFIRMED and "not confirmed" in alarm_texts(state)[0]
    return state


@pytest.mark.parametrize("seconds", [12, 38, 500])
def test_an_order_that_is_taken_late_is_told_and_the_failure_is_cleared(seconds: int) -> None:
    state = reduced(not_confirmed(ORDER, gone(T0 - 1, 4)), driving(T0 + seconds), tick(T0 + seconds))
    record = first(state)
    assert (record.stage, record.order_id) == (Stage.LATE, "5")
    (alarm,) = (alarm for alarm in state.alarms if alarm.condition.kind == "command")
    assert alarm.needs_acknowledgement and alarm.text.startswith("carried out late: order 0 -> 7 (order 5, ")
    assert action_of(alarm.condition) == "Do not repeat the command: the robot has carried it out"
    assert first(reduced(state, gone(T0 + seconds + 1), tick(T0 + seconds + 1))).stage is Stage.DONE


def test_an_order_that_is_given_again_and_taken_is_the_second_one() -> None:
    state = reduced(not_confirmed(ORDER, gone(T0 - 1, 4)), gone(T0 + 9, 4), tick(T0 + 10))
    state = reduced(state, *commanded(2, ORDER, SENT, ACCEPTED, at=T0 + 10), driving(T0 + 11), tick(T0 + 11))
    assert [(one.stage, one.order_id) for one in state.commands] == [
        (Stage.NOT_CONFIRMED, None),
        (Stage.CONFIRMED, "5"),
    ]
    both = reduced(state, queue(T0 + 12, DRIVEN, (6, 0, END, "Q"), current=5), tick(T0 + 12))
    assert [(one.stage, one.order_id) for one in both.commands] == [(Stage.LATE, "6"), (Stage.CONFIRMED, "5")]


def test_an_order_of_the_same_ends_long_after_is_another_one() -> None:
    state = reduced(not_confirmed(ORDER, gone(T0 - 1, 4)), driving(T0 + 700), tick(T0 + 700))
    assert first(state).stage is Stage.NOT_CONFIRMED


def test_a_cancel_that_is_obeyed_late_is_told_and_an_order_that_is_driven_is_no_cancel() -> None:
    waiting = not_confirmed(CancelOrder(R0, "5"), graph(0, 1, 2, END), pose(T0), queue(T0 - 1, QUEUED))
    assert first(reduced(waiting, gone(T0 + 12), tick(T0 + 12))).stage is Stage.LATE
    driven: list[Event] = [driving(T0 + 8), pose(T0 + 9, 3.0), gone(T0 + 12), tick(T0 + 12)]
    assert first(reduced(waiting, *driven)).stage is Stage.NOT_CONFIRMED
    restarted: list[Event] = [gone(T0 + 12, 0), tick(T0 + 12)]
    assert first(reduced(waiting, *restarted)).stage is Stage.NOT_CONFIRMED


def test_a_pause_that_is_obeyed_late_is_told() -> None:
    waiting = not_confirmed(PauseRobot(R0), PausedReported(R0, T0, False))
    state = reduced(waiting, PausedReported(R0, T0 + 12, True), tick(T0 + 12))
    assert first(state).stage is Stage.LATE
    assert alarm_texts(state)[0].startswith("carried out late: pause (reported by the robot, 12 s after")


def test_a_pause_that_was_given_again_and_worked_is_not_carried_out_late() -> None:
    waiting = not_confirmed(PauseRobot(R0), PausedReported(R0, T0, False))
    again = commanded(2, PauseRobot(R0), SENT, ACCEPTED, at=T0 + 10)
    state = reduced(waiting, *again, PausedReported(R0, T0 + 11, True), tick(T0 + 11), tick(T0 + 12))
    assert [one.stage for one in state.commands] == [Stage.NOT_CONFIRMED, Stage.CONFIRMED]
    refused = commanded(2, PauseRobot(R0), SENT, Stage.REFUSED, at=T0 + 10)
    state = reduced(waiting, *refused, PausedReported(R0, T0 + 11, True), tick(T0 + 11))
    assert first(state).stage is Stage.LATE


@pytest.mark.parametrize("again", [CancelOrder(R0, "5"), ClearOrders(R0)])
def test_a_cancel_that_another_one_did_is_not_carried_out_late(again: Command) -> None:
    waiting = not_confirmed(CancelOrder(R0, "5"), graph(0, 1, 2, END), pose(T0), queue(T0 - 1, QUEUED))
    state = reduced(waiting, queue(T0 + 9, QUEUED), *commanded(2, again, SENT, ACCEPTED, at=T0 + 10))
    state = reduced(state, gone(T0 + 11), tick(T0 + 11), tick(T0 + 12))
    assert [one.stage for one in state.commands] == [Stage.NOT_CONFIRMED, Stage.CONFIRMED]


def test_where_no_topic_tells_a_pause_its_late_answer_does() -> None:
    state = reduced(fleet(), link_up(T0 - 9), tick(T0), *commanded(1, PauseRobot(R0), SENT, Stage.NO_ANSWER))
    state = reduced(state, tick(T0 + PATIENCE + 0.1))
    assert first(state).stage is Stage.NOT_CONFIRMED and not state.robots[R0].paused_by_us
    state = reduced(state, CommandAdvanced(1, ACCEPTED, T0 + 12, Message("paused")))
    assert first(state).stage is Stage.LATE and state.robots[R0].paused_by_us


def test_a_pause_that_was_only_seen_to_work_is_ours_too() -> None:
    moving = [pose(T0 - 0.2, 1.0), pose(T0 - 0.1, 1.2)]
    state = reduced(
        fleet(), link_up(T0 - 9), *moving, tick(T0), *commanded(1, PauseRobot(R0), SENT, Stage.NO_ANSWER)
    )
    state = reduced(state, pose(T0 + 1, 1.3), pose(T0 + 2.5, 1.3), tick(T0 + 2.6))
    assert first(state).stage is Stage.CONFIRMED and state.robots[R0].paused_by_us
    assert not reduced(state, pose(T0 + 4, 3.0)).robots[R0].paused_by_us


def echoed(at: float, request: int, *ids: int) -> QueueReported:
    orders = (order(id_, 0, END, "Q") for id_ in ids)
    return QueueReported(R0, at, order_queue(ids[-1], -1, *orders, request_id=request))


def test_two_consoles_that_give_the_same_order_in_one_instant_claim_one_each() -> None:
    state = reduced(fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0))
    consoles = {id_: reduced(state, *commanded(id_, ORDER, SENT, ACCEPTED)) for id_ in (111, 222)}
    for reports in ([echoed(T0 + 1, 222, 5, 6)], [echoed(T0 + 1, 111, 5), echoed(T0 + 2, 222, 5, 6)]):
        ids = {}
        for id_, console in consoles.items():
            for report in reports:
                console = reduced(console, report, tick(report.at))
            ids[id_] = first(console).order_id
        assert ids == {111: "5", 222: "6"}


def test_an_order_of_another_console_is_not_ours_carried_out_late_once_it_is_no_longer_the_newest() -> None:
    state = reduced(not_confirmed(ORDER, gone(T0 - 1, 4)), echoed(T0 + 100, 777, 5), tick(T0 + 100))
    further = order_queue(6, -1, order(5, 0, END, "Q"), order(6, 1, 2, "Q"), request_id=888)
    state = reduced(state, QueueReported(R0, T0 + 110, further), tick(T0 + 110))
    assert first(state).stage is Stage.NOT_CONFIRMED
    ours = order_queue(7, -1, *further.orders, order(7, 0, END, "Q"), request_id=1)
    state = reduced(state, QueueReported(R0, T0 + 120, ours), tick(T0 + 120))
    assert (first(state).stage, first(state).order_id) == (Stage.LATE, "7")


def test_a_robot_that_echoes_nothing_of_ours_is_believed_in_the_end() -> None:
    state = reduced(
        fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0), *commanded(111, ORDER, SENT, ACCEPTED)
    )
    state = reduced(state, echoed(T0 + 1, 77, 5), tick(T0 + 1))
    assert first(state).stage is ACCEPTED
    assert first(reduced(state, tick(T0 + PATIENCE + 0.1))).order_id == "5"


@pytest.mark.parametrize("says", [True, False])
def test_a_pause_that_a_restart_of_the_robot_ended_is_told(says: bool) -> None:
    told_by_topic: list[Event] = [PausedReported(R0, T0 + 1, True)] if says else []
    state = reduced(fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0))
    state = reduced(state, *commanded(1, PauseRobot(R0), SENT, ACCEPTED), *told_by_topic, tick(T0 + 1))
    assert first(state).stage is (Stage.CONFIRMED if says else Stage.UNVERIFIABLE)
    state = reduced(state, gone(T0 + 2, 0), tick(T0 + 2))
    record = first(state)
    assert record.stage is Stage.LOST and record.detail.endswith("no longer paused")
    assert alarm_texts(state)[0].startswith("lost: pause (the robot restarted: its order ids started over")
    assert not state.robots[R0].paused_by_us


def test_a_pause_that_was_resumed_before_the_restart_is_not_lost() -> None:
    state = reduced(fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0))
    state = reduced(state, *commanded(1, PauseRobot(R0), SENT, ACCEPTED), tick(T0 + 1))
    state = reduced(state, *commanded(2, ResumeRobot(R0), SENT, ACCEPTED, at=T0 + 1.5), tick(T0 + 2))
    state = reduced(state, gone(T0 + 2, 0), tick(T0 + 2))
    assert first(state).stage is Stage.UNVERIFIABLE and not alarm_texts(state)


def test_a_robot_that_does_not_count_its_orders_has_not_started_over() -> None:
    uncounted = [
        replace(one, queue=replace(one.queue, last_serial=0))
        for one in (queue(T0 + 2, QUEUED), driving(T0 + 3))
    ]
    begun = reduced(fleet(), link_up(T0 - 9), graph(0, 1, 2, END), pose(T0 - 1), gone(T0 - 1, 0), tick(T0))
    state = reduced(begun, *commanded(1, ORDER, SENT, ACCEPTED), *uncounted, tick(T0 + 3))
    state = reduced(state, pose(T0 + 4, 3.0), gone(T0 + 5, 0), tick(T0 + 5))
    assert first(state).stage is Stage.DONE


def test_an_order_that_a_robot_takes_after_it_was_started_anew_is_found() -> None:
    state = reduced(fleet(), link_up(T0 - 9), gone(T0 - 1, 4), tick(T0), *commanded(1, ORDER, SENT, ACCEPTED))
    state = reduced(state, queue(T0 + 1, (1, 0, END, "W"), current=1), tick(T0 + 1))
    assert (first(state).stage, first(state).order_id) == (Stage.CONFIRMED, "1")


def elsewhere(at: float, stage: Stage = SENT, order_id: str = "") -> CommandedElsewhere:
    """A cancel or clear of another console."""
    what = "cancel" if order_id else "clear"
    return CommandedElsewhere(CommandElsewhere("run 9", R0, order_id, "ana", "pc:7", at, stage, what))


@pytest.mark.parametrize(
    ("removal", "reason"),
    [
        (elsewhere(T0 + 1.9), "order 5: cleared by ana at pc:7"),
        (elsewhere(T0 + 1.9, order_id="5"), "order 5: cancelled by ana at pc:7"),
        (elsewhere(T0 + 2.5), "order 5: cleared by ana at pc:7"),
    ],
)
@pytest.mark.parametrize("left", [gone(T0 + 2), queue(T0 + 2, (5, 0, END, "C"))])
def test_what_another_console_took_away_is_cancelled_elsewhere_with_its_name(
    left: QueueReported, removal: CommandedElsewhere, reason: str
) -> None:
    """Also if this console hears of the end before it hears of the command."""
    seen = given(left, tick(T0 + 2.1))
    assert first(seen).stage is Stage.CONFIRMED
    state = reduced(seen, removal, tick(T0 + 2.6), tick(T0 + 4))
    assert (first(state).stage, first(state).detail) == (Stage.CANCELLED_ELSEWHERE, reason)
    (alarm,) = state.alarms
    assert alarm.text.startswith("cancelled elsewhere: order 0 -> 7 (order 5: c")
    assert "again" not in action_of(alarm.condition)


@pytest.mark.parametrize(
    "removal",
    [
        elsewhere(T0 + 1.9, Stage.REFUSED),
        elsewhere(T0 + 1.9, order_id="6"),
        elsewhere(T0 - 5),
        CommandedElsewhere(CommandElsewhere("run 9", "robot_1", "", "ana", "pc:7", T0 + 1.9, SENT, "clear")),
    ],
)
def test_what_removed_another_order_or_none_explains_nothing(removal: CommandedElsewhere) -> None:
    state = given(removal, gone(T0 + 2), tick(T0 + 3))
    assert first(state).stage is Stage.LEFT
    (alarm,) = state.alarms
    assert alarm.text == "left the queue: order 0 -> 7 (order 5: not by this console, before it started)"
    assert "again" not in action_of(alarm.condition)
    assert state.alarms[0].condition.over == "left the queue: order 0 -> 7"


def test_a_cancel_elsewhere_that_is_refused_later_took_nothing_away() -> None:
    state = given(elsewhere(T0 + 1.9), elsewhere(T0 + 2.2, Stage.REFUSED), gone(T0 + 2.1), tick(T0 + 4))
    assert first(state).stage is Stage.LEFT


def test_an_order_that_is_done_where_another_console_only_tried_to_cancel_it_is_done() -> None:
    arrived: list[Event] = [driving(T0 + 2), pose(T0 + 2, 3.0), elsewhere(T0 + 2)]
    assert first(given(*arrived, gone(T0 + 3), tick(T0 + 5))).stage is Stage.DONE
    ended = given(*arrived, elsewhere(T0 + 2.1, ACCEPTED), gone(T0 + 3), tick(T0 + 5))
    assert first(ended).stage is Stage.CANCELLED_ELSEWHERE


def test_an_end_that_the_robot_reports_is_not_overruled_by_what_others_say_they_did() -> None:
    done = queue(T0 + 3, (5, 0, END, "D"))
    assert first(given(elsewhere(T0 + 2, ACCEPTED), done, tick(T0 + 5))).stage is Stage.DONE


def test_evidence_that_comes_late_corrects_the_end() -> None:
    state = given(gone(T0 + 2), tick(T0 + 4))
    assert first(state).stage is Stage.LEFT
    state = reduced(state, elsewhere(T0 + 1.9, Stage.CONFIRMED), tick(T0 + 6))
    record = first(state)
    assert record.stage is Stage.CANCELLED_ELSEWHERE
    assert record.detail == "order 5: cleared by ana at pc:7; corrects: left the queue"
    assert [alarm.text for alarm in state.alarms if alarm.holds] == [
        "cancelled elsewhere: order 0 -> 7 (order 5: cleared by ana at pc:7; corrects: left the queue)"
    ]


def test_a_cancel_that_nobody_saw_take_effect_is_no_cause_of_an_end_long_after_it() -> None:
    for after, stage in ((10.0, Stage.CANCELLED_ELSEWHERE), (200.0, Stage.LEFT)):
        drives = [driving(T0 + 2 + n) for n in range(int(after))]
        tried = elsewhere(T0 + 2.5, Stage.NOT_CONFIRMED)
        state = given(
            drives[0], tried, *drives[1:], pose(T0 + after), gone(T0 + after + 2), tick(T0 + after + 4)
        )
        assert first(state).stage is stage


def test_news_of_another_machine_that_are_late_correct_the_end() -> None:
    state = given(gone(T0 + 2), tick(T0 + 4))
    news = replace(elsewhere(T0 + 5, Stage.CONFIRMED).command, is_arrival=True)
    assert first(reduced(state, CommandedElsewhere(news), tick(T0 + 6))).stage is Stage.CANCELLED_ELSEWHERE
    assert first(reduced(state, elsewhere(T0 + 5, Stage.CONFIRMED), tick(T0 + 6))).stage is Stage.LEFT


def test_an_order_that_is_listed_again_has_not_ended() -> None:
    lost = given(driving(T0 + 2), gone(T0 + 44), tick(T0 + 45), tick(T0 + 46))
    assert first(lost).stage is Stage.LOST and of_command(lost)
    state = reduced(lost, driving(T0 + 47), tick(T0 + 47.1))
    assert (first(state).stage, first(state).detail) == (
        Stage.CONFIRMED,
        "order 5: listed again; corrects: lost",
    )
    assert of_command(state) == [] and not state.robots[R0].gone
    state = reduced(state, pose(T0 + 48, 3.0), driving(T0 + 48), gone(T0 + 49), tick(T0 + 51))
    assert first(state).stage is Stage.DONE


def of_command(state: FleetState) -> list[AlarmStage]:
    return [alarm.stage for alarm in state.alarms if alarm.condition.kind == "command"]


@pytest.mark.parametrize("stage", [AlarmStage.UNACKNOWLEDGED, AlarmStage.RETURNED])
def test_an_end_that_is_reported_late_takes_the_lost_order_and_its_alarm_back(stage: AlarmStage) -> None:
    later = T0 + 46 if stage is AlarmStage.UNACKNOWLEDGED else T0 + 200
    lost = given(driving(T0 + 2), gone(T0 + 44), tick(T0 + 45), tick(later))
    assert first(lost).stage is Stage.LOST and of_command(lost) == [stage]
    state = reduced(lost, queue(later, (5, 0, END, "D")), tick(later + 0.1))
    assert (first(state).stage, first(state).detail) == (
        Stage.DONE,
        "order 5: as reported by the robot; corrects: lost",
    )
    assert of_command(state) == []
    assert [one.stage for one in state.robots[R0].gone] == [Stage.DONE]


def test_the_robots_own_report_corrects_what_only_another_console_told() -> None:
    state = given(driving(T0 + 2), elsewhere(T0 + 2.5), gone(T0 + 3), tick(T0 + 5))
    assert first(state).stage is Stage.CANCELLED_ELSEWHERE
    state = reduced(state, queue(T0 + 300, (5, 0, END, "D")), tick(T0 + 301))
    assert (first(state).stage, first(state).detail) == (
        Stage.DONE,
        "order 5: as reported by the robot; corrects: cancelled elsewhere",
    )
    assert of_command(state) == []


def test_ids_that_started_over_take_nothing_back() -> None:
    lost = given(driving(T0 + 2), gone(T0 + 3, 0), tick(T0 + 4))
    state = reduced(lost, queue(T0 + 9, (5, 0, END, "D")), tick(T0 + 10))
    assert first(state).stage is Stage.LOST
