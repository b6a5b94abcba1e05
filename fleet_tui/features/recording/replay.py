"""A console on a recording: its notices, and the keys that move in it."""

import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from fleet_tui.keys import Key, Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.session import Headline
from fleet_tui.ui.controllers.typed import Typed
from fleet_tui.ui.view.lines.status import status_line
from fleet_tui.ui.view.lines.time import time_at
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.time_line import TimeLine

if TYPE_CHECKING:
    from fleet_tui.records.recording.play.player import Player


class Replay:
    """Plays, seeks, and keeps the time line."""

    panes: tuple[Pane, ...] = (Pane.RECORDING, Pane.CONSOLE)
    pane: Pane | None = Pane.RECORDING

    def __init__(self, player: "Player", console: Console, forget_trails: Callable[[], bool]) -> None:
        self._player = player
        self._notices = console.notices
        self._clock = console.settings.clock
        self._forget_trails = forget_trails
        self._jumps = 0
        self._time_line: TimeLine | None = None

    def offers(self, key: Key) -> bool:
        """Leave out the keys of live consoles."""
        return not key.only_live

    def headline(self, state: FleetState, robot: str, width: int) -> Headline:
        """Show the recorded time. A recording is never mistaken for the fleet."""
        moment = self._player.moment
        if moment.jumps != self._jumps and self._forget_trails():
            self._jumps = moment.jumps
            self._notices.clear()
        if self._time_line is not None:
            self._time_line.show(moment, self._clock)
        date = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(moment.wall))
        return (
            (Message(" REPLAY {date} ", date=date), StyleRole.WARN),
            *status_line(state, robot, addressed=False),
        ), ()

    def time_line(self) -> "TimeLine":
        """Return the time line widget, updated at every tick."""
        self._time_line = TimeLine(id="time-line")
        return self._time_line

    @property
    def actions(self) -> Mapping[str, Callable[[], object]]:
        """Return the actions of the keys of the player."""
        player = self._player
        return {
            "play": player.toggle,
            "skip_back": partial(player.skip, -10),
            "skip_on": partial(player.skip, 10),
            "previous_mark": partial(self._to_mark, -1),
            "next_mark": partial(self._to_mark, 1),
            "step_back": partial(player.step, -1),
            "step_on": partial(player.step, 1),
            "record_back": partial(player.step_record, -1),
            "record_on": partial(player.step_record, 1),
            "faster": partial(player.change_speed, 1),
            "slower": partial(player.change_speed, -1),
            "usual_speed": partial(player.change_speed, 0),
            "to_beginning": partial(player.to_end, -1),
            "to_the_end": partial(player.to_end, 1),
        }

    def _to_mark(self, step: int) -> None:
        if said := self._player.to_mark(step):
            self._notices.say(said)

    def typed(self, line: str) -> "Typed | None":
        """Parse a typed line as a time of the recording, None if it is not one."""
        text = line.strip().removeprefix("@").strip()
        if not (line.startswith("@") or text.startswith("+") or ":" in text):
            return None
        if not text:
            from fleet_tui.records.recording.play.times import FORMS  # imports numpy

            return Typed(problem=Message("enter a time: {forms}", forms=FORMS))
        try:
            at = self._player.time_of(text)
        except FleetError as problem:
            return Typed(problem=sanitize(message_of(problem)))
        return Typed([(Message("Go to {text}", text=text), lambda: self._player.seek(at))])

    def pick_time(self, x: int, width: int) -> None:
        """Go to the time of a cell of the time line."""
        self._player.seek(time_at(self._player.moment, x, width))
