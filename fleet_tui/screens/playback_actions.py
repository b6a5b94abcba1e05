"""The main screen while it shows a recording: what it says of it, and the keys that move in it."""

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from fleet_tui.errors import FleetError
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.screens.audit_actions import AuditActions
from fleet_tui.screens.dispatch import Dispatch
from fleet_tui.screens.recording_actions import RecordingActions
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.lines.status import console_notes, status_line, status_right
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.selection import Selection
from fleet_tui.widgets.line_view import LineView
from fleet_tui.widgets.messages import TimePicked

if TYPE_CHECKING:
    from fleet_tui.recording.play.player import Player
    from fleet_tui.screens.palette import Palette
    from fleet_tui.screens.typed import Typed
    from fleet_tui.widgets.map_view import MapView
    from fleet_tui.widgets.time_line import TimeLine

IT_IS_A_RECORDING = "not sent: this is a recording"
ACTIONS = frozenset({"playback", "go_to_time"})


class PlaybackActions(RecordingActions, AuditActions, Dispatch):
    """`player` is None where the fleet itself is shown."""

    player: "Player | None" = None
    time_line: "TimeLine | None" = None
    map: "MapView"
    palette: "Palette"
    selection: Selection
    clock: Callable[[float], str]
    status: LineView
    furnished: bool
    _jumps = 0

    @property
    def panes(self) -> tuple[str, ...]:
        """Where the keys work that work everywhere."""
        return ("console",) if self.player is None else ("recording", "console")

    def show_status(self, state: FleetState) -> None:
        """The line that is always in view. A recording is never mistaken for the fleet."""
        if self.player is not None:
            self._show_recording(state)
            return
        notes = console_notes(state, self.read_only, self.armed, time.monotonic() - state.now)
        notes += [*self.audit_notes(), *self.recording_notes()]
        right = status_right(self.clock(state.wall), self.operator)
        self.status.show(status_line(state, self.selection.robot, notes), right)

    def _show_recording(self, state: FleetState) -> None:
        assert self.player is not None
        moment = self.player.moment
        if moment.jumps != self._jumps and self.furnished:
            self._jumps, self.said = moment.jumps, ""
            self.map.forget()
        date = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(moment.wall))
        runs = status_line(state, self.selection.robot, addressed=False)
        self.status.show(((f" REPLAY {date} ", StyleRole.WARN), *runs))
        if self.time_line is not None:
            self.time_line.show(moment, self.clock)

    async def show_time_line(self) -> None:
        """Put the time line above the hints, if a recording is played."""
        if self.player is not None:
            from fleet_tui.widgets.time_line import TimeLine

            self.time_line = TimeLine(id="time-line")
            await self.mount(self.time_line, before="#hints")

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """The keys of a recording mean nothing where none is played, and there nothing can be armed."""
        if (action in ACTIONS and self.player is None) or (action == "arm" and self.player is not None):
            return False
        return super().check_action(action, parameters)

    def give(self, wish: Request, sent: Callable[[], None] = lambda: None) -> str:
        """Send a wish, unless a recording is shown."""
        return super().give(wish, sent) if self.player is None else IT_IS_A_RECORDING

    def action_playback(self, what: str, *args: int) -> None:
        """Something that the player does, or why not."""
        said = getattr(self.player, what)(*args)
        if said:
            self.say(said)

    def action_go_to_time(self) -> None:
        """Type a time to go to."""
        self.palette.show("@")

    def as_time(self, line: str) -> "Typed | None":
        """A typed line as a time of the recording to go to, None where it is none."""
        from fleet_tui.screens.typed import Typed

        text = line.strip().removeprefix("@").strip()
        if self.player is None or not (line.startswith("@") or text.startswith("+") or ":" in text):
            return None
        if not text:
            from fleet_tui.recording.play.times import FORMS

            return Typed(problem=f"go to a time: {FORMS}")
        player = self.player
        try:
            at = player.time_of(text)
        except FleetError as problem:
            return Typed(problem=sanitize(str(problem)))
        return Typed([(f"Go to {text}", lambda: player.seek(at))])

    def on_time_picked(self, event: TimePicked) -> None:
        """Go to a time that was clicked."""
        if self.player is not None:
            from fleet_tui.view.lines.time import time_at

            self.player.seek(time_at(self.player.moment, event.x, event.width))
