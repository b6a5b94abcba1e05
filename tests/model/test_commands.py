"""The life of a command: only along the table, one end, and the truth that telemetry tells of it."""

import pytest
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule
from msgspec.structs import replace

from fleet_tui.model.commands import (
    NEXT,
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced, Event, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import chain
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    tick,
    told,
)

ORDER = place_order(R0, 1, 2)
SENT, ACCEPTED, UNKNOWN, NO_ANSWER = Stage.SENT, Stage.ACCEPTED, Stage.UNKNOWN, Stage.NO_ANSWER
PATIENCE = fleet().limits.confirm_after


def up(*facts: Event) -> FleetState:
    """A fleet with a link, and a queue in which order 4 is the last."""
    return told(fleet(), link_up(T0 - 100), queue(T0 - 1, (4, 8, 9, "W"), current=4), tick(T0), *facts)


def only(state: FleetState) -> CommandRecord:
    (record,) = state.commands
    return record


def test_every_stage_has_its_place_in_the_table() -> None:
    assert set(NEXT) == set(Stage)
    reached, new = {Stage.CHECKED}, {Stage.CHECKED}
    while new:
        new = {later for stage in new for later in NEXT[stage]} - reached
        reached |= new
    assert reached == set(Stage)


@pytest.mark.parametrize("answer", [ACCEPTED, NO_ANSWER, UNKNOWN])
def test_an_order_that_appears_in_the_queue_is_confirmed_whatever_was_answered(answer: Stage) -> None:
    state = up(*commanded(1, ORDER, SENT, answer), tick(T0 + 1))
    assert only(state).stage is answer
    state = told(state, queue(T0 + 2, (4, 8, 9, "W"), (5, 1, 2, "Q"), current=4), tick(T0 + 2))
    assert (only(state).stage, only(state).order_id) == (Stage.CONFIRMED, "5")
    assert only(state).words == "seen in the queue as order 5"


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
    waiting = told(state, tick(T0 + PATIENCE - 0.1))
    assert only(waiting).stage is ACCEPTED
    ended = told(waiting, tick(T0 + PATIENCE + 0.1))
    assert only(ended).stage is Stage.NOT_CONFIRMED
    assert only(ended).words.startswith("accepted; ") and instead in only(ended).words


def test_a_queue_older_than_the_command_proves_nothing() -> None:
    state = told(fleet(), link_up(T0 - 9), *commanded(1, ORDER, SENT, ACCEPTED))
    assert only(told(state, queue(T0, (9, 1, 2, "Q")), tick(T0 + 1))).stage is ACCEPTED


def test_an_order_of_a_robot_whose_queue_was_never_seen_is_not_known() -> None:
    state = told(
        fleet(), link_up(T0 - 9), *commanded(1, ORDER, SENT, ACCEPTED), queue(T0 + 1, (9, 1, 2, "Q"))
    )
    record = only(told(state, tick(T0 + PATIENCE + 1)))
    assert record.stage is Stage.NOT_CONFIRMED and "queue unknown before" in record.words


def test_two_same_orders_are_two_in_the_queue() -> None:
    state = up(*commanded(1, ORDER, SENT, ACCEPTED), *commanded(2, ORDER, SENT, ACCEPTED))
    one = told(state, queue(T0 + 1, (5, 1, 2, "W")), tick(T0 + 1))
    assert [record.stage for record in one.commands] == [Stage.CONFIRMED, ACCEPTED]
    two = told(one, queue(T0 + 2, (5, 1, 2, "W"), (6, 1, 2, "Q")), tick(T0 + 2))
    assert [record.order_id for record in two.commands] == ["5", "6"]


def test_with_cargo_only_the_destination_counts() -> None:
    state = up(*commanded(1, place_order(R0, 2), SENT, ACCEPTED))
    assert only(told(state, queue(T0 + 1, (5, 77, 2, "W")), tick(T0 + 1))).stage is Stage.CONFIRMED


