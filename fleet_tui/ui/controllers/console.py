"""What every part of a running console works with."""

from collections.abc import Callable
from typing import Any

from msgspec import Struct

from fleet_tui.state.store import Store
from fleet_tui.text.language import Message
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.controllers.dispatch import Ask, Dispatch
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.controllers.navigation import Navigation
from fleet_tui.ui.controllers.notices import Notices
from fleet_tui.ui.controllers.settings import ConsoleSettings
from fleet_tui.ui.controllers.typed import OpenMenu

InBackground = Callable[[Callable[[], Any], Callable[[Any], None]], None]
"""Does work in a thread, then calls with its result."""


class Console(Struct, frozen=True):
    """`begin` opens the palette with a line; `say_from_thread` shows a notice from any thread."""

    store: Store
    backend: Backend
    dispatch: Dispatch
    notices: Notices
    navigation: Navigation
    files: ConsoleFiles
    settings: ConsoleSettings
    ask: Ask
    open_menu: OpenMenu
    begin: Callable[[str], None]
    in_background: InBackground
    say_from_thread: Callable[[Message], None]
