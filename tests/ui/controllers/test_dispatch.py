"""Every way to the wire: a console that may not, or shows a recording, lets no command of any kind leave."""

import pytest

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.text.language import EMPTY, Message
from tests.support.desk import Desk, ready
from tests.support.fleets import R0, fleet, place_order

ORDER = place_order(R0, 1, 2)
COMMANDS = [PauseRobot(R0), ResumeRobot(R0), ORDER, CancelOrder(R0, "1"), ClearOrders(R0)]
NAMES = [type(command).__name__ for command in COMMANDS]
DISARMED = Permissions(armed=False)


@pytest.mark.parametrize("command", COMMANDS, ids=NAMES)
def test_an_armed_console_sends_it(command: Command) -> None:
    desk = Desk(ready())
    desk.do(command)
    assert desk.backend.submitted == [command]


@pytest.mark.parametrize("command", COMMANDS, ids=NAMES)
def test_a_console_that_is_not_armed_sends_nothing_but_pauses(command: Command) -> None:
    desk = Desk(ready(), DISARMED)
    desk.do(command)
    if isinstance(command, PauseRobot):
        assert desk.backend.submitted == [command]
        return
    assert desk.backend.submitted == []
    assert desk.notices.text.startswith("not sent: this console is not armed")


@pytest.mark.parametrize("command", [ORDER, ResumeRobot(R0), CancelOrder(R0, "1"), ClearOrders(R0)])
def test_a_read_only_console_sends_nothing(command: Command) -> None:
    """Of a pause the link itself says why: its end is in the log."""
    desk = Desk(ready(), Permissions(read_only=True))
    desk.do(command)
    assert desk.backend.submitted == []
    assert desk.notices.text == "not sent: this console is read-only"


@pytest.mark.parametrize("command", COMMANDS, ids=NAMES)
def test_a_recording_takes_nothing(command: Command) -> None:
    desk = Desk(ready(), refusal=Message("not sent: this is a recording"))
    desk.do(command)
    assert desk.backend.submitted == []
    assert desk.notices.text == "not sent: this is a recording"


def test_disarmed_while_it_is_asked_nothing_leaves() -> None:
    desk = Desk(ready())
    desk.dispatch.do(Request((ClearOrders(R0),)))
    desk.dispatch.permissions = DISARMED
    for yes in desk.answers:
        yes()
    assert desk.answers and desk.backend.submitted == []


@pytest.mark.parametrize("command", COMMANDS[:3], ids=NAMES[:3])
def test_disarmed_while_it_waits_for_the_link_nothing_but_a_pause_leaves(command: Command) -> None:
    desk = Desk(fleet(1))
    desk.do(command)
    assert desk.notices.text == "waiting for the link"
    desk.dispatch.permissions = DISARMED
    desk.store.put(ready())
    desk.dispatch.release_startup()
    if isinstance(command, PauseRobot):
        assert desk.backend.submitted == [command]
        return
    assert desk.backend.submitted == []
    assert "not armed" in desk.notices.text


def test_what_waited_leaves_when_the_link_is_there() -> None:
    desk = Desk(fleet(1))
    desk.do(PauseRobot(R0))
    desk.store.put(ready())
    desk.dispatch.release_startup()
    assert desk.backend.submitted == [PauseRobot(R0)]


def test_a_request_is_prepared_after_the_question_and_not_sent_if_that_fails() -> None:
    desk, done = Desk(ready()), list[str]()

    def prepare() -> Message:
        done.append("prepared")
        return Message("not sent: disk full") if len(done) == 1 else EMPTY

    desk.dispatch.do(Request((ClearOrders(R0),)), prepare=prepare)
    assert desk.answers and not done
    desk.say_yes()
    assert (desk.notices.text, desk.backend.submitted) == ("not sent: disk full", [])
    desk.say_yes()
    assert len(done) == 2 and desk.backend.submitted == [ClearOrders(R0)]
    desk.dispatch.permissions = DISARMED
    desk.say_yes()
    assert len(done) == 2


def test_a_request_that_needs_preparing_does_not_wait_for_the_link() -> None:
    desk = Desk(fleet())
    desk.dispatch.do(Request((ClearOrders(R0),)), prepare=lambda: EMPTY)
    assert desk.notices.text.startswith("not sent: ") and not desk.answers


def test_what_nobody_can_be_asked_about_is_sent_only_without_objections() -> None:
    desk = Desk(ready())
    assert desk.dispatch.give_unasked(Request((ORDER,))) == [] and desk.backend.submitted == [ORDER]
    (problem,) = desk.dispatch.give_unasked(Request((place_order(R0, 1, 1),)))
    assert problem.text.startswith("From and To are the same place")
    desk.dispatch.permissions = DISARMED
    assert desk.dispatch.give_unasked(Request((ORDER,)))[0].check == "not armed"
    assert (
        Desk(ready(), refusal=Message("a recording")).dispatch.give_unasked(Request((ORDER,)))[0].text
        == "a recording"
    )
    assert desk.backend.submitted == [ORDER] and desk.answers == []
