"""Rows of the routines, each with a row for every robot of its last run, and of a text about one."""

from collections.abc import Callable, Iterator, Sequence

from fleet_tui.model.routines.lane import Lane
from fleet_tui.model.routines.row import RoutineRow
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.routines.lines import (
    HELD,
    NEVER,
    PAUSED,
    RUNNING,
    WAITING,
    lane_text,
    lane_word,
    row_word,
)
from fleet_tui.view.tables.table import Row, Run, Table, column

NONE_THERE = (
    Message("Write one there, for example morning.routine:"),
    "",
    "  for robot_0 robot_1",
    "    carry Base Store",
    "    wait until idle",
    "  end",
    "",
    Message("fleet-tui docs routines has the other instructions."),
)
_LOOKS = {
    RUNNING: ("● ", StyleRole.GOOD),
    WAITING: ("◇ ", StyleRole.GOOD),
    PAUSED: ("◇ ", StyleRole.WARN),
    HELD: ("△ ", StyleRole.WARN),
    "failed": ("✗ ", StyleRole.ALARM),
    NEVER: ("○ ", StyleRole.DIM),
    "done": ("○ ", StyleRole.TEXT),
    "stopped": ("○ ", StyleRole.DIM),
}


def routine_table(rows: Sequence[RoutineRow], folder: str, clock: Callable[[float], str]) -> Table:
    """Return the routines; the key of a row is the name, or the name and the robot. `clock` formats Unix
    seconds."""
    title = ((tr("Routines"), StyleRole.TITLE), (tr("  Enter: start, pause, resume, stop"), StyleRole.DIM))
    if not rows:
        text = (tr("No routine in {folder}.", folder=sanitize(folder)), *NONE_THERE)
        return Table(
            ((tr("Routines"), StyleRole.TITLE),),
            [
                Row(
                    n,
                    (
                        (
                            line
                            if line.startswith(" ")
                            else translate(line)
                            if isinstance(line, Message)
                            else line,
                            StyleRole.TEXT,
                        ),
                    ),
                )
                for n, line in enumerate(text)
            ],
        )
    names = column((name for row in rows for name in (row.name, *(f"  {one}" for one in row.plans))), 7, 18)
    widths = ((tr("routine"), names), (tr("state"), 11), (tr("since"), 11))
    head = " ".join([*(fit(word, cells) for word, cells in widths), tr("instruction")])
    shown = [one for row in rows for one in _rows(row, names, clock)]
    return Table(title, shown, head=((head, StyleRole.DIM),))


def _rows(row: RoutineRow, names: int, clock: Callable[[float], str]) -> Iterator[Row]:
    times = ", ".join(tr("every {time}", time=time) for time in row.times)
    by = (
        tr("run by {owner}", owner=translate(row.owner))
        if row.owner and not any(lane.is_over for lane in row.lanes)
        else ""
    )
    note = "; ".join(sanitize(part) for part in (by, times) if part)
    role = StyleRole.ALARM if row.problem else StyleRole.DIM
    since = clock(row.at) if row.lanes else "-"
    yield Row(
        row.name, _runs(row.name, names, row_word(row), since, translate(sanitize(row.problem)) or note, role)
    )
    if not all(lane.is_over for lane in row.lanes):
        for lane in row.lanes:
            yield Row((row.name, lane.robot), _lane(row, lane, names, clock))


def _lane(row: RoutineRow, lane: Lane, names: int, clock: Callable[[float], str]) -> tuple[Run, ...]:
    word = HELD if row.is_left and not lane.is_over else lane_word(lane)
    text = lane_text(row.plans[lane.robot], lane)
    return _runs(f"  {lane.robot}", names, word, clock(lane.since), text, StyleRole.TEXT)


def _runs(name: str, names: int, word: Message, since: str, note: str, role: StyleRole) -> tuple[Run, ...]:
    sign, look = _LOOKS[word]
    return (
        (fit(name, names) + " ", StyleRole.TEXT),
        (fit(f"{sign}{translate(word)}", 11) + " ", look),
        (fit(since, 11) + " ", StyleRole.DIM),
        (note, role),
    )


def text_table(title: Message, lines: Sequence[str]) -> Table:
    """Return the lines of a text about a routine."""
    shown = [Row(n, ((sanitize(line), StyleRole.TEXT),)) for n, line in enumerate(lines)]
    return Table(((translate(sanitize(title)), StyleRole.TITLE), (tr("  Esc: back"), StyleRole.DIM)), shown)
