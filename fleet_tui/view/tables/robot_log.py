"""The log of the robots, newest last, filtered by level and text."""

from collections.abc import Callable

from fleet_tui.model.counters import snapshot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.ros_logs import LogLine, Severity
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.text.units import ago
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.links import Links, down
from fleet_tui.view.tables.table import LateRows, Row, Table, column

_LOOKS = {
    Severity.DEBUG: ("· DEBUG", StyleRole.DIM),
    Severity.INFO: ("  INFO ", StyleRole.TEXT),
    Severity.WARN: ("▲ WARN ", StyleRole.WARN),
    Severity.ERROR: ("✗ ERROR", StyleRole.ALARM),
    Severity.FATAL: ("✗ FATAL", StyleRole.ALARM),
}


def lines_of(links: Links) -> tuple[LogLine, ...]:
    """Return the log lines of all robots, in the order of arrival."""
    return tuple(
        sorted((line for _, counter in links for line in snapshot(counter.log)), key=lambda one: one.at)
    )


def wanted_lines(lines: tuple[LogLine, ...], least: Severity, wanted: str) -> list[LogLine]:
    """Return those of a level, and worse, that contain `wanted`. An unknown level passes."""
    sought = wanted.casefold()
    return [
        line
        for line in lines
        if (line.severity or Severity.FATAL) >= least and sought in f"{line.node} {line.text}".casefold()
    ]


def _wall(line: LogLine, offset: float) -> float:
    return line.stamp if line.stamp is not None else line.at + offset


def _row(line: LogLine, nodes: int, time: str) -> Row:
    word, role = _LOOKS[line.severity] if line.severity else (f"level {line.level}", StyleRole.WARN)
    runs = (
        (f"{time} ", StyleRole.DIM),
        (f"{word:<8}", role),
        (fit(line.node, nodes) + " ", StyleRole.DIM),
        (sanitize(line.text), StyleRole.ALARM if role is StyleRole.ALARM else StyleRole.TEXT),
    )
    return Row(id(line), runs)


def robot_log_table(
    lines: tuple[LogLine, ...],
    links: Links,
    state: FleetState,
    clock: Callable[[float], str],
    least: Severity,
    wanted: str,
) -> Table:
    """Return a row for each line. `clock` formats Unix seconds as the time of day: the line's own, or that of
    its arrival."""
    found = wanted_lines(lines, least, wanted)
    nodes = column((line.node for line in found), 4, 24)
    offset = state.wall - state.now
    rows = LateRows(
        [id(line) for line in found], lambda n: _row(found[n], nodes, clock(_wall(found[n], offset)))
    )
    note = f" /rosout  {len(found)} of {len(lines)} lines, {least.name}"
    note += "" if least is Severity.FATAL else " and worse"
    note += f", matching {sanitize(wanted)}" if wanted else ""
    note += f", last {ago(_wall(lines[-1], offset), state.wall)}" if lines else ""
    title = ("Robot log", StyleRole.TITLE), (note, StyleRole.DIM), *down(links)
    empty = (
        "no matching line" if lines else "nothing received on /rosout (subscribed while this screen is open)"
    )
    return Table(title, rows, empty)
