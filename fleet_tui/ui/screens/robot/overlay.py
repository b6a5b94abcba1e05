"""Overlays about the selected robot: live, and the keys that are about it work in there."""

from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.timer import Timer

from fleet_tui.keys import BY_ID, Pane
from fleet_tui.ui.screens.overlay import Overlay
from fleet_tui.ui.widgets.bindings import action_of, bindings, overlay_bindings


def robot_bindings(own: str) -> list[BindingType]:
    """Return the bindings of the keys that help here, and of those that close it: its own by id, and the
    usual ones."""
    closing, everywhere = (own, "back", "quit"), overlay_bindings(own)
    others = {*closing, *(one.id for one in everywhere if isinstance(one, Binding))}
    of_console = [one for one in bindings(Pane.CONSOLE) if isinstance(one, Binding) and one.id]
    helping = [one for one in of_console if one.id not in others and BY_ID[one.id or ""].helps]
    return [
        *(Binding(one.key, f"help_it('{one.id}')", show=False, id=one.id) for one in helping),
        *(Binding(one.key, "close", show=False, id=one.id) for one in of_console if one.id in closing[1:]),
        *everywhere,
    ]


class RobotOverlay(Overlay, can_focus=True):
    """Shows the newest state while it is open."""

    KEY: ClassVar[str]
    """The id of its own key."""
    EVERY: ClassVar[float]
    """Seconds between two updates."""
    _timer: Timer | None = None

    def look(self) -> None:
        """Show the newest state."""
        raise NotImplementedError

    def begin(self) -> None:
        """Open, and keep it live."""
        self.open(self)
        if self._timer is None:
            self._timer = self.set_interval(self.EVERY, self._tick)

    def _tick(self) -> None:
        if self.is_open:
            self.look()
        elif self._timer is not None:
            self._timer.stop()
            self._timer = None

    async def action_help_it(self, id_: str) -> None:
        """Run the key's usual action."""
        if BY_ID[id_].helps == "leaves":
            self.action_close()
        await self.screen.run_action(action_of(BY_ID[id_]))
        self.look()
