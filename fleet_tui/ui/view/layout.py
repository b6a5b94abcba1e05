"""Heights of the panes: lines go where rows need them, and no pane vanishes."""

from typing import NamedTuple

from fleet_tui.ui.view.map.camera import MOST_TALL

LEAST_FLEET = 4
LEAST_LIST = 3
"""Lines, with the title."""
LEAST_MAP = 9
BUTTONS = 13
"""Lines of the simple interface."""
BROAD = 180
"""Cells from which its buttons are side by side."""
PAGE_BESIDE = 45
"""Lines of the panes from which a robot's page has all its sections one below the other."""
LEAST_BESIDE = 78
MAP_SHARE = 1 / 2
"""Cells from which a narrow screen can have the tables beside its map, and the map's share of them: as in
`fleet.tcss`."""
LEAST_PAGE = 6
SHORT_PAGE = 4
"""Lines from which the robot's page and the last events are worth their place, and from which the page has
lines that else were blank."""
LEAST_EVENTS = 3
BELOW_NARROW = 4
"""Those from which they have a place on a narrow screen, and those that they and the queue keep there."""
WIDE_SHARE = 0.6
LEAST_TABLES = 77
WIDE_TABLES = 92
"""The map's share of a wide screen's cells, those that the tables keep if the map can use more, and those of
tables with all their columns, which a large screen has beside its map."""
USUAL_SHAPE = 0.4
"""Lines of a floor per cell of its width, until one is known."""
WHOLE_PAGES = (9, 7)
LEAST_COLUMN = 60
STEP = 4
"""Lines that the robot's page keeps beside small maps, if need be fewer, cells of its column from which there
are some, and lines by which they grow."""

LEAST_DIALOG = 9
USUAL_DIALOG = 14
"""Lines of the last events from which a dialog about the map is in their place, and those that it has in that
of the tables' last ones."""
LEAST_SHARED = 90
"""Cells of a map from which the last events leave half of their lines to small maps, or to activities."""


class Wanted(NamedTuple):
    """Lines that each pane could use, with its title and the heads of its columns."""

    fleet: int
    alarms: int
    queue: int


class DialogBox(NamedTuple):
    """The place of a dialog at the bottom of the panes: cells from their left edge, its cells and lines."""

    left: int
    cells: int
    lines: int


def dialog_box(events: tuple[int, int], map_width: int, width: int, lines: int, usual: int = 0) -> DialogBox:
    """Return the place of a dialog about the map, never over that: the cells and lines of the last `events`,
    else the end of the tables beside it, of `usual` lines if those are more. It is the same whatever the
    dialog says."""
    if events[1] >= LEAST_DIALOG:
        return DialogBox(0, *events)
    return DialogBox(map_width + 1, width - map_width - 1, min(max(usual, USUAL_DIALOG), lines - LEAST_FLEET))


