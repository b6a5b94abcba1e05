"""The life of a command: only along the table, one end, and the truth that telemetry tells of it."""

import pytest
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced, Event, PausedReported
from fleet_tui.text.language import Message
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    link_lost,
    link_up,
    place_order,
    queue,
    reduced,
    tick,
)
from tests.support.one_command import ACCEPTED, NO_ANSWER, ORDER, PATIENCE, SENT, UNKNOWN, only, up


@pytest.mark.parametrize("answer", [ACCEPTED, NO_ANSWER, UNKNOWN])
def test_an_order_that_appears_in_the_queue_is_confirmed_whatever_was_answered(answer: Stage) -> None:
    state = up(*commanded(1, ORDER, SENT, answer), tick(T0 + 1))
    assert only(state).stage is answer
    state = reduced(state, queue(T0 + 2, (4, 8, 9, "W"), (5, 1, 2, "Q"), current=4), tick(T0 + 2))
    assert (only(state).stage, only(state).order_id) == (Stage.CONFIRMED, "5")
    assert only(state).detail == "seen in the queue as order 5"


@pytest.mark.parametrize(
    ("orders", "instead"),
    [
        ((), "no queue received since"),
        (((4, 1, 2, "Q"),), "not in the queue"),  # the same ends, but it was there before
        (((5, 1, 3, "Q"),), "not in the queue"),  # another destination: somebody else's
    ],
)
def test_what_is_not_seen_is_not_confirmed_and_says_what_is(
    orders: tuple[tuple[int, int, int, str], ...], instead: str
) -> None:
    state = up(*commanded(1, ORDER, SENT, ACCEPTED), *([queue(T0 + 1, *orders)] if orders else []))
    waiting = reduced(state, tick(T0 + PATIENCE - 0.1))
    assert only(waiting).stage is ACCEPTED
    ended = reduced(waiting, tick(T0 + PATIENCE + 0.1))
    assert only(ended).stage is Stage.NOT_CONFIRMED
    assert only(ended).detail.startswith("accepted; ") and instead in only(ended).detail


def test_a_queue_older_than_the_command_proves_nothing() -> None:
    state = reduced(fleet(), link_up(T0 - 9), *commanded(1, ORDER, SENT, ACCEPTED))
    assert only(reduced(state, queue(T0, (9, 1, 2, "Q")), tick(T0 + 1))).stage is ACCEPTED


def test_an_order_of_a_robot_whose_queue_was_never_seen_is_not_known() -> None:
    state = reduced(
        fleet(), link_up(T0 - 9), *commanded(1, ORDER, SENT, ACCEPTED), queue(T0 + 1, (9, 1, 2, "Q"))
    )
    record = only(reduced(state, tick(T0 + PATIENCE + 1)))
    assert record.stage is Stage.NOT_CONFIRMED and "queue unknown before" in record.detail


def test_two_same_orders_are_two_in_the_queue() -> None:
    state = up(*commanded(1, ORDER, SENT, ACCEPTED), *commanded(2, ORDER, SENT, ACCEPTED))
    one = reduced(state, queue(T0 + 1, (5, 1, 2, "W")), tick(T0 + 1))
    assert [record.stage for record in one.commands] == [Stage.CONFIRMED, ACCEPTED]
    two = reduced(one, queue(T0 + 2, (5, 1, 2, "W"), (6, 1, 2, "Q")), tick(T0 + 2))
    assert [record.order_id for record in two.commands] == ["5", "6"]


def test_with_cargo_only_the_destination_counts() -> None:
    state = up(*commanded(1, place_order(R0, 2), SENT, ACCEPTED))
    assert only(reduced(state, queue(T0 + 1, (5, 77, 2, "W")), tick(T0 + 1))).stage is Stage.CONFIRMED


def test_without_a_link_nothing_is_decided_and_after_it_the_queue_decides() -> None:
    state = up(
        *commanded(1, ORDER, SENT),
        link_lost(T0 + 1),
        CommandAdvanced(1, UNKNOWN, T0 + 1, Message("link lost")),
    )
    dark = reduced(state, tick(T0 + 500))
    assert only(dark).stage is UNKNOWN
    back = reduced(dark, link_up(T0 + 500), tick(T0 + 500 + PATIENCE - 0.1))
    assert only(back).stage is UNKNOWN
    placed = reduced(back, queue(T0 + 504, (5, 1, 2, "Q")), tick(T0 + 504.9))
    assert only(placed).stage is Stage.CONFIRMED
    restarted = reduced(back, queue(T0 + 504), tick(T0 + 500 + PATIENCE))
    assert only(restarted).stage is Stage.NOT_CONFIRMED
    assert only(restarted).detail == "outcome unknown: link lost; order not in the queue"


