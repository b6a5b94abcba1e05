"""The life of a lane: what follows what, and that each block that begins ends exactly once."""

from hypothesis import given

from fleet_tui.features.routines.blocks import LanePlan
from fleet_tui.features.routines.lane import (
    EndProgram,
    Gate,
    LaneEvent,
    LanePaused,
    LanePhase,
    LaneResumed,
    LaneSkipped,
    LaneStepped,
    OrderEnded,
    OrderWithheld,
    ProgramEnded,
    Ticked,
)
from fleet_tui.features.routines.rules.stepping import MOST_MOVES, TABLE
from fleet_tui.text.language import Message
from tests.support.routines import STOP, LedLane, facts, lane_events, plan_of, plans

DONE, LOST = OrderEnded(True), OrderEnded(False, Message("lost"))
CUT = Ticked(facts(no_link=Message("connection refused")))


@given(plans, lane_events)
def test_each_block_that_begins_ends_exactly_once(plan: LanePlan, events: list[LaneEvent]) -> None:
    led = LedLane(plan)
    for event in events:
        before, count = led.lane, len(led.ordered)
        led.after(event)
        led.open_blocks()
        if before.gate in (Gate.PAUSED, Gate.HELD) or before.is_over:
            assert len(led.ordered) == count, "nothing follows what is paused, held or over"
        if led.lane.is_over:
            assert not led.open_blocks()
    led.after(STOP)
    assert led.lane.is_over and not led.open_blocks()


@given(plans)
def test_whatever_fails_it_comes_to_an_end(plan: LanePlan) -> None:
    led = LedLane(plan)
    for _ in range(1000):
        led.after(Ticked(facts(1e9, holds=lambda _: False)), LOST, ProgramEnded(False), LaneSkipped())
        if led.lane.phase in (LanePhase.WAITING, LanePhase.READY):
            break
    led.after(STOP)
    assert not led.open_blocks()


def test_instructions_follow_each_other_round_after_round() -> None:
    led = LedLane(plan_of("repeat 2", "go A", "go B", "end", "go C"))
    for _ in range(5):
        assert led.ticked().phase is LanePhase.ORDERED
        led.after(DONE)
    assert led.ticked().phase is LanePhase.DONE and led.ordered == [3, 4, 3, 4, 6]
    assert led.notes[-1] == ("done", 0)


def test_waits_for_a_time_and_for_a_condition() -> None:
    led = LedLane(plan_of("wait 30 s", "wait until 00:02", "wait until idle", "go A"))
    assert led.ticked(10.0).until == 40.0
    assert led.ticked(39.0).phase is LanePhase.WAITING and led.ticked(40.0).phase is LanePhase.READY
    assert led.ticked(41.0).until == 120.0
    led.ticked(120.0)
    led.ticked(121.0)
    for unknown in (lambda _: None, lambda _: False):
        assert led.after(Ticked(facts(122.0, holds=unknown))).phase is LanePhase.WAITING
    assert led.ticked(123.0).phase is LanePhase.READY and led.ordered == []


def test_without_a_link_nothing_follows_until_a_person_resumes() -> None:
    led = LedLane(plan_of("go A", "go B"))
    led.ticked()
    held = led.after(CUT)
    assert (held.gate, held.detail, held.phase) == (Gate.HELD, "connection refused", LanePhase.ORDERED)
    assert led.after(DONE).phase is LanePhase.READY, "the outcome of the running order is still taken"
    led.ticked()
    assert led.ordered == [2]
    led.after(LaneResumed())
    led.ticked()
    assert led.ordered == [2, 3]


def test_a_resume_while_the_link_is_down_is_held_again() -> None:
    led = LedLane(plan_of("go A"))
    led.after(CUT, LaneResumed(), CUT)
    assert led.lane.gate is Gate.HELD and led.ordered == []


def test_an_order_that_failed_while_held_is_for_a_person_to_decide() -> None:
    for decision, orders in ((LaneResumed(), [2, 2]), (LaneSkipped(), [2, 3])):
        led = LedLane(plan_of("go A", "go B", "on failure", "go C", "end"))
        led.ticked()
        assert led.after(CUT, LOST).detail == "lost" and led.lane.gate is Gate.HELD
        led.after(decision)
        led.ticked()
        assert led.ordered == orders


def test_a_failure_leaves_every_block_and_begins_the_last_part_once() -> None:
    led = LedLane(plan_of("repeat", "if idle", "go A", "end", "end", "on failure", "go B", "end"))
    led.ticked()
    led.after(LOST)
    assert led.open_blocks() == [] and led.ticked().detail == "lost"
    assert led.ordered == [4, 8]
    led.after(DONE)
    assert led.ticked().phase is LanePhase.FAILED and led.lane.detail == "lost"


def test_a_failure_of_the_last_part_tells_both_reasons() -> None:
    led = LedLane(plan_of("go A", "on failure", "go B", "end"))
    led.ticked()
    led.after(LOST)
    led.ticked()
    assert led.after(OrderEnded(False, Message("refused"))).detail == "lost; then refused"
    assert led.lane.phase is LanePhase.FAILED and led.ordered == [2, 4]


def test_an_order_that_was_not_sent_is_held_and_given_again_after_a_resume() -> None:
    led = LedLane(plan_of("go A"))
    led.ticked()
    held = led.after(OrderWithheld(Message("robot_0 is paused")))
    assert (held.gate, held.phase, held.detail) == (Gate.HELD, LanePhase.READY, "robot_0 is paused")
    led.after(LaneResumed())
    led.ticked()
    assert led.ordered == [2, 2]


def test_a_pause_lets_the_order_go_on_and_a_step_lets_one_follow() -> None:
    led = LedLane(plan_of("go A", "go B", "go C"))
    led.ticked()
    led.after(LanePaused(), DONE)
    led.ticked()
    assert led.ordered == [2]
    led.after(LaneStepped())
    led.ticked()
    assert led.ordered == [2, 3] and led.after(DONE).gate is Gate.PAUSED
    led.ticked()
    assert led.ordered == [2, 3]


def test_a_stop_leaves_a_running_order_and_ends_a_program() -> None:
    led = LedLane(plan_of("go A"))
    led.ticked()
    assert led.after(STOP).phase is LanePhase.STOPPED and EndProgram() not in led.actions
    led = LedLane(plan_of("run x"))
    led.ticked()
    led.after(STOP)
    assert EndProgram() in led.actions and led.after(ProgramEnded(True)).phase is LanePhase.STOPPED


def test_a_condition_that_nothing_tells_fails() -> None:
    led = LedLane(plan_of("if battery < 30", "go A", "end"))
    failed = led.after(Ticked(facts(holds=lambda _: None)))
    assert failed.phase is LanePhase.FAILED and failed.detail == "if battery < 30: unknown"


def test_rounds_without_an_instruction_end_a_tick() -> None:
    led = LedLane(plan_of("repeat 10000", "repeat 10000", "end", "end"))
    assert led.ticked().phase is LanePhase.READY and len(led.actions) <= MOST_MOVES


def test_the_table_has_no_event_for_a_lane_that_is_over() -> None:
    assert not {phase for phase, _ in TABLE} & {LanePhase.DONE, LanePhase.FAILED, LanePhase.STOPPED}
