"""Rows of the programs, and the lines of a log."""

from collections.abc import Callable, Sequence

from fleet_tui.model.programs.program import ProgramRow, ProgramState
from fleet_tui.text.language import N_, Message, tr, translate
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.text.units import age
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import LateRows, Row, Run, Table, column

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


def program_table(rows: Sequence[ProgramRow], clock: Callable[[float], str], now: float) -> Table:
    """Return a row for each program, in the order of the configuration. `clock` formats Unix seconds, `now`
    is of the monotonic clock."""
    title = ((tr("Programs"), StyleRole.TITLE), (tr("  Enter: start, stop, restart, log"), StyleRole.DIM))
    if not rows:
        told = [translate(line) if isinstance(line, Message) else line for line in NONE_CONFIGURED]
        help_rows = [Row(n, ((line, StyleRole.TEXT),)) for n, line in enumerate(told)]
        return Table(((tr("Programs"), StyleRole.TITLE),), help_rows)
    names = column((row.name for row in rows), 7, 16)
    hosts = column((row.host or translate(HERE) for row in rows), 4, 12)
    heads = ((N_("program"), names), (N_("host"), hosts), (N_("state"), 10), (N_("since"), 11))
    head = " ".join(
        (
            *(fit(tr(word), cells) for word, cells in heads),
            fit(tr("restarts"), 8, right=True) + "  " + tr("note"),
        )
    )
    shown = [Row(row.name, _runs(row, names, hosts, clock, now)) for row in rows]
    return Table(title, shown, head=((head, StyleRole.DIM),))


def _runs(
    row: ProgramRow, names: int, hosts: int, clock: Callable[[float], str], now: float
) -> tuple[Run, ...]:
    state, status = row.state(now), row.status
    sign, role = _LOOKS[state]
    is_known = status is not None and state is not ProgramState.UNKNOWN
    since = clock(status.since) if is_known and status is not None and status.since else "-"
    restarts = status.restarts if is_known and status is not None else None
    return (
        (fit(row.name, names) + " ", StyleRole.TEXT),
        (fit(row.host or translate(HERE), hosts) + " ", StyleRole.DIM),
        (f"{sign}{tr(state.value):<8} ", role),
        (f"{fit(since, 11)} ", StyleRole.TEXT),
        (f"{'-' if restarts is None else restarts:>8}  ", StyleRole.WARN if restarts else StyleRole.DIM),
        (translate(note(row, now)), StyleRole.ALARM if state is ProgramState.FAILED else StyleRole.TEXT),
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


def log_table(name: str, found: Sequence[tuple[int, str]], total: int, wanted: str, note: Message) -> Table:
    """Return the lines of a program's log, newest last; each has its number as key."""

    def row(n: int) -> Row:
        number, text = found[n]
        return Row(number, ((sanitize(text), StyleRole.TEXT),))

    counted = tr(" {count} of {total} lines", count=len(found), total=total) + (
        tr(", matching {text}", text=sanitize(wanted)) if wanted else ""
    )
    title: list[Run] = [(tr("Log of {name}", name=sanitize(name)), StyleRole.TITLE), (counted, StyleRole.DIM)]
    if note:
        title.append((f"  {translate(sanitize(note))}", StyleRole.WARN))
    empty = tr("no matching line") if total else translate(sanitize(note)) or tr("no line yet")
    return Table(tuple(title), LateRows([number for number, _ in found], row), empty)
