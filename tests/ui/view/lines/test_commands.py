"""The line that says where commands stand: what went wrong first, and each word only while it is true."""

import pytest

from fleet_tui.model import events
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.lines.commands import command_text, message_line
from fleet_tui.ui.view.roles import StyleRole
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    place_order,
    reduced,
    text_of,
    tick,
)
from tests.support.kinds import BARE, FULL, received

WIDE = 300

COMMANDS: list[tuple[Command, str]] = [
    (place_order(R0, 1, 2), "robot_0 order Base -> 2"),
    (place_order(R0, 1, 77), "robot_0 order Base -> 77?"),
    (place_order(R0, 1), "robot_0 bring cargo -> Base"),
    (CancelOrder(R0, "7"), "robot_0 cancel order 7"),
    (ClearOrders(R0), "robot_0 clear all orders"),
    (PauseRobot(R0), "robot_0 pause"),
    (ResumeRobot(R0), "robot_0 resume"),
]


@pytest.mark.parametrize(("command", "text"), COMMANDS, ids=[text for _, text in COMMANDS])
def test_commands_in_the_operators_words(command: Command, text: str) -> None:
    assert command_text(reduced(fleet(), graph(1, 2), labels({1: "Base"})), command) == text


@pytest.mark.parametrize(
    ("stages", "detail", "said", "role"),
    [
        ([], "", ": sending", StyleRole.DIM),
        ([Stage.SENT], "", ": sent 3 s ago", StyleRole.DIM),
        ([Stage.SENT, Stage.ACCEPTED], "paused", ": accepted 3 s ago", StyleRole.GOOD),
        ([Stage.SENT, Stage.REFUSED], "REJECTED: no", ": refused (REJECTED: no)", StyleRole.ALARM),
        ([Stage.SENT, Stage.NO_ANSWER], "within 5 s", ": no answer (within 5 s)", StyleRole.ALARM),
        ([Stage.SENT, Stage.UNKNOWN], "link lost", ": outcome unknown (link lost)", StyleRole.ALARM),
        ([Stage.NOT_SENT], "", ": not sent", StyleRole.ALARM),
    ],
)
def test_where_a_command_stands(stages: list[Stage], detail: str, said: str, role: StyleRole) -> None:
    order = place_order(R0, 1, 2)
    state = reduced(fleet(), *commanded(1, order, *stages, detail=detail), tick(T0 + 3))
    runs = message_line(state, EMPTY, 0.0, WIDE)
    assert text_of(runs) == f" robot_0 order 1? -> 2?{said}"
    assert {found for text, found in runs if text.startswith(said.partition(" (")[0])} == {role}


def pause(id_: int, at: float, *stages: Stage, robot: str = R0, detail: str = "") -> list[events.Event]:
    return [*commanded(id_, PauseRobot(robot), *stages, at=at, detail=detail)]


def test_the_newest_word_is_shown_and_commands_given_together_stand_together() -> None:
    assert message_line(fleet(), EMPTY, 0.0, WIDE) == ()
    assert text_of(message_line(fleet(), Message("no order here"), T0, WIDE)) == " no order here"
    assert message_line(fleet(), Message("no order here"), T0, WIDE)[1][1] is StyleRole.WARN
    assert message_line(fleet(), Message("a hint"), T0, WIDE, is_hint=True)[1][1] is StyleRole.DIM
    together = [pause(2 + n, T0 + 10, Stage.NOT_SENT, robot=f"robot_{n}") for n in range(2)]
    bad = pause(4, T0 + 10, Stage.SENT, Stage.REFUSED, robot="robot_2", detail="no")
    state = reduced(fleet(3), *together[0], *together[1], *bad, tick(T0 + 10))
    text = text_of(message_line(state, Message("older"), T0 + 9, WIDE))
    assert text == " pause all: 1 refused (robot_2): no, 2 not sent (robot_0, robot_1)"
    assert text.index("robot_2") < text.index("robot_0")  # what went wrong must not be cut off
    # A command that ended badly stays in view, whatever is said or given after it.
    newer = text_of(message_line(reduced(state, *pause(9, T0 + 12)), Message("newer"), T0 + 11, WIDE))
    assert "1 refused (robot_2): no" in newer and "newer" not in newer
    later = reduced(state, *pause(9, T0 + 12), tick(T0 + 41))
    assert "refused" not in text_of(message_line(later, EMPTY, 0.0, WIDE))


