"""The first-run screen, without a configuration: shows the searched paths and the robots of the local bridge;
opens nothing by itself."""

import asyncio
from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar, Literal

from rich.style import Style
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.worker import Worker

from fleet_tui.links.discovery.address import bridge_at
from fleet_tui.links.discovery.site import WITHIN, DiscoveredSite, start_discovery
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.ui.screens.opening import RowsScreen
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.opening import Asked, Rows, first_run_rows
from fleet_tui.ui.widgets.field import Field

KEYS = (("enter", "open"), ("a", "other address"), ("d", "demo"), ("r", "retry"), ("q", "quit"))
BEGUN = "ws://"
LOCAL = "ws://127.0.0.1:9090"
EVERY = 0.1
"""Seconds between two progress updates."""


class FirstRun(RowsScreen):
    """Queries one address at a time."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("enter", "open", "Open the console"),
        # Before all else: the next key, which may already be in the queue, belongs to the field.
        Binding("a", "address", "Enter another address", priority=True),
        ("d", "demo", "Open a simulated fleet"),
        ("r", "ask", "Retry"),
        ("q,escape", "leave", "Quit"),
    ]

    def __init__(
        self,
        styles: Mapping[StyleRole, Style],
        places: Sequence[tuple[str, str]],
        done: Callable[[DiscoveredSite | Literal["demo"] | None], None],
        address: str = LOCAL,
    ) -> None:
        super().__init__(styles, KEYS)
        self._places = places
        self._done = done
        self._address = address
        self._asked = Asked(address, tr("discovering the fleet"))
        self._site: DiscoveredSite | None = None
        self._asking: Worker[None] | None = None
        self._field = Field({"enter": self._typed, "escape": self._close}, id="address")
        self._field.select_on_focus = False

    def compose(self) -> ComposeResult:
        """Compose the page, the field for an address, and the keys."""
        page, keys = super().compose()
        yield from (page, self._field, keys)

    def on_mount(self) -> None:
        """Query at once: discovery only reads."""
        self._field.display = False
        self.set_interval(EVERY, self.show)
        self.action_ask()

    def rows(self, width: int, height: int) -> Rows:
        """Return the searched paths, and the result at the address. Enter is offered if it does something."""
        self._keys = KEYS if self._site is not None else KEYS[1:]
        return first_run_rows(self._places, self._asked, width, height)

    def action_ask(self) -> None:
        """Query the robots at the address."""
        self._site = None
        if self._asking is not None:
            self._asking.cancel()
        self._asking = self.run_worker(self._ask())

    async def _ask(self) -> None:
        address = self._address
        self._asked = Asked(address, tr("discovering the fleet"))
        try:
            asking = start_discovery(bridge_at(address), WITHIN, self._watch)
            site = await asyncio.wrap_future(asking)
            self._asked = _found(site)
            self._site = site
        except FleetError as problem:
            shown = self._asked.address
            said = str(problem).removeprefix(f"{shown}: ")
            self._asked = Asked(shown, said, is_over=True)

    def _watch(self, done: int, total: int, doing: Message) -> None:
        """Record progress, on the network's thread."""
        count = tr(", {done} of {total}", done=done, total=total) if total else ""
        self._asked = self._asked._replace(
            words=tr("discovering the fleet: {doing}{count}", doing=translate(doing), count=count)
        )

    def action_open(self) -> None:
        """Open the console on the discovered robots."""
        if self._site is not None:
            self._done(self._site)

    def action_demo(self) -> None:
        """Leave for a simulated fleet."""
        self._done("demo")

    def action_leave(self) -> None:
        """Leave without opening a console."""
        self._done(None)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Disable the key in the field: it is a letter there."""
        return action != "address" or self.focused is not self._field

    def action_address(self) -> None:
        """Focus the field for another address."""
        self._field.value = BEGUN
        self._field.cursor_position = len(BEGUN)
        self._field.display = True  # not by a class, which would only take effect later
        self.set_focus(self._field)

    def _close(self) -> None:
        self._field.display = False
        self.set_focus(None)

    def _typed(self) -> None:
        typed = self._field.value.strip()
        rest = typed.removeprefix(BEGUN)
        # A whole address may have been pasted after the preset text of the field.
        self._address = rest if "://" in rest else typed
        self._close()
        self.action_ask()


def _found(site: DiscoveredSite) -> Asked:
    """Return the text of the result. Raises FleetError if no robot was found."""
    names, floors = [robot.name for robot in site.config.robots], [floor.name for floor in site.config.floors]
    more = [_listed(names), _listed(floors), tr("Enter opens the console. No commands are sent before that.")]
    return Asked(site.bridge.shown, site.summary, tuple(more), is_found=True, is_over=True)


def _listed(names: Sequence[str], most: int = 6) -> str:
    more = tr(" and {count} more", count=len(names) - most) if len(names) > most else ""
    return ", ".join(names[:most]) + more
