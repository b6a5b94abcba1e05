"""Requests to routines: checked and asked first."""

from collections.abc import Callable, Sequence
from functools import partial

from msgspec.structs import replace

from fleet_tui.features.routines.folder import RoutinePlace, look_at_all
from fleet_tui.features.routines.lane import (
    Gate,
    LanePaused,
    LanePhase,
    LaneRequest,
    LaneResumed,
    LaneSkipped,
    LaneStepped,
    LaneStopped,
)
from fleet_tui.features.routines.led import LedRoutines
from fleet_tui.features.routines.lines import lane_text, lane_word, row_word
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.features.routines.run import RoutineRun
from fleet_tui.features.routines.start import Examined, examine
from fleet_tui.model.problem import Right
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.language import EMPTY, Message, joined
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry

ShowText = Callable[[Message, Sequence[str]], None]
"""Shows a text with its title."""


class RoutineRequests:
    """Lists the routines, opens the menu of one, and carries out what is chosen."""

    def __init__(self, place: RoutinePlace, console: Console, led: LedRoutines) -> None:
        self._place = place
        self._store = console.store
        self._dispatch = console.dispatch
        self._notices = console.notices
        self._led = led
        self._ask = console.ask
        self._open_menu = console.open_menu
        self._in_background = console.in_background
        self._seen: list[RoutineRow] = []
        self._is_looking = False

    @property
    def rows(self) -> list[RoutineRow]:
        """Return every routine, those that run here with their newest progress."""
        return [self._with_run(row) for row in self._seen]

    def _with_run(self, row: RoutineRow) -> RoutineRow:
        run = self._led.runs.get(row.name)
        if run is None:
            return row
        lanes = tuple(run.lanes.values())
        return replace(
            row, plans=run.plans, lanes=lanes, at=run.progress.started, owner=Message("this console")
        )

    def look(self) -> None:
        """Look at the files, not on the loop."""
        if not self._is_looking:
            self._is_looking = True
            self._in_background(partial(look_at_all, self._place, self._store.state), self._got)

    def _got(self, rows: list[RoutineRow]) -> None:
        self._is_looking = False
        self._seen = rows

    def tick(self) -> None:
        """Lead the robots of the routines that run here."""
        if self._led.tick():
            self.look()

    def menu(self, name: str, robot: str, show_text: ShowText) -> None:
        """List what can be done with a routine, or with one robot of it."""
        row = next((one for one in self.rows if one.name == name), None)
        if row is None:
            return
        run = self._led.runs.get(name)
        entries: list[Entry] = [] if run is None else self._changes(run, robot)
        may = not self._dispatch.permissions.refusal(Right.DISPATCH)
        if row.is_left and may:
            entries.append(
                (Message("Continue where it left off, held"), self._starting(name, True, show_text))
            )
        if not row.owner and may:
            entries.append((Message("Start"), self._starting(name, False, show_text)))
        entries.append((Message("Check: problems or timeline"), partial(self._check, name, show_text)))
        lane = next((one for one in row.lanes if one.robot == robot and not row.is_left), None)
        state = lane_word(lane) if lane is not None else row_word(row)
        by = Message(", run by {owner}", owner=row.owner) if row.owner and run is None else EMPTY
        title = Message("{name}: {state}{by}", name=" ".join(filter(None, (name, robot))), state=state, by=by)
        where = lane_text(row.plans[robot], lane) if lane is not None else ""
        self._open_menu(joined("\n", (sanitize(line) for line in (title, where) if line)), entries)

    def _changes(self, run: RoutineRun, robot: str) -> list[Entry]:
        """Return the requests that change something in the present state of a robot, or of all."""
        lanes = [lane for name, lane in run.lanes.items() if robot in ("", name) and not lane.is_over]
        shut = [lane for lane in lanes if lane.gate in (Gate.PAUSED, Gate.HELD)]
        found: list[tuple[Message, LaneRequest]] = []
        if shut:
            found += [(Message("Resume"), LaneResumed()), (Message("Step: one instruction"), LaneStepped())]
        if any(lane.phase is LanePhase.READY for lane in shut):
            found.append((Message("Skip the next instruction, and resume"), LaneSkipped()))
        if len(shut) < len(lanes):
            found.append((Message("Pause: running orders continue, nothing new starts"), LanePaused()))
        if lanes:
            found.append((Message("Stop: running orders continue"), LaneStopped()))
        return [(text, partial(self._request, run, event, robot)) for text, event in found]

    def _request(self, run: RoutineRun, event: LaneRequest, robot: str) -> None:
        self._led.request(run, event, robot)
        self.tick()

    def _check(self, name: str, show_text: ShowText) -> None:
        def show(found: Examined) -> None:
            title = (
                Message("{name}: problems", name=name)
                if found.problems
                else Message("{name}: timeline, if it started now", name=name)
            )
            show_text(title, found.problems or found.timeline)

        self._in_background(partial(examine, self._place, self._store.state, name), show)

    def _starting(self, name: str, is_left: bool, show_text: ShowText) -> Callable[[], None]:
        """Return the start of a routine, or its continuation where it left off: checked, then asked."""

        def ask(found: Examined) -> None:
            if found.problems:
                show_text(Message("{name}: not started", name=name), found.problems)
            else:
                self._ask(lambda: found.question(is_left), partial(self._start, found, is_left))

        def start() -> None:
            if refusal := self._dispatch.set_up_refusal(Right.DISPATCH):
                self._notices.say(
                    sanitize(Message("{name}: not started: {refusal}", name=name, refusal=refusal))
                )
                return
            self._in_background(partial(examine, self._place, self._store.state, name), ask)

        return start

    def _start(self, found: Examined, is_left: bool) -> None:
        assert found.file is not None
        name = found.file.name
        try:
            self._led.start(found.file, is_left)
        except RoutineError as problem:
            self._notices.say(sanitize(Message("{name}: not started: {problem}", name=name, problem=problem)))
        else:
            self._notices.say(
                sanitize(
                    Message(
                        "{name}: {change}",
                        name=name,
                        change=Message("continued, held") if is_left else Message("started"),
                    )
                )
            )
