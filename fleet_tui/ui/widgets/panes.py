"""The panes of the main screen, and how they share its lines."""

from collections.abc import Callable, Collection, Hashable, Sequence
from typing import TYPE_CHECKING

from textual.containers import Container
from textual.geometry import Size
from textual.widget import Widget

from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.activity_bars import RecentActivity, activity_table
from fleet_tui.ui.view.layout import (
    BROAD,
    LEAST_BESIDE,
    LEAST_SHARED,
    LEAST_TABLES,
    PAGE_BESIDE,
    USUAL_SHAPE,
    WIDE_TABLES,
    Wanted,
    below_buttons,
    below_floor,
    below_map,
    below_narrow_floor,
    below_page,
    beside_map,
    dialog_box,
    is_beside_events,
    is_better_beside,
    simple_alone,
    width_of_map,
    without_map,
)
from fleet_tui.ui.view.tables.table import Table
from fleet_tui.ui.widgets.dialog_place import DialogPlace
from fleet_tui.ui.widgets.pace import Pace
from fleet_tui.ui.widgets.rows_pane import RowsPane

if TYPE_CHECKING:  # numpy
    from fleet_tui.ui.view.map.scene import Scene
    from fleet_tui.ui.widgets.map_view import MapView

PRECISE = 1000
OTHERS = 3
"""Lines of the screen that are no panes: status, message, footer. Before the first layout."""


