"""The contents of a robot's page: the state, the battery levels seen so far, the alarms in the audit log."""

from collections.abc import Callable, Hashable, Sequence
from functools import partial

from fleet_tui.audit.log import Audit
from fleet_tui.audit.past_alarms import past_alarms
from fleet_tui.audit.reader import AuditReader
from fleet_tui.backend import Backend
from fleet_tui.model.audit_record import PastAlarm
from fleet_tui.model.fleet import FleetState
from fleet_tui.rules.battery.forecast import forecast
from fleet_tui.rules.battery.history import BatteryHistories
from fleet_tui.rules.why.complaints import complaints
from fleet_tui.text.language import tr
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.robot.page import PageContent, page_lines
from fleet_tui.view.robot.sections import LAST, Clock, Line

REDRAW_EVERY = 5
"""Seconds after which the curve is drawn again without a new sample."""
NOT_KEPT = "past ones: no audit log here"


class PageSource:
    """Makes the lines of the page. `looked_at` returns the state and the selected robot, `drawing` the mode
    of the map."""

    def __init__(
        self,
        looked_at: Callable[[], tuple[FleetState, str]],
        audit: Callable[[], Audit | None],
        clock: Clock,
        drawing: Callable[[], Drawing],
        backend: Backend,
    ) -> None:
        self._backend = backend
        self.looked_at = looked_at
        self._audit = audit
        self._clock = clock
        self._drawing = drawing
        self._batteries = BatteryHistories()
        self._past: tuple[str, Sequence[PastAlarm], str] = "", (), ""
        """Of a robot: its past alarms, and a note on them."""
        self._can_draw = False
        self._drawn: tuple[Hashable, Sequence[Line]] = None, ()

    def collect(self, state: FleetState) -> None:
        """Keep the battery levels of a state."""
        self._batteries.look(state)

    def lines(self, width: int, height: int) -> Sequence[Line]:
        """Return the page; `height` are the lines that are visible at once."""
        state, name = self.looked_at()
        curve = partial(self._curve, state, name) if self._can_draw else None
        guess = forecast(self._batteries.of(name), state.limits.battery_low, state.now)
        of, past, note = self._past
        past = past if of == name else ()
        robot = state.robots[name]
        reported = complaints(state, robot, self._backend.counters.get(robot.link))
        content = PageContent(state, robot, self._clock, curve, guess, past, note, reported)
        return page_lines(content, width, height)

    def _curve(self, state: FleetState, name: str, width: int, height: int) -> Sequence[Line]:
        """Return the curve, drawn again for a new sample and every few seconds."""
        from fleet_tui.view.robot.chart import battery_chart

        samples = self._batteries.of(name)
        if not samples:
            return ()
        drawing = self._drawing()
        key = (name, len(samples), state.now // REDRAW_EVERY, width, height, drawing)
        if key != self._drawn[0]:
            now, low = (state.now, state.wall), state.limits.battery_low
            self._drawn = key, battery_chart(samples, now, (width, height), low, self._clock, drawing)
        return self._drawn[1]

    def read(self, name: str) -> None:
        """Load the drawing and read the past alarms of a robot; in a thread."""
        import fleet_tui.view.robot.chart  # noqa: F401  # takes a tenth of a second

        audit = self._audit()
        past: Sequence[PastAlarm] = ()
        note = "" if audit is not None else NOT_KEPT
        if audit is not None:
            try:
                records = AuditReader(audit.file.path).newest_first()
                past = past_alarms(records, audit.origin.run, name, LAST)
            except OSError as failed:
                note = tr(f"past ones: log not readable: {failed.strerror}")
        self._past = (name, past, note)
        self._can_draw = True
