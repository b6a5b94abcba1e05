"""What the main screen gets after its first paint: the map, and what opens over the panes."""

from typing import TYPE_CHECKING

from fleet_tui.screens.audit import AuditLog
from fleet_tui.screens.confirm import Confirm
from fleet_tui.screens.diagnostics import Diagnostics
from fleet_tui.screens.diagnostics_pages import Pages
from fleet_tui.screens.help import Help
from fleet_tui.screens.menu import Menu
from fleet_tui.screens.order_form import OrderForm
from fleet_tui.screens.palette import Palette
from fleet_tui.screens.typed import typed
from fleet_tui.screens.why import Why
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.widgets.map_view import MapView

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen


async def furnish(screen: "MainScreen", drawing: Drawing) -> None:
    """Put everything in its place; the focus is on the map. The audit log begins before there is a link."""
    screen.map = MapView(id="map")
    screen.map.look = MapOptions(drawing=drawing)
    screen.order_form = OrderForm(lambda: screen.state, screen.give)
    screen.confirm, screen.menu = Confirm(id="confirm"), Menu(id="menu")
    screen.key_help = Help(screen.keys)
    screen.palette = Palette(
        screen.wishes,
        lambda line: (
            screen.as_time(line)
            or screen.as_save(line)
            or typed(line, screen.state, screen.selection.robot, screen.do)
        ),
    )
    screen.why = Why(lambda: (screen.state, screen.selection.robot), screen.keys)
    screen.audit_log = AuditLog(lambda: screen.audit)
    pages = Pages(lambda: screen.state, lambda: screen.backend, screen.clock)
    screen.diagnostics = Diagnostics(pages, lambda: screen.backend, screen.keys)
    opens = (screen.order_form, screen.confirm, screen.menu, screen.key_help, screen.palette, screen.why)
    with screen.app.batch_update():
        await screen.query_one("#map").remove()
        await screen.query_one("#panes").mount(screen.map, before=0)
        await screen.mount(*opens, screen.audit_log, screen.diagnostics)
        await screen.show_time_line()
    screen.set_focus(screen.map)
    screen.open_journal()
