"""Reasons why the selected robot stands still, live, with the keys that help."""

from collections.abc import Callable, Mapping
from textwrap import wrap
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.timer import Timer
from textual.widgets import Static

from fleet_tui.keys import BY_ID, Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.rules.localisation.match import Match
from fleet_tui.screens.overlay import Overlay
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.lines.why import why_lines
from fleet_tui.widgets.bindings import action_of, bindings

EVERY = 0.1  # seconds between two updates, as in the panes


def _wrapped(lines: list[str], width: int) -> list[str]:
    """Return the lines in pieces of at most `width` cells, each as far in as its line; 0: no layout yet."""
    if width < 1:
        return lines
    indents = (" " * (len(line) - len(line.lstrip(" ▶▲"))) for line in lines)
    return [
        piece
        for line, indent in zip(lines, indents, strict=True)
        for piece in wrap(line, width, subsequent_indent=indent) or [""]
    ]


class Why(Overlay, can_focus=True):
    """The suggested keys work in here as they do outside."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *(
            Binding(binding.key, f"help_it('{binding.id}')", show=False, id=binding.id)
            for binding in bindings(Pane.CONSOLE)
            if isinstance(binding, Binding) and binding.id and BY_ID[binding.id].helps
        ),
        *(
            Binding(binding.key, "close", show=False, id=binding.id)
            for binding in bindings(Pane.CONSOLE)
            if isinstance(binding, Binding) and binding.id in ("why", "back", "quit")
        ),
    ]

    def __init__(
        self,
        looked_at: Callable[[], tuple[FleetState, str]],
        keys: Mapping[str, tuple[str, ...]],
        match: Callable[[], Match | None],
    ) -> None:
        """`match` returns that of the robot's shown scan with the map."""
        super().__init__(id="why")
        self._looked_at, self._keys, self._match = looked_at, keys, match
        self._shown: list[str] = []
        self._timer: Timer | None = None

    def compose(self) -> ComposeResult:
        """Compose only text."""
        yield Static(id="reasons", markup=False)

    def show(self) -> None:
        """Open on the selected robot."""
        self._shown = []
        self.look()
        self.open(self)
        if self._timer is None:
            self._timer = self.set_interval(EVERY, self._tick)

    def _tick(self) -> None:
        if self.is_open:
            self.look()
        elif self._timer is not None:
            self._timer.stop()
            self._timer = None

    def look(self) -> None:
        """Show the current reasons."""
        state, name = self._looked_at()
        self.border_title = Content(f"Stop reasons: {sanitize(name)}")
        text = self.query_one("#reasons", Static)
        lines = _wrapped(why_lines(state, state.robots[name], self._keys, self._match()), text.size.width)
        if lines != self._shown:
            self._shown = lines
            text.update("\n".join(lines))

    async def action_help_it(self, id_: str) -> None:
        """Run the key's usual action."""
        if BY_ID[id_].helps == "leaves":
            self.action_close()
        await self.screen.run_action(action_of(BY_ID[id_]))
        self.look()
