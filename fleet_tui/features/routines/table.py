"""Rows of the routines, each with a row for every robot of its last run, and of a text about one."""

from collections.abc import Callable, Hashable, Sequence
from operator import attrgetter, itemgetter
from typing import NamedTuple

from fleet_tui.features.routines.lane import Lane
from fleet_tui.features.routines.lines import (
    HELD,
    NEVER,
    PAUSED,
    RUNNING,
    WAITING,
    lane_text,
    lane_word,
    row_word,
)
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.text.language import N_, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.table import Run, Table, column

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


class ShownLane(NamedTuple):
    """A row: a routine, or one robot of it."""

    routine: RoutineRow
    lane: Lane | None = None

    @property
    def key(self) -> Hashable:
        return self.routine.name if self.lane is None else (self.routine.name, self.lane.robot)

    @property
    def word(self) -> Message:
        if self.lane is None:
            return row_word(self.routine)
        return HELD if self.routine.is_left and not self.lane.is_over else lane_word(self.lane)


def routine_table(
    rows: Sequence[RoutineRow],
    folder: str,
    clock: Callable[[float], str],
    width: int = UNBOUNDED,
    arrangement: RowArrangement | None = None,
) -> Table:
    """Return the routines; the key of a row is the name, or the name and the robot. `clock` formats Unix
    seconds."""
    if not rows:
        told = [translate(line) if isinstance(line, Message) else line for line in NONE_THERE]
        where = tr("No routine in {folder}.", folder=sanitize(folder))
        return text_table(Message("Routines"), [where, *told], "")
    title = ((tr("Routines"), StyleRole.TITLE), (tr("  Enter: start, pause, resume, stop"), StyleRole.DIM))
    entries: list[ShownLane] = []
    for row in rows:
        entries.append(ShownLane(row))
        if not all(lane.is_over for lane in row.lanes):
            entries += (ShownLane(row, lane) for lane in row.lanes)
    # Of robots that wait for their turn, too: the column must not change.
    names = column((name for row in rows for name in (row.name, *(f"  {one}" for one in row.plans))), 7, 18)
    return table_of(title, _columns(names, clock), entries, attrgetter("key"), width, arrangement=arrangement)


def _columns(names: int, clock: Callable[[float], str]) -> Sequence[Column[ShownLane]]:
    def name(one: ShownLane) -> Run:
        return one.routine.name if one.lane is None else f"  {one.lane.robot}", StyleRole.TEXT

    def state(one: ShownLane) -> Run:
        sign, role = _LOOKS[one.word]
        return f"{sign}{translate(one.word)}", role

    def since(one: ShownLane) -> Run:
        if one.lane is not None:
            return clock(one.lane.since), StyleRole.DIM
        return clock(one.routine.at) if one.routine.lanes else "-", StyleRole.DIM

    return (
        Column(
            N_("routine"),
            name,
            names,
            text=lambda one: f"{one.routine.name} {one.lane.robot if one.lane else ''}",
            sorts=True,
            stays=True,
        ),
        Column(N_("state"), state, 11),
        Column(N_("since"), since, 11, is_apart=True),
        Column(N_("instruction"), _instruction),
    )


def _instruction(one: ShownLane) -> Run:
    row = one.routine
    if one.lane is not None:
        return lane_text(row.plans[one.lane.robot], one.lane), StyleRole.TEXT
    if row.problem:
        return translate(sanitize(row.problem)), StyleRole.ALARM
    is_led = row.owner and not any(lane.is_over for lane in row.lanes)
    by = tr("run by {owner}", owner=translate(row.owner)) if is_led else ""
    times = ", ".join(tr("every {time}", time=time) for time in row.times)
    return "; ".join(sanitize(part) for part in (by, times) if part), StyleRole.DIM


_LINE: Sequence[Column[tuple[int, str]]] = (Column(N_("line"), lambda line: line[1], None, ""),)


def text_table(
    title: Message, lines: Sequence[str], note: str | None = None, arrangement: RowArrangement | None = None
) -> Table:
    """Return the lines of a text about a routine; `note` is beside the title, by default how to leave it."""
    beside = tr("  Esc: back") if note is None else note
    runs = (translate(sanitize(title)), StyleRole.TITLE), (beside, StyleRole.DIM)
    entries = tuple(enumerate(lines))
    return table_of(runs, _LINE, entries, itemgetter(0), arrangement=arrangement)