def test_without_a_link_nothing_is_decided_and_after_it_the_queue_decides() -> None:
    state = up(
        *commanded(1, ORDER, SENT), link_lost(T0 + 1), CommandAdvanced(1, UNKNOWN, T0 + 1, "link lost")
    )
    dark = told(state, tick(T0 + 500))
    assert only(dark).stage is UNKNOWN
    back = told(dark, link_up(T0 + 500), tick(T0 + 500 + PATIENCE - 0.1))
    assert only(back).stage is UNKNOWN
    placed = told(back, queue(T0 + 504, (5, 1, 2, "Q")), tick(T0 + 504.9))
    assert only(placed).stage is Stage.CONFIRMED
    restarted = told(back, queue(T0 + 504), tick(T0 + 500 + PATIENCE))
    assert only(restarted).stage is Stage.NOT_CONFIRMED
    assert only(restarted).words == "outcome unknown: link lost; order not in the queue"


def test_a_late_answer_still_counts() -> None:
    late = [CommandAdvanced(1, NO_ANSWER, T0 + 5), CommandAdvanced(1, Stage.REFUSED, T0 + 8, "REJECTED")]
    record = only(up(*commanded(1, ORDER, SENT), *late))
    assert (record.stage, record.words) == (Stage.REFUSED, "REJECTED")


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
    assert ("order 4 is" in only(state).words) is (stage is Stage.NOT_CONFIRMED)


@pytest.mark.parametrize(("command", "says"), [(PauseRobot(R0), True), (ResumeRobot(R0), False)])
def test_the_robots_own_word_confirms_a_pause(command: Command, says: bool) -> None:
    state = up(PausedReported(R0, T0, not says), *commanded(1, command, SENT, ACCEPTED))
    assert only(told(state, tick(T0 + 1))).stage is ACCEPTED
    assert only(told(state, PausedReported(R0, T0 + 1, says), tick(T0 + 1))).stage is Stage.CONFIRMED
    against = told(state, PausedReported(R0, T0 + 1, not says), tick(T0 + PATIENCE))
    assert only(against).stage is Stage.NOT_CONFIRMED and "reported" in only(against).words


@pytest.mark.parametrize("command", [PauseRobot(R0), ResumeRobot(R0)])
def test_where_nothing_shows_it_an_accepted_pause_is_only_accepted(command: Command) -> None:
    parked = up(pose(T0 - 50), pose(T0), *commanded(1, command, SENT, ACCEPTED), tick(T0))
    assert only(parked).stage is Stage.UNVERIFIABLE
    assert "accepted" in Stage.UNVERIFIABLE.value


def test_a_pause_that_a_topic_is_to_show_waits_for_it() -> None:
    """A pause given before anything was heard, as from a shell, is not taken for one that nothing shows."""
    state = up()
    state = replace(state, robots={R0: replace(state.robots[R0], says_paused=True)})
    state = told(state, *commanded(1, PauseRobot(R0), SENT, ACCEPTED), tick(T0))
    assert only(state).stage is ACCEPTED
    assert only(told(state, PausedReported(R0, T0 + 1, True), tick(T0 + 1))).stage is Stage.CONFIRMED
    silent = only(told(state, tick(T0 + PATIENCE)))
    assert (silent.stage, silent.words) == (
        Stage.NOT_CONFIRMED,
        "accepted; no message on the pause topic",
    )


def test_a_robot_that_was_driving_and_stands_still_is_seen_to_have_paused() -> None:
    driving = up(pose(T0 - 0.1), pose(T0, 0.2), *commanded(1, PauseRobot(R0), SENT, ACCEPTED), tick(T0))
    assert only(driving).stage is ACCEPTED
    stopped = told(driving, pose(T0 + 0.1, 0.3), pose(T0 + 1.2, 0.31), tick(T0 + 1.2))
    assert (only(stopped).stage, only(stopped).words) == (Stage.CONFIRMED, "the robot stopped")
    rolling = [pose(T0 + n / 2, 0.2 + n) for n in range(1, 12)]
    on = told(driving, *rolling, tick(T0 + PATIENCE))
    assert only(on).stage is Stage.NOT_CONFIRMED and "kept moving" in only(on).words


