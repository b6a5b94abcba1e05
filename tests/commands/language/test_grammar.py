"""The command language: what each line asks, what is said of one that asks nothing."""

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from fleet_tui.commands.language.completion import complete, is_command
from fleet_tui.commands.language.grammar import parse, parse_words, written
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import QueueReported
from fleet_tui.model.kind import ORDER_TO, Kind
from fleet_tui.model.order import Order, OrderQueue, OrderState, at_vertices
from fleet_tui.text.errors import CommandError
from tests.support.fleets import R0, T0, commanded, fleet, graph, labels, of_kinds, place_order, pose, reduced
from tests.support.typed import R1, known

ASKED: list[tuple[str, tuple[Command, ...]]] = [
    ("robot_0 Base > Consumidores", (place_order(R0, 1, 2),)),
    ("  ROBOT_0   base>CONSUMIDORES ", (place_order(R0, 1, 2),)),
    ("robot_0 Base -> Consumidores", (place_order(R0, 1, 2),)),
    ("robot_0 x->Base", (place_order(R0, 6, 1),)),
    ("robot_0 x- -> Base", (place_order(R0, 6, 1),)),
    ("order robot_0 Base > Consumidores", (place_order(R0, 1, 2),)),
    ("order robot_0 Base Consumidores", (place_order(R0, 1, 2),)),
    ("1 Base > 2", (place_order(R1, 1, 2),)),
    ("robot_0 Base > 9 > Base", (place_order(R0, 1, 9), place_order(R0, 9, 1))),
    ("order robot_0 1 2 3", (place_order(R0, 1, 2), place_order(R0, 2, 3))),
    ("robot_0 Dock 7 > Joe's", (place_order(R0, 3, 5),)),
    ("robot_0 'Lab > base' > Joe's", (place_order(R0, 4, 5),)),
    ("order robot_0 'Dock 7' \"Joe's\"", (place_order(R0, 3, 5),)),
    ("robot_0 77 > Base", (place_order(R0, 77, 1),)),  # the checks say that there is none
    ("robot_0 > Base", (place_order(R0, 1),)),
    ("robot_0 Base to Consumidores", (place_order(R0, 1, 2),)),
    ("robot_0 to Base", (place_order(R0, 1),)),
    ("robot_0 Dock 7 to Joe's to 9", (place_order(R0, 3, 5), place_order(R0, 5, 9))),
    ("robot_0 > Base > 2", (place_order(R0, 1), place_order(R0, 1, 2))),
    ("order robot_0 Base", (place_order(R0, 1),)),
    ("cancel 12", (CancelOrder(R0, "12"),)),
    ("cancel robot_1 12", (CancelOrder(R1, "12"),)),
    ("Cancel 1 0", (CancelOrder(R1, "0"),)),
    ("clear robot_0", (ClearOrders(R0),)),
    ("pause robot_0", (PauseRobot(R0),)),
    ("pause all", (PauseRobot(R0), PauseRobot(R1))),
    ("resume robot_0", (ResumeRobot(R0),)),
    ("RESUME ALL", (ResumeRobot(R0), ResumeRobot(R1))),
]


