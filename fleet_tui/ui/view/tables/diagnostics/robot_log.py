"""The log of the robots, newest last, filtered by level and text."""

from collections.abc import Callable, Collection, Hashable, Iterator, Sequence

from fleet_tui.model.counters import snapshot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.ros_logs import LogLine, Severity
from fleet_tui.text.language import N_, Message, counted, tr, translate
from fleet_tui.text.sanitize import cell_width, folded, sanitize
from fleet_tui.text.units import ago
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.diagnostics.links import Links, down
from fleet_tui.ui.view.tables.table import Row, Run, Table

_LOOKS = {
    Severity.DEBUG: ("· DEBUG", StyleRole.DIM),
    Severity.INFO: ("  INFO ", StyleRole.TEXT),
    Severity.WARN: ("▲ WARN ", StyleRole.WARN),
    Severity.ERROR: ("✗ ERROR", StyleRole.ALARM),
    Severity.FATAL: ("✗ FATAL", StyleRole.ALARM),
}

NOTHING = Message("nothing received on /rosout (subscribed while this screen is open)")
CLIENTS = "[Client "
"""Begin of what rosbridge says of its clients, this console among them: many lines that no robot said."""
INDENT = 4
"""Cells before the lines of a whole message."""


def lines_of(links: Links) -> tuple[LogLine, ...]:
    """Return the log lines of all robots, in the order of arrival."""
    return tuple(
        sorted((line for _, counter in links for line in snapshot(counter.log)), key=lambda one: one.at)
    )


def _wall(line: LogLine, offset: float) -> float:
    return line.stamp if line.stamp is not None else line.at + offset


def _level(line: LogLine) -> Run:
    if line.severity:
        return _LOOKS[line.severity]
    return tr("level {level}", level=line.level), StyleRole.WARN


def _is_of_clients(line: LogLine) -> bool:
    return line.text.startswith(CLIENTS) and (line.severity or Severity.FATAL) <= Severity.INFO


def robot_log_table(
    lines: tuple[LogLine, ...],
    links: Links,
    state: FleetState,
    clock: Callable[[float], str],
    least: Severity,
    opened: Collection[Hashable] = (),
    width: int = UNBOUNDED,
    arrangement: RowArrangement | None = None,
) -> Table:
    """Return a row for each line of at least this level (an unknown one passes), and below those `opened`
    their whole messages, wrapped to `width` cells. `clock` formats Unix seconds as the time of day: the
    line's own, or that of its arrival."""
    found = [line for line in lines if (line.severity or Severity.FATAL) >= least]
    offset = state.wall - state.now
    *earlier, last = [id(line) for line in found if _is_of_clients(line)] or [0]
    hidden = frozenset(() if arrangement is not None and arrangement.typed else earlier)
    shown = [line for line in found if id(line) not in hidden]

    def text(line: LogLine) -> Run:
        role = StyleRole.ALARM if _level(line)[1] is StyleRole.ALARM else StyleRole.TEXT
        if not hidden or id(line) != last:
            return line.text, role
        more = counted("{count} more line", "{count} more lines", len(hidden))
        return tr("{text} (and {more} of the bridge about its clients)", text=line.text, more=more), role

    def whole(line: LogLine) -> Iterator[Row]:
        if id(line) not in opened:
            return
        parts = [sanitize(part) for part in line.text.splitlines()]
        folded_parts = [row for part in parts for row in folded(part, width - INDENT, width - INDENT)]
        for n, row in enumerate(folded_parts):
            indented = (" " * INDENT + row, StyleRole.TEXT)
            yield Row((id(line), n), (indented,), whole="\n".join(parts))

    time = cell_width(clock(state.wall))
    columns: Sequence[Column[LogLine]] = (
        Column(
            N_("time"),
            lambda line: (clock(_wall(line, offset)), StyleRole.DIM),
            time,
            "",
            is_apart=True,
            stays=True,
        ),
        Column(
            N_("level"),
            _level,
            (7, 10),
            "",
            order=lambda line: -(line.severity or Severity.FATAL),
            is_apart=True,
        ),
        Column(N_("node"), lambda line: (line.node, StyleRole.DIM), (4, 24), "", sorts=True),
        Column(N_("text"), text, None, ""),
    )
    note = least.name if least is Severity.FATAL else least.name + tr(" and worse")
    if lines:
        note += tr(", last {ago}", ago=translate(ago(_wall(lines[-1], offset), state.wall)))
    counts = tr(" /rosout  {count} of {lines} lines, {note}", count=len(found), lines=len(lines), note=note)
    title = (tr("Robot log"), StyleRole.TITLE), (counts, StyleRole.DIM), *down(links)
    empty = tr("no matching line") if lines else translate(NOTHING)
    return table_of(
        title, columns, shown, id, width, arrangement=arrangement, below=whole, empty=empty, is_followed=True
    )
