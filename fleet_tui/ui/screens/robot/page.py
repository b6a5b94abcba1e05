"""The page of the selected robot: values with their ages, battery curve, route, orders, alarms, commands."""

from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import partial
from typing import ClassVar

from rich.style import Style
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.worker import get_current_worker

from fleet_tui.keys import Pane
from fleet_tui.model.audit_record import PastAlarm
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.log import Audit
from fleet_tui.records.audit.past_alarms import past_alarms
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.situation.battery.forecast import forecast
from fleet_tui.situation.battery.history import BatteryHistories
from fleet_tui.situation.why.complaints import complaints
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.screens.overlay import ReturningOverlay
from fleet_tui.ui.screens.robot.overlay import RobotOverlay, robot_bindings
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.robot.page import PageContent, page_lines, page_title
from fleet_tui.ui.view.robot.sections import LAST, Clock, Line
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.bindings import bindings
from fleet_tui.ui.widgets.line_view import LineView
from fleet_tui.ui.widgets.pace import Pace
from fleet_tui.ui.widgets.rows_pane import row_actions
from fleet_tui.ui.widgets.text_view import TextView

READ_EVERY = 5.0
"""Seconds after which the audit log is read again."""


REDRAW_EVERY = 5
"""Seconds after which the curve is drawn again without a new sample."""
NOT_KEPT = Message("past ones: no audit log here")


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
        self._past: tuple[str, Sequence[PastAlarm], Message] = "", (), EMPTY
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
        from fleet_tui.ui.view.robot.chart import battery_chart

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
        import fleet_tui.ui.view.robot.chart  # noqa: F401  # takes a tenth of a second

        audit = self._audit()
        past: Sequence[PastAlarm] = ()
        note = EMPTY if audit is not None else NOT_KEPT
        if audit is not None:
            try:
                records = AuditReader(audit.file.path).newest_first()
                past = past_alarms(records, audit.origin.run, name, LAST)
            except OSError as failed:
                note = Message("past ones: log not readable: {strerror}", strerror=failed.strerror)
        self._past = (name, past, note)
        self._can_draw = True


# Textual's queries follow the first base alone.
class RobotPage(ReturningOverlay, RobotOverlay, can_focus=True):
    """Collects battery levels all the time, and shows them with the rest while it is open."""

    KEY, EVERY = "robot_page", 0.5
    BINDINGS: ClassVar[list[BindingType]] = [
        *bindings(Pane.RECORDING),  # first: in one, `.` and `,` are its keys
        *robot_bindings("robot_page"),
        *bindings(Pane.ROWS),
    ]

    def __init__(
        self,
        source: PageSource,
        menu: Callable[[str], None],
        beside: Callable[[], tuple[int, int]] = lambda: (0, 0),
    ) -> None:
        """`menu` opens that of a robot; `beside` returns the cells of the tables if the page has space there,
        else 0: then it covers the map, too; and the lines above small maps, 0 without them."""
        super().__init__(id="robot-page")
        self._source = source
        self._beside = beside
        self._pace = Pace(READ_EVERY)
        self._name = ""
        self._second = 0
        self._title = LineView(id="robot-page-title", keep_right=True)
        self._text = TextView(id="robot-page-text", moved=self._show_title)
        self._menu = menu

    def compose(self) -> ComposeResult:
        """Compose a title above the text."""
        yield self._title
        yield self._text

    def set_role_styles(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change every colour."""
        for view in (self._title, self._text):
            view.set_role_styles(styles)

    def collect(self) -> None:
        """Keep the battery levels of the newest state, whether it is open or not. A recording that jumps
        shows its new time at once."""
        state, _ = self._source.looked_at()
        self._source.collect(state)
        if self.is_open and int(state.now) != self._second:
            self.look()

    def show(self) -> None:
        """Open on the selected robot."""
        self._name = ""
        self._place()
        self.begin()
        self.look()

    def _place(self) -> None:
        """Leave the map in view where the tables' place is enough, and the small ones if the page is no
        longer."""
        cells, above = self._beside()
        is_short = above > 0 and len(self._source.lines(cells, above - 1)) < above
        self.styles.dock = "right"
        self.styles.width = cells or "100%"
        self.styles.height = above if is_short else "100%"

    def look(self) -> None:
        """Show the newest state, of another robot from the top."""
        state, name = self._source.looked_at()
        self._second = int(state.now)
        if self._pace.is_due(name):
            self.run_worker(lambda: self._read(name), thread=True, exclusive=True, group="robot page")
        if name != self._name:
            self._name = name
            self._text.show(lambda width: self._source.lines(width, self._text.size.height))
        else:
            self._text.draw()

    def _show_title(self, position: str) -> None:
        title = page_title(*self._source.looked_at())
        self._title.show(title, [(f"{position} ", StyleRole.DIM)] if position else ())

    def _read(self, name: str) -> None:
        self._source.read(name)
        if not get_current_worker().is_cancelled:
            self.app.call_from_thread(self.on_resize)

    def on_resize(self) -> None:
        """Place it anew, and fill it at its new size: also what was read changes how many lines it needs."""
        if self.is_open:
            self._place()
            self.look()

    def action_key(self, id_: str) -> None:
        """Run the action of a key of tables."""
        row_actions(self)[id_]()

    def move(self, step: int) -> None:
        """Scroll up or down."""
        self._text.move(step)

    @property
    def page(self) -> int:
        return self._text.page

    def slide(self, step: int) -> None:
        """Do nothing: lines have the width of the screen."""

    def open_menu(self) -> None:
        self._menu(self._source.looked_at()[1])