def test_a_late_answer_still_counts() -> None:
    late = [
        CommandAdvanced(1, NO_ANSWER, T0 + 5),
        CommandAdvanced(1, Stage.REFUSED, T0 + 8, Message("REJECTED")),
    ]
    record = only(up(*commanded(1, ORDER, SENT), *late))
    assert (record.stage, record.detail) == (Stage.REFUSED, "REJECTED")


@pytest.mark.parametrize(
    ("command", "queue_then", "stage"),
    [
        (CancelOrder(R0, "4"), (), Stage.CONFIRMED),
        (CancelOrder(R0, "4"), ((4, 8, 9, "C"),), Stage.CONFIRMED),
        (CancelOrder(R0, "4"), ((4, 8, 9, "W"),), Stage.NOT_CONFIRMED),
        (CancelOrder(R0, "4"), ((4, 8, 9, "D"),), Stage.NOT_CONFIRMED),
        (ClearOrders(R0), (), Stage.CONFIRMED),
        (ClearOrders(R0), ((4, 8, 9, "D"), (5, 1, 2, "W")), Stage.CONFIRMED),  # 5 came after the clear
        (ClearOrders(R0), ((4, 8, 9, "W"),), Stage.NOT_CONFIRMED),
    ],
)
def test_what_was_to_go_is_gone_or_is_named(
    command: Command, queue_then: tuple[tuple[int, int, int, str], ...], stage: Stage
) -> None:
    state = up(*commanded(1, command, SENT, ACCEPTED), queue(T0 + 1, *queue_then), tick(T0 + PATIENCE))
    assert only(state).stage is stage
    assert ("order 4 is" in only(state).detail) is (stage is Stage.NOT_CONFIRMED)


COMMANDS = [ORDER, place_order(R0, 2), CancelOrder(R0, "4"), ClearOrders(R0), PauseRobot(R0), ResumeRobot(R0)]


class Life(RuleBasedStateMachine):
    """A link that answers, is late, drops and returns, and a robot that reports what it likes."""

    def __init__(self) -> None:
        super().__init__()
        self.state, self.now, self.id = up(), T0, 0
        self.seen: dict[int, CommandRecord] = {}

    def tell(self, *facts: Event) -> None:
        self.state = reduced(self.state, *facts)

    @rule(command=st.sampled_from(COMMANDS), sent=st.booleans())
    def give(self, command: Command, sent: bool) -> None:
        self.id += 1
        self.tell(*commanded(self.id, command, SENT if sent else Stage.NOT_SENT, at=self.now))

    @precondition(lambda self: self.id)
    # An order comes back to this console's queue only where it keeps one: not for these robots.
    @rule(stage=st.sampled_from([one for one in Stage if one is not Stage.WAITING]), which=st.integers(0, 9))
    def answer(self, stage: Stage, which: int) -> None:
        self.tell(CommandAdvanced(1 + which % self.id, stage, self.now))

    @rule(
        orders=st.lists(
            st.tuples(st.integers(1, 9), st.integers(1, 3), st.integers(1, 3), st.sampled_from("WQDC"))
        )
    )
    def report(self, orders: list[tuple[int, int, int, str]]) -> None:
        self.tell(queue(self.now, *orders))

    @rule(says=st.booleans())
    def say_paused(self, says: bool) -> None:
        self.tell(PausedReported(R0, self.now, says))

    @rule(seconds=st.floats(0.1, 8.0))
    def wait(self, seconds: float) -> None:
        self.now += seconds
        self.tell(tick(self.now))

    @rule(is_up=st.booleans())
    def change_link(self, is_up: bool) -> None:
        self.tell(link_up(self.now) if is_up else link_lost(self.now))

    @invariant()
    def an_outcome_stays_and_an_order_is_the_doing_of_one_command(self) -> None:
        for record in self.state.commands:
            before = self.seen.get(record.id, record)
            assert record.steps[: len(before.steps)] == before.steps
            assert before.outcome in (None, record.outcome)
            self.seen[record.id] = record
        claimed = [record.order_id for record in self.state.commands if record.has_open_order]
        assert len(claimed) == len(set(claimed))

    def teardown(self) -> None:
        """Once the link has told how each went, and is up for long enough, every command has ended."""
        for record in self.state.commands:
            self.tell(CommandAdvanced(record.id, UNKNOWN, self.now))
        self.tell(link_up(self.now), tick(self.now + 2 * PATIENCE))
        assert all(record.is_decided for record in self.state.commands)


TestLife = Life.TestCase
