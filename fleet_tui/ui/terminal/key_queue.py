"""Keys one at a time: each meets what the one before it led to.

Textual posts a key to the widget that has the focus when it arrives, and runs its binding once it has bubbled
up; of keys that arrive together, later ones then overtake the effect of earlier ones.
"""

import math
import time
from collections import deque
from collections.abc import Awaitable, Callable
from functools import partial
from typing import Any

from textual import events
from textual.app import App
from textual.message import Message
from textual.message_pump import MessagePump
from textual.timer import Timer
from textual.widgets import Input

from fleet_tui.ui.terminal.typing import GAP, STANDSTILL, Fate, Typing

ROUNDS = 2
"""Trips through the widgets until a key is done: with the first one its binding has run, with the second one
the messages that it posted have arrived."""
PATIENCE = 1.0
TRIES = 5
"""Seconds after which the next key is delivered all the same if the widget of the last one was removed, and
how many times as many if it is still there."""
BEAT = 0.5
"""Seconds between two looks whether the loop runs."""


class KeyDone(Message):
    """Follows a key on its way to the app."""

    def __init__(self, serial: int) -> None:
        super().__init__()
        self.serial = serial


class KeyQueue:
    """Delivers keys, pastes and the mouse in their order; once it `guards`, without typed text that would
    command."""

    def __init__(self, app: App[Any], deliver: Callable[[events.Event], Awaitable[None]]) -> None:
        self._app = app
        self._deliver = deliver
        self.clock: Callable[[], float] = time.monotonic
        """That by which keys say when they arrived."""
        self.unread_for: Callable[[], float] = lambda: 0.0
        """Returns the seconds for which the terminal has not read what is sent."""
        self._typing = Typing()
        self._guards = False
        self._dropped: Callable[[int, bool], None] = lambda count, is_blind: None
        self._pauses_all: Callable[[str], bool] = lambda key: False
        self._waiting: deque[events.Event | Callable[[], object]] = deque()
        self._serial = 0
        self._rounds = 0
        self._target: MessagePump = app
        self._timer: Timer | None = None
        self._tries = TRIES
        self._beat_at = math.inf
        self._held: events.Key | None = None

    def guard(self, dropped: Callable[[int, bool], None], pauses_all: Callable[[str], bool]) -> None:
        """Judge keys from now on. `dropped` is called with the number of keys that were dropped in a row, and
        whether because of a standstill; `pauses_all` tells of a key whether it pauses all robots."""
        self._guards = True
        self._dropped = dropped
        self._pauses_all = pauses_all

    def watch(self) -> None:
        """Watch for standstills of the console from now on."""
        self._beat_at = self.clock()
        self._app.set_interval(BEAT, self._beat)

    def read_again(self, unread_for: float) -> None:
        """Drop the keys that waited for so many seconds in which the terminal did not read."""
        if unread_for > STANDSTILL:
            self._typing.stood_still(self.clock())

    def _beat(self) -> None:
        self._look_for_standstill()
        self._beat_at = self.clock()

    def _look_for_standstill(self) -> None:
        now = self.clock()
        if now - self._beat_at > STANDSTILL + BEAT:
            self._typing.stood_still(now)

    async def take(self, event: events.Event) -> None:
        """Deliver an event of the keyboard or the mouse once the keys before it are done."""
        self._waiting.append(event)
        if self._rounds and self._timer is None:
            self._timer = self._app.set_timer(PATIENCE, partial(self._lose_patience, self._serial))
        await self._next()

    async def then(self, do: Callable[[], object]) -> None:
        """Do something once the keys before it are done: the release of a key must not overtake its press."""
        self._waiting.append(do)
        await self._next()

    async def _next(self) -> None:
        while self._waiting and not self._rounds:
            event = self._waiting.popleft()
            if not isinstance(event, events.Event):
                event()
            elif isinstance(event, events.Key) and event.key == "escape" and self._typing.is_alone:
                self._waiting.appendleft(event)
                await self._release()  # nothing that could have been meant with it came before
            elif isinstance(event, events.MouseEvent):
                await self._deliver(event)
            elif not isinstance(event, events.Key) or self._acts(event):
                await self._begin(event)

    async def _begin(self, event: events.Event) -> None:
        self._serial += 1
        self._rounds = ROUNDS
        self._tries = TRIES
        self._target = self._app.focused or self._app.screen
        await self._deliver(event)
        await self._follow()

    def _acts(self, event: events.Key) -> bool:
        if not self._guards:
            return True
        self._look_for_standstill()
        self.read_again(self.unread_for())
        in_field = isinstance(self._app.focused, Input)
        is_text = event.is_printable or event.key == "enter"
        pauses_all = self._pauses_all(event.key)
        verdict = self._typing.judge(event.key, is_text, event.time, in_field, pauses_all)
        if verdict is Fate.WAITS:
            self._held = event
            self._app.set_timer(GAP, self._release)
        elif verdict is Fate.DROPPED:
            self._dropped(self._typing.dropped, self._typing.is_blind)
        return verdict is Fate.ACTS

    async def _release(self) -> None:
        """Deliver the key that waited, if it is still alone."""
        event, self._held = self._held, None
        if event is not None and self._typing.is_alone:
            self._typing.is_alone = False
            await self._begin(event)

    async def _follow(self) -> None:
        """Send a message behind the key."""
        for target in (self._target, self._app.screen):
            if target.is_attached and target.post_message(KeyDone(self._serial)):
                return
        await self._done()

    async def passed(self, done: KeyDone) -> None:
        """Go on once everything before this message has passed."""
        if done.serial != self._serial or not self._rounds:
            return
        self._rounds -= 1
        if self._rounds:
            await self._follow()
        else:
            await self._done()

    async def _lose_patience(self, serial: int) -> None:
        self._timer = None
        self._tries = self._tries - 1 if serial == self._serial else TRIES
        if self._waiting and (not self._tries or not self._target.is_attached):
            await self._done()
        elif self._waiting:
            self._timer = self._app.set_timer(PATIENCE, partial(self._lose_patience, self._serial))

    async def _done(self) -> None:
        self._rounds = 0
        await self._next()
