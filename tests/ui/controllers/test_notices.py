"""The last line: the newest text, and which command was the newest then."""

from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.state.store import Store
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.notices import READ, SHOWN, Notices
from tests.support.fleets import R0, T0, commanded, fleet, reduced, tick


def test_what_is_said_is_shown_at_once_and_what_is_noted_with_the_next_tick() -> None:
    drawn = list[str]()
    notices = Notices(Store(fleet()), lambda: drawn.append(notices.text), Message("welcome"))
    assert notices.text == "welcome"
    notices.say(Message("one"))
    notices.note(Message("two"))
    assert (notices.text, drawn) == ("two", ["one"])


def test_a_text_goes_after_a_while_unless_it_stays() -> None:
    now = [T0]
    notices = Notices(Store(fleet()), lambda: None, Message("welcome"), clock=lambda: now[0])
    now[0] += SHOWN - 0.1
    assert notices.text == "welcome"
    now[0] += 0.2
    assert notices.text == "", "nor does the first one stay"
    notices.say(Message("no order here"))
    now[0] += SHOWN - 0.1
    assert notices.text == "no order here"
    now[0] += 0.2
    assert notices.text == ""
    notices.say(Message("link not opened"), stays=True)
    now[0] += 60
    assert notices.text == "link not opened"
    notices.clear()
    assert notices.text == ""


def test_a_command_that_comes_later_is_newer_than_the_text() -> None:
    store = Store(fleet())
    notices = Notices(store, lambda: None)
    notices.say(Message("one"))
    before = notices.at
    store.put(reduced(fleet(), *commanded(1, PauseRobot(R0), Stage.SENT, at=T0 + 1)))
    notices.say(Message("two"))
    assert notices.at > before


def test_the_time_of_a_key_is_that_of_the_state() -> None:
    store = Store(reduced(fleet(), tick(T0 + 3)))
    notices = Notices(store, lambda: None)
    notices.key_pressed()
    assert notices.key_at == T0 + 3


def test_a_key_ends_a_text_that_was_read_and_no_newer_one_nor_the_first() -> None:
    now = [T0]
    notices = Notices(Store(fleet()), lambda: None, Message("welcome"), clock=lambda: now[0])
    now[0] += READ
    notices.key_pressed()
    assert notices.text == "welcome", "a newcomer reads longer"
    notices.say(Message("no order here"))
    notices.key_pressed()
    assert notices.text == "no order here", "keys follow each other fast"
    now[0] += READ
    notices.key_pressed()
    assert notices.text == ""
    notices.say(Message("link not opened"), stays=True)
    now[0] += READ
    notices.key_pressed()
    assert notices.text == "link not opened"


def test_a_hint_is_given_once_for_its_topic_and_the_next_key_ends_it() -> None:
    notices = Notices(Store(fleet()), lambda: None)
    notices.hint(Message("key 2 is robot_1"), "robot keys")
    assert (notices.text, notices.is_hint) == ("key 2 is robot_1", True)
    notices.key_pressed()
    assert notices.text == ""
    notices.hint(Message("key 3 is robot_2"), "robot keys")
    assert notices.text == ""
    notices.hint(Message("other"), "other")
    notices.say(Message("no order here"))
    assert (notices.text, notices.is_hint) == ("no order here", False)
