"""A text field whose keys keep their order, however fast they arrive."""

from collections.abc import Callable, Mapping

from textual import events
from textual.geometry import Size
from textual.reactive import Reactive
from textual.widgets import Input

from fleet_tui.text.sanitize import sanitize
from fleet_tui.transports.loop import end_turn, give_turn

Keys = Mapping[str, Callable[[], object]]


class Field(Input):
    """Runs the callback `on` for a key at once, not by a message that the next key would overtake.

    Keys already in the queue when the focus moved are forwarded to its new place: a whole order pasted in one
    packet fills the form as if it were typed.
    """

    # A letter moves no other widget; Textual would lay out and paint the whole screen for each.
    virtual_size = Reactive(Size(0, 0), layout=False)

    def __init__(self, on: Keys, *, id: str, placeholder: str = "") -> None:
        super().__init__(id=id, placeholder=placeholder, compact=True, select_on_focus=True)
        self._on = on

    def on_paste(self, event: events.Paste) -> None:
        """Insert pasted text, sanitized: it may come from a robot."""
        event.text = "\n".join(map(sanitize, event.text.splitlines()))

    async def on_key(self, event: events.Key) -> None:
        """Run a bound key, forward a late key to the focused widget, or insert it as text."""
        focused = self.screen.focused
        action = self._on.get(event.key)
        if focused is self and action is None:
            give_turn()
            for editing in self._bindings.key_to_bindings.get(event.key, ()):
                # Textual runs it once the key has bubbled up: after the letters that follow it.
                event.stop()
                event.prevent_default()
                await self.app.run_action(editing.action, self)
            return
        end_turn()  # a command may follow, which the loop sends
        event.stop()
        event.prevent_default()
        if focused is self and action is not None:
            action()
        elif focused is not None:
            focused.post_message(events.Key(event.key, event.character))
