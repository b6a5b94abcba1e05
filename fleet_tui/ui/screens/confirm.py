"""Asks once before something is lost or sent against a warning. Only `y` confirms; `C`, where it is offered,
charges the robot instead."""

from collections.abc import Callable
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Horizontal
from textual.content import Content
from textual.widgets import Button, Static

from fleet_tui.text.language import Message, tr, translate
from fleet_tui.ui.screens.overlay import Dialog, MouseButton

ASK_AGAIN_EVERY = 0.5


class Confirm(Dialog, can_focus=True):
    """A question with the losses; the default is No. Its text is kept up to date while it is open."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("y", "confirm", "Confirm"),
        ("C", "charge", "Charge first"),
        ("n,escape,enter", "close", "Cancel"),
    ]

    def compose(self) -> ComposeResult:
        """Compose the question above its two answers."""
        self.border_title = Content(tr("Question"))
        yield Static(id="question", markup=False)
        with Horizontal():
            yield MouseButton(tr("y  Yes"), id="yes", compact=True)
            yield MouseButton(tr("C  Charge first"), id="charge", compact=True)
            yield MouseButton(tr("n  No (Enter)"), id="no", compact=True)

    def on_mount(self) -> None:
        """Update the question while it is open."""
        self._timer = self.set_interval(ASK_AGAIN_EVERY, self._put, pause=True)

    def ask(
        self,
        question: Callable[[], Message],
        then: Callable[[], None],
        charge: Callable[[], None] | None = None,
    ) -> None:
        """Ask, and call `then` only after a yes, or `charge`, where it is offered, after a C."""
        self._question = question
        self._then = then
        self._charge = charge
        self.query_one("#charge").display = charge is not None
        self.query_one("#question", Static).update(translate(question()))
        self._timer.resume()
        self.open(self)

    def _put(self) -> None:
        if not self.is_open:
            self._timer.pause()
        elif question := self._question():
            self.query_one("#question", Static).update(translate(question))
        else:
            self.action_close()

    @on(Button.Pressed, "#yes")
    def action_confirm(self) -> None:
        self._answer(self._then)

    @on(Button.Pressed, "#charge")
    def action_charge(self) -> None:
        if self._charge is not None:
            self._answer(self._charge)

    def _answer(self, act: Callable[[], None]) -> None:
        if not self.is_open:
            return
        # Closing restyles the screen; the command does not wait for that.
        asked = self._then
        act()
        # It may have asked a further question.
        if self._then is asked:
            self.action_close()

    @on(Button.Pressed, "#no")
    def refuse(self) -> None:
        self.action_close()
