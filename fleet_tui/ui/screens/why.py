"""Reasons why the selected robot stands still, live, with the keys that help."""

from collections.abc import Callable, Mapping
from functools import partial
from textwrap import wrap
from time import monotonic
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.widgets import Static

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.trouble import needs_a_look
from fleet_tui.situation.links import is_late
from fleet_tui.situation.why.complaints import Complaint, complaints
from fleet_tui.situation.why.load import busiest
from fleet_tui.situation.why.reason import Reason
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.controllers.streams import ShownStreams
from fleet_tui.ui.screens.robot.overlay import RobotOverlay, robot_bindings
from fleet_tui.ui.view.lines.impact import why_impact
from fleet_tui.ui.view.lines.why import UNBROKEN, why_lines
from fleet_tui.ui.widgets.background import run_in_background

MOST_CUTS = 2
IMPACT_EVERY = 1.0
"""Seconds after which the ways of all orders are searched again."""
SCROLLING = (
    Binding("down,j", "scroll_down", show=False),
    Binding("up,k", "scroll_up", show=False),
    Binding("pagedown", "page_down", show=False),
    Binding("pageup", "page_up", show=False),
    Binding("home", "scroll_home", show=False),
    Binding("end", "scroll_end", show=False),
)
"""Keys that reach the reasons which a small screen has no lines for."""


def _wrapped(lines: list[str], width: int) -> list[str]:
    """Return the lines in pieces of at most `width` cells, each as far in as its line; 0: no layout yet."""
    if width < 1:
        return lines
    indents = (" " * (len(line) - len(line.lstrip(" ▶▲"))) for line in lines)
    return [
        piece.replace(UNBROKEN, " ")
        for line, indent in zip(lines, indents, strict=True)
        for piece in wrap(line, width, subsequent_indent=indent, break_on_hyphens=False) or [""]
    ]


class Why(RobotOverlay):
    """The suggested keys work in here as they do outside."""

    KEY, EVERY = "why", 0.1  # as in the panes
    BINDINGS: ClassVar[list[BindingType]] = [*robot_bindings("why"), *SCROLLING]

    def __init__(
        self,
        looked_at: Callable[[], tuple[FleetState, str]],
        keys: Mapping[str, tuple[str, ...]],
        streams: ShownStreams,
        backend: Backend,
    ) -> None:
        """`streams` watch the robot's scan while it is open: that it does not fit the map is a reason."""
        super().__init__(id="why")
        self._looked_at = looked_at
        self._keys = keys
        self._match = streams.match
        streams.explains = lambda: self.is_open
        self._backend = backend
        self._shown: list[str] = []
        self._cuts: tuple[object, int] = (None, 0)
        """For a robot in a size, the steps by which the text is shorter: none is taken back."""
        self._cut: tuple[str, list[str]] = ("", [])
        """A robot, and the lines on the orders whose ways are cut."""
        self._searched = ("", 0.0)
        self._is_searching = False
        self.cause: Reason | None = None
        """The first reason, while one goes on from here to another screen."""

    def compose(self) -> ComposeResult:
        """Compose only text."""
        yield Static(id="reasons", markup=False)

    def show(self) -> None:
        """Open on the selected robot."""
        self._shown = []
        self._searched = ("", 0.0)
        self.look()
        self.begin()

    def look(self) -> None:
        """Show the current reasons."""
        state, name = self._looked_at()
        self.border_title = Content(tr("Why: {name}", name=sanitize(name)))
        text, robot = self.query_one("#reasons", Static), state.robots[name]
        self._search_ways(state, robot)
        cut = self._cut[1] if self._cut[0] == name else []
        said, load = self._complaints(state, robot), self._load(state, robot)
        tell = partial(why_lines, state, robot, self._keys, self._match(), cut, said, load)
        lines = self._fitted(name, tell)
        if lines != self._shown:
            self._shown = lines
            text.update("\n".join(lines))
        self._show_position(len(lines))

    def _fitted(self, name: str, tell: Callable[[bool], list[str]]) -> list[str]:
        """Return the lines, wrapped: without blank ones, and then briefly, if they don't all fit."""
        has_size = self.styles.height is not None and not self.styles.height.is_auto
        lines, width = (self.size.height if has_size else 0), self.query_one("#reasons").size.width
        of, taken = self._cuts
        first = taken if of == (name, self.size) else 0
        for cuts in range(first, MOST_CUTS + 1):
            is_brief = cuts == MOST_CUTS
            found = _wrapped([line for line in tell(is_brief) if line or not cuts], width)
            if not lines or len(found) <= lines:
                break
        self._cuts = (name, self.size), cuts
        return found

    def _show_position(self, lines: int) -> None:
        """Show which of its lines are visible, if some are not."""
        top, height = round(self.scroll_y), self.size.height
        last = min(lines, top + height)
        is_whole = not height or lines <= height
        position = (
            ""
            if is_whole
            else tr("{first}-{last} of {lines}, PgUp PgDn", first=top + 1, last=last, lines=lines)
        )
        if position != self.border_subtitle:
            self.border_subtitle = position

    def _complaints(self, state: FleetState, robot: Robot) -> list[Complaint]:
        return complaints(state, robot, self._backend.counters.get(robot.link))

    def _load(self, state: FleetState, robot: Robot) -> Reason | None:
        counter = self._backend.counters.get(robot.link)
        if counter is None or not is_late(state.links[robot.link]):
            return None
        return busiest(counter, state.now)

    async def action_help_it(self, id_: str) -> None:
        """Run the key's usual action, about the first reason."""
        self.cause = self.first_reason()
        await super().action_help_it(id_)
        self.cause = None

    def first_reason(self, in_need: bool = False) -> Reason | None:
        """Return the first reason; `in_need`: only of a robot with an alarm or an amber row, else None."""
        state, name = self._looked_at()
        if in_need and not needs_a_look(state, name):
            return None
        robot = state.robots[name]
        return reasons(state, robot, self._match(), self._complaints(state, robot))[0]

    def _search_ways(self, state: FleetState, robot: Robot) -> None:
        """Search the ways of all orders again, if it is time: not on the loop, they may be many."""
        name, at = self._searched
        if self._is_searching or (name == robot.name and monotonic() - at < IMPACT_EVERY):
            return
        self._searched = (robot.name, monotonic())
        self._is_searching = True

        def got(lines: list[str]) -> None:
            self._cut = (robot.name, lines)
            self._is_searching = False

        run_in_background(self, lambda: why_impact(state, robot), got)