@pytest.mark.parametrize(("line", "asked"), ASKED, ids=[line for line, _ in ASKED])
def test_what_a_line_asks(line: str, asked: tuple[Command, ...]) -> None:
    assert parse(line, known(), R0).commands == asked


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("robot_9 Base > 2", "unknown robot 'robot_9', did you mean robot_1?"),
        ("oder robot_0 Base 2", "unknown robot or command 'oder', did you mean order?"),
        ("robot_0 Bse > 2", "robot_0 has no place 'Bse', did you mean Base?"),
        ("robot_0 Base > Dok 7", "robot_0 has no place 'Dok 7', did you mean Dock 7?"),
        ("robot_0 Base", "usage: robot_0 FROM > TO, or robot_0 > TO"),
        ("robot_0 Base >", "missing place beside >: order ROBOT FROM TO, or ROBOT FROM > TO"),
        ("> Base", "missing robot before >: order ROBOT FROM TO, or ROBOT FROM > TO"),
        ("order robot_0", "usage: order ROBOT FROM TO, or ROBOT FROM > TO"),
        ("cancel", "usage: cancel ROBOT ID, or cancel ROBOT goal"),
        ("cancel robot_0 twelve", "'twelve' is not an order id: copy it from the queue"),
        ("cancel 99999999999", "'99999999999' is not an order id: copy it from the queue"),
        ("pause", "usage: pause ROBOT, or pause all"),
    ],
)
def test_what_is_wrong_is_named_with_the_nearest_right_word(line: str, said: str) -> None:
    with pytest.raises(CommandError) as caught:
        parse(line, known(), R0)
    assert str(caught.value) == said


def test_where_a_graph_is_missing_an_unknown_place_says_so() -> None:
    with pytest.raises(CommandError, match=r"has no place 'Receiving': no graph of floor_0: set"):
        parse("robot_0 > Receiving", of_kinds(fleet(), Kind("goals", accepts=(ORDER_TO,))), R0)


def test_another_floor_without_a_graph_is_no_reason() -> None:
    state = reduced(of_kinds(fleet(floors=2), Kind("goals", accepts=(ORDER_TO,))), graph(1, 2), pose(T0))
    assert state.robots[R0].floor == "floor_0"
    with pytest.raises(CommandError) as caught:
        parse("robot_0 > Receiving", state, R0)
    assert str(caught.value) == "robot_0 has no place 'Receiving'"


def test_a_word_that_can_mean_two_vertices_means_none_until_it_is_clear() -> None:
    state = known({1: "Base", 2: "BASE", 3: "7", 4: "Lift", 5: "Lift"})
    assert parse("robot_0 Base > BASE", state).commands == (place_order(R0, 1, 2),)
    for word, ids in (("base", "id=1 or id=2"), ("7", "id=3 or id=7"), ("Lift", "id=4 or id=5")):
        with pytest.raises(CommandError, match=f"is ambiguous for robot_0: use {ids}"):
            parse(f"robot_0 {word} > 9", state)
    assert parse("robot_0 id=7 > id=3", state).commands == (place_order(R0, 7, 3),)


def test_cancel_without_a_robot_needs_a_selected_one() -> None:
    with pytest.raises(CommandError, match="usage: cancel ROBOT ID"):
        parse("cancel 12", known())


def test_words_from_a_shell_need_no_quotes() -> None:
    asked = parse_words(["order", R0, "Lab > base", "Dock 7"], known())
    assert asked.commands == (place_order(R0, 4, 3),)
    assert asked.floors == (("4", "floor_0"), ("3", "floor_0"))


ids = st.integers(min_value=-(2**31), max_value=2**31 - 1).map(str)
vertices = st.one_of(st.integers(1, 12), st.integers(0, 2**31 - 1)).map(str)
robots = st.sampled_from([R0, R1])
commands: st.SearchStrategy[Command] = st.one_of(
    st.builds(place_order, robots, vertices, vertices),
    st.builds(place_order, robots, vertices),
    st.builds(CancelOrder, robots, ids),
    st.builds(ClearOrders, robots),
    st.builds(PauseRobot, robots),
    st.builds(ResumeRobot, robots),
)
hard_words = st.text("ab7=d'\" >-i\n", max_size=6)
odd_words = st.sampled_from(["Base", "base", "ǅ", "ﬀ", "İ", "ß", "\u202e", "٣", "\x1b[2J", "9" * 5000])
any_labels = st.dictionaries(st.integers(1, 9), st.one_of(hard_words, odd_words), max_size=6)


@given(commands, any_labels)
@example(place_order(R0, 7, 1), {1: "7", 2: "id=7"})
@example(place_order(R0, 1, 1), {1: "'"})
@example(place_order(R0, 1, 2), {1: "'a", 2: "a'"})
def test_a_written_command_is_read_back(command: Command, named: dict[int, str]) -> None:
    state = known(named)
    assert parse(written(command, state), state).commands == (command,)


