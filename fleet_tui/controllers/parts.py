"""The parts of a console that its set-up uses."""

from collections.abc import Callable
from typing import Any, NamedTuple

from fleet_tui.controllers.dispatch import Dispatch
from fleet_tui.controllers.navigation import Navigation
from fleet_tui.controllers.notices import Notices
from fleet_tui.controllers.typed import OpenMenu
from fleet_tui.state.store import Store

InBackground = Callable[[Callable[[], Any], Callable[[Any], None]], None]
"""Does work in a thread, then calls with its result."""


class SetUpParts(NamedTuple):
    """Parts that every controller of set-up uses. `begin` opens the palette with a line."""

    store: Store
    dispatch: Dispatch
    navigation: Navigation
    notices: Notices
    open_menu: OpenMenu
    begin: Callable[[str], None]