def beside_map(lines: int, wanted: Wanted, is_queue_below: bool = False) -> tuple[int, int, int, int]:
    """Share out the column beside the map: fleet, alarms, queue (0 if it is below the map), the robot's page
    (0 for none). Below each is a blank line, unless robots or the page need it."""
    queue_lines = 0 if is_queue_below else wanted.queue
    # A short page of the robot is worth more than blanks.
    is_short = SHORT_PAGE <= lines - wanted.fleet - wanted.alarms - queue_lines < LEAST_PAGE + len(wanted)
    blank = int(sum(wanted) + len(wanted) <= lines and not is_short)
    alarms = _share(wanted.alarms + blank, lines // 3, LEAST_LIST - 1 + blank)
    queue = 0 if is_queue_below else _share(wanted.queue + blank, lines // 4, LEAST_LIST - 1 + blank)
    fleet = max(LEAST_FLEET, min(wanted.fleet + (not is_short), lines - alarms - queue))
    left = max(0, lines - fleet - alarms - queue)
    page = left if left >= (SHORT_PAGE if is_short else LEAST_PAGE) else 0
    if is_queue_below:
        return fleet, alarms + left - page, 0, page
    return fleet, alarms, queue + left - page, page


def width_of_map(width: int, lines: int, shape: float, tables: int = LEAST_TABLES) -> int:
    """Return the cells of a wide screen's map: more than its share where its floor is then drawn larger, less
    where that leaves the `tables` their cells. `shape`: lines of the floor per cell of its width."""
    share = round(width * WIDE_SHARE)
    if tables > LEAST_TABLES:
        return min(share, max(width // 2, width - tables))
    wanted = round((lines - 2) / shape) + 2 if shape > 0 else share
    return max(share, min(wanted, width - tables))


def below_page(lines: int, page: int, width: int) -> int:
    """Return the lines for small maps of other floors in the place of a robot's page, `page` of `lines` lines
    and `width` cells (0 for none). In steps: they rarely change while other panes grow."""
    if width < LEAST_COLUMN:
        return 0
    sizes = (*range(lines // 2, LEAST_MAP, -STEP), LEAST_MAP)
    fitting = (size for kept in WHOLE_PAGES for size in sizes if page - size >= kept)
    return next(fitting, 0)


def is_beside_events(left: int, width: int, lines: int, fleet: int, column: int) -> bool:
    """Tell whether small maps are larger beside the last events, in `left` lines below a map of `width`
    cells, than below the robot's page in a `column` of so many cells and `lines` lines. Apart from alarms
    and orders, which come and go: the maps stay in their place."""
    *_, page = beside_map(lines, Wanted(fleet, 0, 0))
    return width >= LEAST_SHARED and left > below_page(lines, page, column)


def below_floor(lines: int, floor: int, is_narrow: bool = False) -> int:
    """Return the lines for the last events below a map whose fitted floor takes `floor` lines (0 for none).
    On a narrow screen few are better than a blank; what they and the queue need not may stretch the floor."""
    if is_narrow:
        floor = max(floor + 1, min(round(floor * MOST_TALL), lines - BELOW_NARROW))
    left = lines - max(floor, LEAST_MAP)
    return left if left >= (LEAST_EVENTS if is_narrow else LEAST_PAGE) else 0


def below_narrow_floor(left: int, queue: int) -> tuple[int, int]:
    """Share out the lines that a floor beside the tables of a narrow screen leaves: the queue of orders, and
    above it the last events (0 for none)."""
    wanted = max(queue, LEAST_LIST - 1)
    return (wanted, left - wanted) if left - wanted >= LEAST_LIST - 1 else (left, 0)


def below_map(lines: int, wanted: Wanted, covered: int = 0) -> tuple[int, int, int]:
    """Share out a narrow screen: the map, the fleet, and the line of alarms and queue side by side. The map
    keeps clear of the `covered` last lines."""
    low = _share(max(wanted.alarms, wanted.queue), lines // 4)
    fleet = max(LEAST_FLEET, min(wanted.fleet, (lines - low) // 3, lines - low - LEAST_MAP))
    above = max(1, min(lines - low - fleet, lines - covered))
    return above, lines - low - above, low


def is_better_beside(width: int, lines: int, wanted: Wanted, shape: float) -> bool:
    """Tell whether a narrow screen shows a floor larger with the tables beside than below its map. `shape`:
    lines of the floor per cell of its width."""
    if width < LEAST_BESIDE or shape <= 0:
        return False
    below, _, _ = below_map(lines, wanted)
    return min(width * MAP_SHARE, (lines - 2) / shape) > min(width, (below - 2) / shape)


def below_buttons(lines: int, wanted: Wanted) -> tuple[int, int, int]:
    """Share out a narrow screen with the simple interface: its buttons, the fleet, alarms and queue."""
    low = _share(max(wanted.alarms, wanted.queue), min(lines // 4, lines - BUTTONS - LEAST_FLEET))
    above = max(1, min(BUTTONS, lines - low - LEAST_FLEET))
    fleet = max(LEAST_FLEET, min(wanted.fleet, lines - low - above))
    return above, fleet, lines - above - fleet


def without_map(lines: int, wanted: Wanted) -> tuple[int, int]:
    """Share out a screen too small for a map: fleet, alarms."""
    alarms = max(2, min(wanted.alarms, lines // 3))
    fleet = max(1, min(wanted.fleet, lines - alarms))
    return fleet, max(1, lines - fleet)


def simple_alone(lines: int) -> tuple[int, int]:
    """Share out a screen too small for a map with the simple interface: its buttons, alarms."""
    return max(1, lines - LEAST_LIST), LEAST_LIST


def _share(wanted: int, most: int, least: int = LEAST_LIST) -> int:
    return max(least, min(wanted, most))
