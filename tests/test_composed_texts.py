"""Texts of several parts in another language: each part is a message, so that none stays English."""

from collections.abc import Iterator

import pytest

from fleet_tui.features.history.events import EventKind, PastEvent
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleets.facility import LIFT, Facility
from fleet_tui.model.order import Order, OrderState, at_vertices
from fleet_tui.model.programs.program import NOT_CONFIRMED, ChangeOutcome
from fleet_tui.situation.alarms.facilities import facility_text
from fleet_tui.situation.batches import summary
from fleet_tui.situation.why.reason import mission
from fleet_tui.text.language import Message, translate
from fleet_tui.ui.languages import ENGLISH, use_language
from tests.support.fleets import T0, commanded, fleet, reduced
from tests.support.planted_console import planted


@pytest.fixture(autouse=True)
def german() -> Iterator[None]:
    use_language("de")
    yield
    use_language(ENGLISH)


def test_the_outcome_of_a_pause_of_all() -> None:
    stages = enumerate((Stage.CONFIRMED, Stage.REFUSED, Stage.ACCEPTED))
    pauses = [
        fact
        for n, stage in stages
        for fact in commanded(n, PauseRobot(f"robot_{n}"), Stage.SENT, stage, detail=Message("no link"))
    ]
    state = reduced(fleet(3), *pauses)
    what, outcome = summary(state, state.commands)
    assert what == "pause all"
    assert outcome == "1 refused (robot_1): no link, 2 open (robot_0, robot_2)"
    assert translate(outcome) == "1 abgelehnt (robot_1): keine Verbindung, 2 offen (robot_0, robot_2)"


def test_the_outcome_of_a_change_of_a_program() -> None:
    outcome = ChangeOutcome(NOT_CONFIRMED, Message("no link"))
    assert translate(outcome.text) == "nicht bestätigt (keine Verbindung)"


def test_an_order_without_a_number() -> None:
    order = Order("a1b2", at_vertices("1", "2"), OrderState.QUEUED, "", 1)
    state = fleet(1)
    assert translate(mission(state.robots["robot_0"], order)) == "Auftrag 1? -> 2?"


def test_a_facility_with_its_state() -> None:
    lift = Facility(LIFT, "north", T0, Message("fire mode"), user="tiny/t1")
    assert translate(facility_text(fleet(1), lift)) == "Aufzug north: Brandbetrieb, benutzt von tiny/t1"


async def test_a_question() -> None:
    async with planted(2) as it:
        it.app.main.features.confirm.ask(lambda: Message("Send?"), lambda: None)
        await it.shows("Senden?")


def test_who_confirmed_a_command_follows_without_brackets() -> None:
    event = PastEvent(
        1.0, None, EventKind.COMMAND, "r", Message("pause"), Message("confirmed"), Message("by the robot")
    )
    assert event.text == "r Pause: bestätigt vom Roboter"