@pytest.mark.parametrize(
    ("stage", "shown_for"),
    [(Stage.CONFIRMED, 10), (Stage.UNVERIFIABLE, 10), (Stage.REFUSED, 30), (Stage.ACCEPTED, 3600)],
)
def test_an_outcome_goes_once_it_was_in_view_and_an_open_command_stays(stage: Stage, shown_for: int) -> None:
    before = [Stage.SENT] if stage in (Stage.REFUSED, Stage.ACCEPTED) else [Stage.SENT, Stage.ACCEPTED]
    given = reduced(fleet(), *pause(1, T0, *before, stage))
    assert "robot_0 pause" in text_of(
        message_line(reduced(given, tick(T0 + shown_for - 1)), EMPTY, 0.0, WIDE)
    )
    later = reduced(given, tick(T0 + shown_for + 1))
    assert ("robot_0 pause" in text_of(message_line(later, EMPTY, 0.0, WIDE))) == (stage is Stage.ACCEPTED)


def test_a_success_goes_as_soon_as_something_newer_is_said() -> None:
    state = reduced(fleet(), *pause(1, T0, Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED), tick(T0 + 2))
    assert text_of(message_line(state, Message("no vertex here"), T0 + 2, WIDE)) == " no vertex here"
    assert text_of(message_line(state, EMPTY, T0 + 2, WIDE)) == "", "it does not come back"
    bad = reduced(fleet(), *pause(1, T0, Stage.SENT, Stage.REFUSED), tick(T0 + 2))
    assert "refused" in text_of(message_line(bad, Message("no vertex here"), T0 + 2, WIDE))


def test_a_failure_goes_with_the_first_key_after_it_was_read() -> None:
    bad = reduced(fleet(), *pause(1, T0, Stage.SENT, Stage.REFUSED), tick(T0 + 5))
    for key_at, is_shown in ((T0 + 0.5, True), (T0 + 3, False)):
        assert ("refused" in text_of(message_line(bad, EMPTY, 0.0, WIDE, key_at))) is is_shown


def test_pause_all_of_a_large_fleet_is_one_word() -> None:
    facts = [
        fact for n in range(9) for fact in pause(n, T0, Stage.NOT_SENT, robot=f"robot_{n}", detail="no link")
    ]
    text = text_of(message_line(reduced(fleet(9), *facts), EMPTY, 0.0, WIDE))
    assert text == " pause all: 9 not sent (robot_0, robot_1, robot_2, …): no link"


@pytest.mark.parametrize("width", [120, 80])
@pytest.mark.parametrize("said", ["", "robot_1 has no orders"])
def test_how_each_command_stands_is_never_cut(width: int, said: Message) -> None:
    names = {1: "Base of the northern hall", 2: "Consumidores at the far end"}
    facts = [
        *commanded(1, place_order(R0, 1, 2), Stage.SENT, Stage.NO_ANSWER, detail="from a service " * 9),
        *commanded(2, place_order("robot_1", 1, 2), Stage.SENT, Stage.REFUSED, detail="no " * 40),
    ]
    state = reduced(fleet(3), graph(1, 2), labels(names), *facts, tick(T0 + 1))
    text = text_of(message_line(state, said, T0 + 1, width))
    assert cell_width(text) <= width
    assert "no answer" in text and "refused" in text and said in text


def test_what_went_wrong_stays_where_there_is_no_room_for_all() -> None:
    facts = [fact for n in range(6) for fact in pause(n, T0, Stage.SENT, robot=f"robot_{n % 3}")]
    facts += commanded(8, ClearOrders("robot_1"), Stage.SENT, Stage.REFUSED, detail="no " * 40)
    facts += commanded(9, CancelOrder("robot_2", "3"), Stage.SENT, Stage.ACCEPTED)
    text = text_of(message_line(reduced(fleet(3), *facts, tick(T0 + 1)), EMPTY, 0.0, 60))
    assert text.startswith(" robot_1 clear all orders: refused") and cell_width(text) <= 60


def test_an_order_to_one_place_is_said_as_the_kind_takes_it() -> None:
    assert command_text(received(BARE), place_order(R0, 1)) == "robot_0 go to Base"
    assert command_text(received(FULL), place_order(R0, 1)) == "robot_0 bring cargo -> Base"
    assert place_order(R0, 1).what(BARE) == "order"


def test_the_return_of_a_link_is_said_for_a_while_with_its_outage() -> None:
    lost = reduced(fleet(), link_up(T0), link_lost(T0 + 5))
    back = reduced(lost, link_up(T0 + 27), tick(T0 + 28))
    assert text_of(message_line(back, EMPTY, 0.0, WIDE)).strip() == "link restored after 22 s"
    assert "link restored" in text_of(message_line(back, Message("saved"), T0 + 28, WIDE))
    assert message_line(reduced(back, tick(T0 + 60)), EMPTY, 0.0, WIDE) == ()
    brief = reduced(lost, link_up(T0 + 6), tick(T0 + 7))
    assert message_line(brief, EMPTY, 0.0, WIDE) == (), "too short for an alarm"
    assert message_line(reduced(fleet(), link_up(T0), tick(T0)), EMPTY, 0.0, WIDE) == ()
