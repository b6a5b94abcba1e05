"""Two operators who command the same robot at once both see who else did."""

import pytest

from fleet_tui.commands.rivals import AT_ONCE, SHOWN_FOR, rivals, rivals_text
from fleet_tui.model.commands import Stage
from fleet_tui.model.desk.desk import Colleague, CommandElsewhere
from fleet_tui.model.desk.events import ColleaguesSeen, CommandedElsewhere
from fleet_tui.model.fleet import FleetState
from fleet_tui.state.desk_events import OTHERS_FOR
from fleet_tui.text.language import EMPTY
from fleet_tui.ui.view.lines.commands import message_line
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import R0, T0, commanded, fleet, link_up, place_order, pose, reduced, text_of, tick

ORDER = place_order(R0, 1, 2)


def by_ben(at: float, robot: str = R0, what: str = "pause") -> CommandedElsewhere:
    return CommandedElsewhere(CommandElsewhere(f"run {at}", robot, "", "ben", "pc:7", at, Stage.SENT, what))


def ordered(stage: Stage = Stage.SENT) -> FleetState:
    return reduced(fleet(), link_up(T0), pose(T0), *commanded(1, ORDER, stage))


def row(state: FleetState) -> str:
    return text_of(news(state, state.robots[R0]))


@pytest.mark.parametrize("at", [T0 - AT_ONCE + 1, T0, T0 + AT_ONCE - 1])
def test_whoever_was_first_both_are_told(at: float) -> None:
    state = reduced(ordered(), by_ben(at), tick(max(T0, at)))
    assert rivals_text(state, R0) == "ben at pc:7: pause"
    assert "also commanded by ben" in row(state)
    line = text_of(message_line(state, EMPTY, T0, 200))
    assert line.endswith(", also commanded by ben at pc:7: pause")


def test_the_newest_command_of_each_other_console_counts() -> None:
    state = reduced(ordered(), by_ben(T0), by_ben(T0 + 1, what="clear"), tick(T0 + 2))
    assert rivals_text(state, R0) == "ben at pc:7: clear"


@pytest.mark.parametrize(
    ("event", "now"),
    [
        (by_ben(T0 - AT_ONCE), T0),  # before, not at once
        (by_ben(T0, "robot_1"), T0),
        (by_ben(T0), T0 + SHOWN_FOR),  # no news any more
    ],
)
def test_else_nobody_is_named(event: CommandedElsewhere, now: float) -> None:
    state = reduced(ordered(), event, tick(now))
    assert rivals(state, R0) == [] and "also" not in row(state)


def test_what_was_not_sent_here_has_no_rival() -> None:
    assert rivals(reduced(ordered(Stage.NOT_SENT), by_ben(T0), tick(T0)), R0) == []
    assert rivals(reduced(fleet(), by_ben(T0), tick(T0)), R0) == []


def test_a_claim_does_not_outlive_its_robot() -> None:
    state = reduced(fleet(), ColleaguesSeen((Colleague("1", "ben", "pc", R0, (R0, "robot_of_yesterday")),)))
    assert [one.claims for one in state.desk.others] == [(R0,)]


def test_commands_of_others_that_remove_no_order_are_soon_forgotten() -> None:
    """They must not push out the cancels that explain the ends of orders."""
    state = reduced(fleet(), tick(T0), by_ben(T0, what="clear"), by_ben(T0 + 1, what="order"))
    state = reduced(state, tick(T0 + OTHERS_FOR + 1), by_ben(T0 + OTHERS_FOR + 1, what="order"))
    kept = [(one.what, one.at - T0) for one in state.desk.elsewhere]
    assert kept == [("clear", 0), ("order", OTHERS_FOR + 1)]
