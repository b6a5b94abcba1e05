"""A line of the palette as a command: what Enter does, what is missing, what it can become."""

from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.request import Request
from fleet_tui.ui.controllers.typed import typed
from tests.support.desk import ready
from tests.support.fleets import R0
from tests.support.kinds import MUTE, moved


def test_a_whole_line_does_what_it_says() -> None:
    done = list[Request]()
    line = typed(f"pause {R0}", ready(), R0, done.append)
    ((text, do),) = line.entries
    do()
    assert line.is_command and R0 in text and done == [Request((PauseRobot(R0),))]


def test_what_is_wrong_with_a_line_is_said() -> None:
    line = typed(f"{R0} Base > Nowhere", ready(), R0, lambda _: None)
    assert line.is_command and not line.entries and "Nowhere" in line.problem


def test_what_a_kind_does_not_accept_is_no_entry() -> None:
    line = typed(f"pause {R0}", moved(MUTE), R0, lambda _: None)
    assert not line.entries and "this kind has no pause" in line.problem


def test_a_search_is_no_command() -> None:
    assert not typed("theme", ready(), R0, lambda _: None).is_command
    assert typed("pau", ready(), R0, lambda _: None).completed == ["pause ", "pause all "]
