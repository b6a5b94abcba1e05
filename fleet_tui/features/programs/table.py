"""Rows of the programs, and the lines of a log."""

from collections.abc import Callable, Sequence
from operator import itemgetter

from fleet_tui.model.programs.program import ProgramRow, ProgramState
from fleet_tui.text.language import N_, Message, counted, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.table import Row, Run, Table

HERE = Message("here")
NONE_CONFIGURED = (
    Message("No program is configured. In the configuration file, for example:"),
    "",
    "  [[programs]]",
    '  name = "bridge"',
    '  unit = "rosbridge.service"',
    "",
    "  [[programs]]",
    '  name = "mapping"',
    '  start = ["roslaunch", "hall", "mapping.launch"]',
    "",
    Message("fleet-tui docs programs has the other keys."),
)
_LOOKS = {
    ProgramState.RUNNING: ("● ", StyleRole.GOOD),
    ProgramState.STARTING: ("◇ ", StyleRole.WARN),
    ProgramState.STOPPING: ("◇ ", StyleRole.WARN),
    ProgramState.STOPPED: ("○ ", StyleRole.DIM),
    ProgramState.FAILED: ("✗ ", StyleRole.ALARM),
    ProgramState.UNKNOWN: ("? ", StyleRole.WARN),
}


def program_table(
    rows: Sequence[ProgramRow],
    clock: Callable[[float], str],
    now: float,
    width: int = UNBOUNDED,
    arrangement: RowArrangement | None = None,
) -> Table:
    """Return a row for each program, in the order of the configuration. `clock` formats Unix seconds, `now`
    is of the monotonic clock."""
    if not rows:
        told = [translate(line) if isinstance(line, Message) else line for line in NONE_CONFIGURED]
        help_rows = [Row(n, ((line, StyleRole.TEXT),)) for n, line in enumerate(told)]
        return Table(((tr("Programs"), StyleRole.TITLE),), help_rows)
    title = ((tr("Programs"), StyleRole.TITLE), (tr("  Enter: start, stop, restart, log"), StyleRole.DIM))
    columns = _columns(clock, now)
    return table_of(title, columns, rows, lambda row: row.name, width, arrangement=arrangement)


def _columns(clock: Callable[[float], str], now: float) -> Sequence[Column[ProgramRow]]:
    def state(row: ProgramRow) -> Run:
        sign, role = _LOOKS[row.state(now)]
        return f"{sign}{tr(row.state(now).value)}", role

    def since(row: ProgramRow) -> Run:
        status = row.known(now)
        return clock(status.since) if status and status.since else "-", StyleRole.TEXT

    def restarts(row: ProgramRow) -> Run:
        count = status.restarts if (status := row.known(now)) else None
        return "-" if count is None else str(count), StyleRole.WARN if count else StyleRole.DIM

    def told(row: ProgramRow) -> Run:
        is_failed = row.state(now) is ProgramState.FAILED
        return translate(note(row, now)), StyleRole.ALARM if is_failed else StyleRole.TEXT

    return (
        Column(N_("program"), lambda row: row.name, (7, 16), sorts=True, stays=True),
        Column(N_("host"), lambda row: (row.host or translate(HERE), StyleRole.DIM), (4, 12)),
        Column(N_("state"), state, 10, order=lambda row: row.state(now).value),
        Column(N_("since"), since, 11),
        Column(N_("restarts"), restarts, 8, is_right=True),
        Column(N_("note"), told),
    )


def note(row: ProgramRow, now: float) -> Message:
    """Return what is under way, the reason of a failure, and of an unknown state what was known last."""
    if row.pending:
        return Message("{pending} is under way ...", pending=row.pending)
    if row.status is None:
        return Message("looking ...")
    if row.state(now) is not ProgramState.UNKNOWN:
        return sanitize(row.status.detail)
    known = row.last_known
    is_late = row.status.state is not ProgramState.UNKNOWN
    why = (
        Message("no answer for {age}", age=age(now - row.status.at))
        if is_late
        else sanitize(row.status.detail)
    )
    if known is None:
        return why
    was = Message(known.state.value)
    return Message("{was} {age} ago; {why}", was=was, age=age(now - known.at), why=why)


_LINE: Sequence[Column[tuple[int, str]]] = (Column(N_("line"), lambda line: line[1], None, ""),)


def log_table(
    name: str, lines: Sequence[tuple[int, str]], note: Message, arrangement: RowArrangement | None = None
) -> Table:
    """Return the lines of a program's log, newest last; each has its number as key."""
    count = translate(counted(" {count} line", " {count} lines", len(lines)))
    title: list[Run] = [(tr("Log of {name}", name=sanitize(name)), StyleRole.TITLE), (count, StyleRole.DIM)]
    if note:
        title.append((f"  {translate(sanitize(note))}", StyleRole.WARN))
    empty = translate(sanitize(note)) or tr("no line yet")
    key = itemgetter(0)
    return table_of(title, _LINE, lines, key, arrangement=arrangement, empty=empty, is_followed=True)
