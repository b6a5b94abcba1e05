"""The routines: a list with the progress of each robot, and a text about one of them."""

import time
from collections.abc import Callable, Hashable, Sequence
from operator import attrgetter, itemgetter
from typing import ClassVar, NamedTuple

from textual.binding import BindingType

from fleet_tui.config.log_file import state_folder
from fleet_tui.features.routines.folder import RoutinePlace
from fleet_tui.features.routines.lane import Lane
from fleet_tui.features.routines.led import LedRoutines
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
from fleet_tui.features.routines.requests import RoutineRequests
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.text.language import EMPTY, N_, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.local_time import since_text
from fleet_tui.ui.screens.overlay import ReturningOverlay
from fleet_tui.ui.screens.tables.paged_overlay import TableOverlay
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.table import Run, Table, column
from fleet_tui.ui.widgets.bindings import overlay_bindings

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


EVERY = 0.25
"""Seconds between two ticks of the routines."""
LOOK_EVERY = 2.0
"""Seconds between two looks at the files."""


class Routines(ReturningOverlay, TableOverlay):
    """One table: the routines, or the lines of a text about one. What runs here goes on while it is
    closed."""

    BINDINGS: ClassVar[list[BindingType]] = [("escape,q", "back", "Back"), *overlay_bindings("routines")]

    def __init__(self, console: Console) -> None:
        super().__init__("routines", self._choose, EVERY, console.notices.say)
        settings = console.settings
        self._place = RoutinePlace(settings.routines, state_folder() / "routines", settings.doubt)
        self._led = LedRoutines(self._place, console)
        self._requests = RoutineRequests(self._place, console, self._led)
        self._ask = console.ask
        self._text: tuple[Message, Sequence[str]] = EMPTY, ()
        self._looked = 0.0

    def show(self) -> None:
        """Open on the list."""
        self.leave_page()
        self._looked = 0.0
        self._requests.tick()
        self.begin(self.rows)

    def show_text(self, title: Message, lines: Sequence[str]) -> None:
        """Show a text in the place of the list."""
        self._text = title, lines
        self.open(self.rows)
        self.enter_page()
        self.look()

    def _choose(self, key: Hashable) -> None:
        match key:
            case str():
                self._requests.menu(key, "", self.show_text)
            case (str() as name, str() as robot):
                self._requests.menu(name, robot, self.show_text)

    def tick(self) -> None:
        """What runs goes on while it is closed."""
        self._requests.tick()
        super().tick()

    def tick_closed(self) -> bool:
        return True

    def look(self) -> None:
        """Show the current rows."""
        if time.monotonic() - self._looked > LOOK_EVERY:
            self._looked = time.monotonic()
            self._requests.look()
        if self.is_on_page:
            table = text_table(*self._text, arrangement=self.rows.arrangement)
        else:
            shown = self._requests.rows, str(self._place.folder), since_text
            table = routine_table(*shown, self.rows.row_width, self.rows.arrangement)
        self.rows.show(table)
        cursor = self.rows.listing.cursor
        marked = next((row for row in table.rows if row.key == cursor), None)
        self.note(marked.runs[-1][0] if marked is not None else "")

    @property
    def has_losses(self) -> bool:
        """Tell whether a routine runs here, which would not go on without this console."""
        return bool(self._led.losses)

    def quit(self) -> None:
        """Leave the program, after a question if a routine runs here."""
        if self._led.losses:
            self._ask(lambda: self._led.losses, self.app.exit)
        else:
            self.app.exit()

    def on_unmount(self) -> None:
        """Leave what runs here."""
        self._led.close()