def test_a_robot_that_stops_at_once_and_reports_no_further_place_has_paused() -> None:
    driving = up(pose(T0 - 0.1), pose(T0 - 0.05, 0.2), *commanded(1, PauseRobot(R0), SENT, ACCEPTED))
    assert only(told(driving, pose(T0 + 0.5, 0.2), tick(T0 + 3))).stage is ACCEPTED  # silence is no standing
    stopped = told(driving, pose(T0 + 0.5, 0.2), pose(T0 + 1.1, 0.2), tick(T0 + 1.2))
    assert (only(stopped).stage, only(stopped).words) == (Stage.CONFIRMED, "the robot stopped")


def test_what_is_seen_after_the_opposite_took_effect_is_not_the_doing_of_a_pause() -> None:
    driving = up(pose(T0 - 0.1), pose(T0, 0.2), *commanded(1, PauseRobot(R0), SENT, ACCEPTED))
    refused = told(driving, *commanded(2, ResumeRobot(R0), SENT, Stage.REFUSED, at=T0 + 0.2), tick(T0 + 0.3))
    assert refused.commands[0].stage is ACCEPTED
    resumed = told(driving, *commanded(2, ResumeRobot(R0), SENT, ACCEPTED, at=T0 + 0.2), tick(T0 + 0.3))
    assert resumed.commands[0].stage is Stage.UNVERIFIABLE
    quick = up(PausedReported(R0, T0, False), *commanded(1, PauseRobot(R0), SENT, ACCEPTED))
    quick = told(quick, *commanded(2, ResumeRobot(R0), SENT, ACCEPTED, at=T0 + 0.2))
    quick = told(quick, PausedReported(R0, T0 + 0.5, False), tick(T0 + PATIENCE))
    assert [one.stage for one in quick.commands] == [Stage.UNVERIFIABLE, Stage.CONFIRMED]


def test_a_robot_that_stood_all_the_time_is_not_said_to_move() -> None:
    parked = up(pose(T0 - 50), pose(T0), *commanded(1, PauseRobot(R0), SENT, NO_ANSWER), pose(T0 + 4))
    end = only(told(parked, tick(T0 + PATIENCE)))
    assert (end.stage, end.words.rpartition("; ")[2]) == (Stage.NOT_CONFIRMED, "no evidence in telemetry")


@pytest.mark.parametrize("command", [PauseRobot(R0), ResumeRobot(R0)])
@pytest.mark.parametrize("says", [True, False])
def test_the_end_of_a_pause_does_not_read_as_if_it_were_paused(command: Command, says: bool) -> None:
    asked = up(PausedReported(R0, T0, not says), *commanded(1, command, SENT, ACCEPTED))
    end = only(told(asked, PausedReported(R0, T0 + 1, says), tick(T0 + PATIENCE)))
    assert end.is_decided and "paused" not in end.words


COMMANDS = [
    ORDER,
    place_order(R0, 2),
    CancelOrder(R0, "4"),
    ClearOrders(R0),
    PauseRobot(R0),
    ResumeRobot(R0),
]


class Life(RuleBasedStateMachine):
    """A link that answers, is late, drops and returns, and a robot that reports what it likes."""

    def __init__(self) -> None:
        super().__init__()
        self.state, self.now, self.id = up(), T0, 0
        self.seen: dict[int, CommandRecord] = {}

    def tell(self, *facts: Event) -> None:
        self.state = told(self.state, *facts)

    @rule(command=st.sampled_from(COMMANDS), sent=st.booleans())
    def give(self, command: Command, sent: bool) -> None:
        self.id += 1
        self.tell(*commanded(self.id, command, SENT if sent else Stage.NOT_SENT, at=self.now))

    @precondition(lambda self: self.id)
    @rule(stage=st.sampled_from(Stage), which=st.integers(0, 9))
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


def test_a_robot_that_drives_goals_takes_a_chain_as_one_order() -> None:
    assert chain(R0, ["1", "2", "3"], in_one=True) == (PlaceOrder(R0, at_vertices("1", "2", "3")),)
    assert chain(R0, ["3"], with_cargo=True, in_one=True) == (PlaceOrder(R0, at_vertices("3")),)
