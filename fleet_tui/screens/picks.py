"""The effects of clicks and selections on the screen."""

from typing import TYPE_CHECKING, assert_never

from fleet_tui.view.tables.groups import GroupHead
from fleet_tui.widgets import messages
from fleet_tui.widgets.bindings import textual_key

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen
    from fleet_tui.screens.rest import Rest


def picked(screen: "MainScreen", event: messages.Picked) -> None:
    """Run the action for a click or selection on the map, a row or its button, or the time line."""
    rest, navigation = screen.rest, screen.navigation
    match event:
        case messages.RobotPicked():
            navigation.select(event.name)
        case messages.VertexPicked():
            rest.orders.start_at(event.id, navigation.floor)
        case messages.FloorPicked():
            navigation.find_floor(event.name)
        case messages.PlacePicked():
            # A pose or goal is where the mouse was; only a draft does something with it.
            rest.drawing.clicked(event.dragged)
        case messages.RowPicked():
            # The fleet's cursor selects. It may have moved since.
            is_there = event.pane == "fleet" and event.key == screen.fleet.listing.cursor
            if is_there and not isinstance(event.key, GroupHead):
                navigation.select(str(event.key))
        case messages.RowChosen():
            _open_menu(rest, event)
        case messages.ButtonPressed():
            _press_button(screen, event)
        case messages.TimePicked():
            screen.session.pick_time(event.x, event.width)
        case _:
            assert_never(event)


def _open_menu(rest: "Rest", event: messages.RowChosen) -> None:
    match event.pane, event.key:
        case "fleet", GroupHead() as head:
            rest.tables.fold(head)
        case "fleet", str(robot):
            rest.robots.menu(robot)
        case "queue", (str(robot), str(order_id), _):
            rest.orders.menu(robot, order_id)
        case "alarms", (str(source), str(kind)):
            rest.alarms.menu(source, kind)


def _press_button(screen: "MainScreen", event: messages.ButtonPressed) -> None:
    match event.pane, event.name, event.key:
        case "hints", id_, _:
            _press_hint(screen, id_)
        case _, "cancel", (str(robot), str(order_id), _):
            screen.rest.orders.ask_cancel(robot, order_id)
        case _, "clear", _:
            screen.rest.orders.clear()


def _press_hint(screen: "MainScreen", id_: str) -> None:
    """Press the key of a hint: with the same checks, and with the same effect in an overlay."""
    key = textual_key(screen.settings.keys[id_][0])
    # Not from here: Textual ends the way of an event at its sender.
    screen.app.call_later(screen.app.simulate_key, key)
