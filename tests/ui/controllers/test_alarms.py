"""Responses to alarms: acknowledged, shelved, gone to."""

import math
import time
from collections.abc import Callable

from fleet_tui.model.desk.events import AlarmAcknowledged, AlarmShelved
from fleet_tui.model.events import GraphReceived
from fleet_tui.model.graph import Role, RouteGraph, Vertex
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.alarms import AlarmResponses
from fleet_tui.ui.widgets.rows_pane import RowsPane
from tests.support.desk import Desk
from tests.support.fleets import F0, T0, battery, fleet, link_up, pose, reduced, tick

LOW = [("robot_0", "battery"), ("robot_1", "battery")]


def responses(cleared_at: Callable[[], float] = lambda: -math.inf) -> tuple[Desk, RowsPane, AlarmResponses]:
    """Two robots whose batteries are low, and the pane with their alarms."""
    low = (battery(T0, 5.0, robot=f"robot_{n}") for n in range(2))
    upstairs = pose(T0, robot="robot_1", frame=F0.replace("0", "1"))
    desk, pane = Desk(reduced(fleet(2, 2), link_up(T0 - 9), *low, upstairs, tick(T0))), RowsPane(id="alarms")
    return (
        desk,
        pane,
        AlarmResponses(
            desk.console(),
            pane=pane,
            why=lambda: desk.notices.say(Message("why")),
            robot_menu=lambda robot: desk.notices.say(Message("menu of {robot}", robot=robot)),
            charge=lambda robot: desk.notices.say(Message("{robot} to a charger", robot=robot)),
            cleared_at=cleared_at,
        ),
    )


def test_the_cursor_goes_to_the_next_alarm_that_nobody_has_seen() -> None:
    desk, pane, alarms = responses()
    alarms.acknowledge()
    assert desk.backend.events == []
    pane.listing.cursor = LOW[0]
    alarms.acknowledge()
    assert desk.backend.events == [AlarmAcknowledged(*LOW[0])]
    assert pane.listing.cursor == LOW[1]


def test_an_alarm_that_has_just_taken_the_place_of_another_is_not_acknowledged_unseen() -> None:
    desk, pane, alarms = responses(time.monotonic)
    pane.listing.cursor = LOW[0]
    alarms.acknowledge()
    assert desk.backend.events == []
    assert desk.notices.text == "another alarm has just been marked: press again for that one"


def test_a_low_battery_offers_the_nearest_charger() -> None:
    desk, _, alarms = responses()
    places = {"1": Vertex("1", 5.0, 0.0, Role.DOCKING), "2": Vertex("2", 0.0, 0.0)}
    facts = GraphReceived("robot_0", F0, RouteGraph(places)), pose(T0)
    desk.store.state = reduced(desk.store.state, *facts)
    alarms.menu(*LOW[0])
    (menu,) = desk.menus
    menu.choose("Order robot_0 to 1")
    assert desk.notices.text == "robot_0 to a charger"


def test_all_at_once() -> None:
    desk, _, alarms = responses()
    alarms.acknowledge_all()
    assert desk.backend.events == [AlarmAcknowledged()]


def test_the_menu_goes_to_the_robot_and_puts_the_alarm_on_the_shelf() -> None:
    desk, _, alarms = responses()
    alarms.menu(*LOW[1])
    (menu,) = desk.menus
    assert menu.title.splitlines()[1:] == [
        CLASSES["battery"].action,
        "first seen 12:00:00, last seen 12:00:00, x1",
    ]
    command = "Command robot_1: pause, order, clear"
    whole = ["Explain robot_1", "Show robot_1 on the map", "Shelve for 30 min", command, "Acknowledge (a)"]
    assert menu.texts == whole
    assert desk.navigation.robot == "robot_1"  # all that is shown is about one robot
    menu.choose("Explain")
    assert desk.notices.text == "why"
    menu.choose("Show")
    menu.choose("Shelve")
    assert desk.navigation.robot == "robot_1"
    assert desk.backend.events == [AlarmShelved(*LOW[1], T0 + 1800.0)]


def test_an_explanation_is_of_the_marked_alarms_robot() -> None:
    desk, pane, alarms = responses()
    pane.listing.cursor = LOW[1]
    alarms.explain()
    assert (desk.navigation.robot, desk.notices.text) == ("robot_1", "why")


def test_an_alarm_that_is_over_has_no_menu() -> None:
    desk, _, alarms = responses()
    alarms.menu("robot_1", "obstacle")
    assert desk.menus == [] and desk.notices.text == "the alarm of robot_1 has cleared"