text_ids = st.text('abB7=d- >"', min_size=1, max_size=5).filter(lambda id_: '"' not in id_ or " " not in id_)


@given(
    st.lists(text_ids, min_size=2, max_size=5, unique=True),
    any_labels.map(lambda named: list(named.values())),
)
@example(["dock A", "id=7", "7"], ["7"])
@example(["A", "B"], ["B", "A"])
def test_a_command_with_ids_of_text_is_read_back(ids: list[str], names: list[str]) -> None:
    """Every id that can be written; a label may be the id of another vertex."""
    named = dict(zip(ids, names, strict=False))
    orders = [Order(id_, at_vertices(*ids[:2]), None, "", n) for n, id_ in enumerate(ids)]
    reported = QueueReported(R0, 1000.0, OrderQueue(9, ids[0], tuple(orders)))
    state = reduced(fleet(), graph(*ids), labels(named), reported)
    for command in (place_order(R0, *ids[:2]), place_order(R0, ids[0]), CancelOrder(R0, ids[-1])):
        assert parse(written(command, state), state).commands == (command,)


def test_ids_of_text_are_typed_like_numbers() -> None:
    orders = (Order("3f2a-77", at_vertices("dock A"), OrderState.IN_PROCESS, "2", 1),)
    reported = QueueReported(R0, 1000.0, OrderQueue(1, "3f2a-77", orders))
    state = reduced(fleet(), graph("dock A", "b2", "b10"), labels({"b2": "Store", "b10": "Store"}), reported)
    assert parse("cancel 3f2a-77", state, R0).commands == (CancelOrder(R0, "3f2a-77"),)
    assert parse("robot_0 dock A > b10", state).commands == (place_order(R0, "dock A", "b10"),)
    assert complete("cancel ", state, R0)[0] == "cancel 3f2a-77"
    with pytest.raises(CommandError, match="use id=b2 or id=b10"):
        parse("robot_0 dock A > Store", state)
    with pytest.raises(CommandError, match="'3f2a' is not an order id: copy it from the queue"):
        parse("cancel robot_0 3f2a", state)


def test_a_number_with_zeros_before_it_is_that_number_unless_an_id_is_written_so() -> None:
    assert parse("cancel 012", known(), R0).commands == (CancelOrder(R0, "12"),)
    assert parse("robot_0 01 > 002", known()).commands == (place_order(R0, 1, 2),)
    both = reduced(fleet(), graph("7", "007"))
    assert parse("robot_0 007 > 7", both).commands == (place_order(R0, "007", "7"),)


pieces = [*"'\"> ", "->", R0, "order", "cancel", "pause", "all", "Base", "Dock 7", "9" * 5000]
lines = st.one_of(st.text(), st.lists(st.sampled_from(pieces)).map(" ".join))


@given(lines, any_labels)
def test_no_text_is_more_than_refused(line: str, named: dict[int, str]) -> None:
    state = known(named)
    try:
        assert parse(line, state, R0).commands
    except CommandError as problem:
        assert str(problem)
    complete(line, state, R0)
    is_command(line, state)


def test_a_line_begins_as_a_command_or_is_a_search() -> None:
    state = known()
    assert [
        line
        for line in ("pause", "pause ", "robot_0 B", "zoom in", "1 x", "", " ")
        if is_command(line, state)
    ] == ["pause ", "robot_0 B", "1 x"]


def test_an_order_that_waits_here_is_cancelled_by_its_id() -> None:
    state = of_kinds(fleet(), Kind("goals", keeps_goals=True))
    state = reduced(state, graph(1, 2), *commanded(7, place_order(R0, 1, 2), Stage.WAITING))
    assert parse("cancel robot_0 k1", state).commands == (CancelOrder(R0, "k1"),)