class Panes(Container):
    """The place of the map, the last events, fleet, alarms, queue, the page of the selected robot, and the
    small maps of other floors. Only its background is visible, between the panes: Textual need not build it
    row by row."""

    BLANK = True

    def __init__(self, is_ascii: bool = False) -> None:
        self.fleet = RowsPane(id="fleet")
        self.alarms = RowsPane(id="alarms")
        self.queue = RowsPane(id="queue")
        self.page = RowsPane(id="page")
        self.page.can_focus = False
        self.below = BelowMap(is_ascii)
        self.small_maps = Container(id="small-maps")
        self.recent = self.below.recent
        self.activity = self.below.activity
        self.floor = Container(Container(id="map"), self.below, id="floor")
        aside = Container(self.page, self.small_maps, id="aside")
        super().__init__(self.floor, self.fleet, self.alarms, self.queue, aside, id="panes")
        self._alone = ""
        self._small_lines = 0
        self._left = 0
        self._queue_lines = 0
        self._page_pace = Pace(0.5)
        self._recent_pace = Pace(1.0)
        self._shown: Sequence[Table] = ()
        self._shape = USUAL_SHAPE
        self._wanted = (Wanted(0, 0, 0), 0)
        self._shared_out: object = None
        self._dialogs = DialogPlace()
        self._large = DialogPlace()

    async def mount_small_maps(self, aside: Widget, below: Widget) -> None:
        """Mount the maps of other floors, for the place beside the map and that below it."""
        await self.small_maps.mount(aside)
        await self.below.maps.mount(below)

    def place_dialogs(self, large: Widget, *dialogs: Widget) -> None:
        """Keep dialogs about the map in one place that covers none of it, a `large` one in a larger one."""
        self._dialogs = DialogPlace(*dialogs)
        self._large = DialogPlace(large)

    @property
    def tables(self) -> tuple[RowsPane, ...]:
        """Return the panes of rows that can be filtered, sorted and marked."""
        return self.fleet, self.alarms, self.queue

    @property
    def has_small_maps(self) -> bool:
        """Tell whether small maps of other floors are shown."""
        return self.small_maps.display or (self.below.maps.display and self.below.display)

    @property
    def space_beside_map(self) -> tuple[int, int]:
        """Return the cells of the tables where a robot's page fits in their place, and its lines above small
        maps; else, and without these, 0."""
        if not self.screen.has_class("-wide") or self.size.height < PAGE_BESIDE or self._alone:
            return 0, 0
        return self.fleet.outer_size.width, self.small_maps.display * (self.size.height - self._small_lines)

    @property
    def views(self) -> list[RowsPane]:
        return [*self.tables, self.page, self.recent, self.activity.rows]

    def show(
        self,
        state: FleetState,
        tables: Sequence[Table],
        robot: str,
        page: Callable[[str, int], Table],
        recent: Callable[[int, int], Table],
        covered: int = 0,
    ) -> None:
        """Show fleet, alarms and queue, and if there are lines for them the page of the selected robot, the
        last events, and the activity of the robots that the fleet lists first. `covered`: lines at the
        bottom below an overlay about the map."""
        if not self.is_attached:
            return  # the console ends
        self._wanted = Wanted(*(table.lines for table in tables)), covered
        self.share_out()
        for pane, table in zip(self.tables, tables, strict=True):
            if not any(table is shown for shown in self._shown):
                pane.show(table)
        self._shown = tables
        if self.page.size.height and self._page_pace.is_due((robot, self.page.size)):
            self.page.show(page(robot, self.page.row_width))
        if self.recent.size.height and self._recent_pace.is_due(self.recent.size):
            self.recent.show(recent(self.recent.size.height - 1, self.recent.row_width))
        self.activity.look(state, [key for key in tables[0].keys if isinstance(key, str)])

    def show_map(self, view: "MapView", scene: "Scene") -> None:
        """Show a scene on the map, which is drawn once its height is that for its floor."""
        view.picture.show(scene)
        # Of a width at which a line more or less changes nothing: the columns must hold.
        if lines := view.picture.lines_of_floor(PRECISE):
            self._shape = lines / PRECISE
        if not self._show_floor(view.picture.lines_of_floor(self.floor.size.width)):
            view.draw()

    def _show_floor(self, lines: int) -> bool:
        """Give the last events the lines that the floor leaves. `lines`: those of the floor as a whole. Tell
        whether the map gets another height, and so a resize."""
        if not self.is_attached:
            return False  # the console ends
        is_wide, is_beside = self.screen.has_class("-wide"), self.screen.has_class("-beside")
        has_space = (is_wide or is_beside) and not self._is_small
        above = [part for part in self.floor.children if part.id in ("simple", "camera") and part.display]
        space = self.size.height - sum(part.outer_size.height for part in above)
        self._left = below_floor(space, lines, is_beside) if has_space and lines and not self._alone else 0
        queue, recent = (
            below_narrow_floor(self._left, self._wanted[0].queue) if is_beside else (0, self._left)
        )
        if queue != self._queue_lines:
            self._queue_lines = queue
            self.share_out()
        map_width = self.floor.outer_size.width
        box = dialog_box(self.recent.region.size, map_width, *self.size)
        large = dialog_box(self.below.rows_size, map_width, *self.size, self.size.height // 2)
        self._dialogs.move_to(box if has_space else None)
        self._large.move_to(large if has_space else None)
        return self.below.take(recent)

    def _place_queue(self, lines: int) -> None:
        """Put the queue into so many lines below the map, or with 0 back among the tables."""
        self.set_class(lines > 0, "-queue-below")
        self.queue.styles.width = self.floor.outer_size.width if lines else None
        self.queue.styles.height = lines or None
        self.floor.styles.height = self.size.height - lines if lines else None

    def on_resize(self) -> None:
        """Share out the new lines at once."""
        self.set_class(self.size.width >= LEAST_BESIDE, "-roomy")
        self.set_class(self.size.width >= BROAD, "-broad")
        self.share_out()

    @property
    def is_enlarged(self) -> bool:
        """Tell whether a pane has its whole column."""
        return bool(self._alone)

    def enlarge(self) -> None:
        """Give the focused pane its whole column, or all of them their places."""
        inside = [pane.id or "" for pane in self.children if pane.has_focus_within]
        self._alone = inside[0] if inside and not self._alone else ""

    def share_out(self) -> None:
        """Give the panes their heights."""
        wanted, covered = self._wanted
        lines = self.size.height or self.app.size.height - OTHERS
        is_wide = self.screen.has_class("-wide") and not self._is_small
        # Below the map a form about it leaves no space for another pane.
        may_enlarge = (is_wide or not covered) and self._alone in self._enlargeable(is_wide)
        alone = self._alone if may_enlarge else ""
        heights = (lines, *[0] * 3)[: 4 if is_wide else 1] if alone else self._heights(lines, wanted, covered)
        self._share_aside(lines, heights[-1] if len(heights) == 4 and not alone else 0)
        is_beside = len(heights) == 4 and not is_wide
        below = self._queue_lines if is_beside else 0
        rows = " ".join(str(height) for height in heights if height or not below)
        # An enlarged table has all its columns.
        kept = WIDE_TABLES if alone not in ("", "floor") else LEAST_TABLES
        map_width = width_of_map(self.size.width, lines, self._shape, kept) if is_wide else 0
        if (rows, alone, map_width, below, self.size) == self._shared_out:
            return
        self._shared_out = rows, alone, map_width, below, self.size
        self.screen.set_class(is_beside, "-beside")
        self._place_queue(below)
        self.styles.grid_rows = rows
        self.styles.grid_columns = f"{map_width} 1fr" if is_wide else None
        for pane in self.children:
            keeps = is_wide and pane.id == "floor"
            spans = (not is_wide and not self._is_small) or alone == "floor"
            is_out = bool(alone) and pane.id != alone and not keeps
            pane.set_class(is_out or (pane.id == "aside" and not heights[-1]), "-hidden")
            pane.set_class(bool(alone) and pane.id == alone and spans, "-across")

    def _share_aside(self, lines: int, page: int) -> None:
        """Give small maps half of the last events' lines, or lines that the robot's page can spare."""
        has_some, column, fleet = bool(self.small_maps.children), self.page.size.width, self._wanted[0].fleet
        is_below = has_some and is_beside_events(self._left, self.floor.size.width, lines, fleet, column)
        self.below.divide(is_below, self.floor.size.width)
        small = below_page(lines, page, column) if has_some and not is_below else 0
        if small != self._small_lines:
            self._small_lines = small
            self.small_maps.styles.height = small
            self.small_maps.display = small > 0

    @property
    def _is_small(self) -> bool:
        return self.screen.has_class("-tiny") or self.screen.has_class("-flat")

    def _enlargeable(self, is_wide: bool) -> Collection[str]:
        """Return the panes that can have the column."""
        if self.has_class("-simple"):
            return ("fleet", "alarms", "queue") if is_wide else ()
        return ("fleet", "alarms") if self._is_small else ("floor", "fleet", "alarms", "queue")

    def _heights(self, lines: int, wanted: Wanted, covered: int) -> tuple[int, ...]:
        is_simple = self.has_class("-simple")
        if self._is_small:
            return simple_alone(lines) if is_simple else without_map(lines, wanted)
        if self.screen.has_class("-wide"):
            return beside_map(lines, wanted)
        if is_simple:
            return below_buttons(lines, wanted)
        if not is_better_beside(self.size.width, lines, wanted, self._shape):
            return below_map(lines, wanted, covered)
        return beside_map(lines, wanted, bool(self._queue_lines))


class ActivityPane:
    """Records what the robots do also while its rows are not shown. `is_ascii`: the terminal has no other
    signs."""

    def __init__(self, is_ascii: bool) -> None:
        self.rows = RowsPane(id="activity")
        self.rows.can_focus = False
        self._recent = RecentActivity()
        self._pace = Pace(1.0)
        self._is_ascii = is_ascii

    def look(self, state: FleetState, robots: Sequence[Hashable]) -> None:
        """Record the newest state, and show as many of the robots as there are lines."""
        self._recent.note(state)
        lines, width = self.rows.size.height, self.rows.row_width
        if lines and self._pace.is_due((lines, width, robots)):
            self.rows.show(activity_table(self._recent, robots, lines, width, self._is_ascii))


class BelowMap(Container):
    """Has the lines that the floor leaves. `is_ascii`: the terminal has no other signs."""

    def __init__(self, is_ascii: bool) -> None:
        self.recent = RowsPane(id="recent")
        self.recent.can_focus = False
        self.activity = ActivityPane(is_ascii)
        self.maps = Container(id="maps-below")
        super().__init__(self.recent, self.activity.rows, self.maps, id="below")
        self._lines = 0

    @property
    def rows_size(self) -> Size:
        """Return the cells and lines of its rows, without those of the maps."""
        return self.recent.region.size if self.maps.display else self.region.size

    def take(self, lines: int) -> bool:
        """Take so many lines, 0 for none, and tell whether it had others."""
        if lines == self._lines:
            return False
        self._lines = lines
        self.styles.height = lines
        self.display = lines > 0
        return True

    def divide(self, has_maps: bool, cells: int) -> None:
        """Show beside the last events small maps, or activities if there are enough cells."""
        self.maps.display = has_maps
        self.activity.rows.display = not has_maps and cells >= LEAST_SHARED
