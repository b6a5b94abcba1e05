"""The pages of the history as tables: each row is a moment or a robot."""

from collections.abc import Callable, Hashable, Sequence
from itertools import groupby
from operator import attrgetter

from fleet_tui.features.history.events import EventKind, PastEvent
from fleet_tui.features.history.shift import ShownShift
from fleet_tui.model.history.lives import AlarmLife
from fleet_tui.model.history.totals import ChargeTotal
from fleet_tui.records.history.division import Division
from fleet_tui.situation.battery.forecast import BatteryForecast
from fleet_tui.situation.battery.history import BatterySample
from fleet_tui.text.language import N_, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.bars import bars_of, legend_of, level
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import Column
from fleet_tui.ui.view.tables.table import Run, Table

Clock = Callable[[float], str]

NAMES = 18
"""Cells of a name at most."""
HELD = "█", "#"


def events_table(shown: ShownShift, clock: Clock, arrangement: RowArrangement | None = None) -> Table:
    """Return the events, the newest first; the key of a row is the event."""

    def told(event: PastEvent) -> Run:
        role = StyleRole.ALARM if event.is_trouble else StyleRole.TEXT
        return event.text, StyleRole.ACCENT if event.kind is EventKind.NOTE else role

    columns: Sequence[Column[PastEvent]] = (
        Column(
            N_("time"),
            lambda event: (f"{clock(event.told_at)} ", StyleRole.DIM),
            (1, 16),
            "",
            is_apart=True,
            stays=True,
        ),
        Column(N_("event"), told, None, ""),
        Column(N_("robot"), text=attrgetter("subject"), sorts=True),
        Column(N_("kind"), text=lambda event: event.kind.value, sorts=True),
    )
    title = _title(tr("Events"), f"{len(shown.events):,}")
    empty = _empty(shown, tr("nothing happened in this time"))
    return table_of(
        title, columns, shown.events[::-1], lambda event: event, arrangement=arrangement, empty=empty
    )


def robots_table(
    shown: ShownShift, clock: Clock, is_ascii: bool, arrangement: RowArrangement | None = None
) -> Table:
    """Return a bar for each robot; the key of a row is its name."""
    names = list(shown.timeline)
    columns: Sequence[Column[str]] = (
        _NAME,
        Column(
            "", lambda name: list(bars_of(shown.timeline[name], is_ascii)), None, _times(shown.time, clock)
        ),
    )
    legend = legend_of((shown.timeline[name] for name in names), is_ascii)
    title = (*_title(tr("Robots"), str(len(names))), *legend)
    empty = _empty(shown, tr("no robot was seen in this time"))
    return table_of(title, columns, names, str, arrangement=arrangement, empty=empty)


def batteries_table(
    shown: ShownShift, clock: Clock, is_ascii: bool, low: float, arrangement: RowArrangement | None = None
) -> Table:
    """Return a small curve for each robot; the key of a row is its name; `low` is the limit in per cent."""

    def curve(name: str) -> list[Run]:
        lasts = f" {_lasts(shown.forecasts.get(name))}", StyleRole.DIM
        return [(_curve(shown.charges[name], shown.time.parts, is_ascii), StyleRole.ACCENT), lasts]

    names = list(shown.charges)
    columns: Sequence[Column[str]] = (
        _NAME,
        Column(
            N_("battery"),
            lambda name: _levels(shown.charges[name], low, is_ascii),
            LEVEL_CELLS - 1,
            "",
            order=lambda name: shown.charges[name][-1].last,
            is_apart=True,
        ),
        Column("", curve, None, _times(shown.time, clock)),
    )
    title = _title(tr("Batteries"), str(len(names)))
    empty = _empty(shown, tr("no battery was seen in this time"))
    return table_of(title, columns, names, str, arrangement=arrangement, empty=empty)


_NAME: Column[str] = Column(N_("robot"), lambda name: name, (1, NAMES), "", sorts=True, stays=True)
LEVEL_CELLS = 12


def alarms_table(
    shown: ShownShift, clock: Clock, is_ascii: bool, arrangement: RowArrangement | None = None
) -> Table:
    """Return a line of time for each alarm, those that held longest first; the key of a row is its last
    life."""

    def name(lives: list[AlarmLife]) -> Run:
        return f"{translate(lives[0].kind)} {lives[0].source}", StyleRole.TEXT

    def often(lives: list[AlarmLife]) -> Run:
        count = _count(lives)
        return tr("once") if count == 1 else tr("{count} times", count=count), StyleRole.DIM

    def total(lives: list[AlarmLife]) -> float:
        return sum(_held(life, shown.time) for life in lives)

    alarms = sorted(_by_alarm(shown), key=total, reverse=True)
    columns: Sequence[Column[list[AlarmLife]]] = (
        Column(N_("alarm"), name, (1, 2 * NAMES), "", order=lambda lives: lives[0].kind, stays=True),
        Column(N_("count"), often, 9, "", order=lambda lives: -_count(lives), is_apart=True),
        Column("", lambda lives: (age(total(lives)), StyleRole.DIM), 7, "", is_apart=True),
        Column("", lambda lives: _held_cells(lives, shown.time, is_ascii), None, _times(shown.time, clock)),
        Column(N_("robot"), text=lambda lives: lives[0].source, sorts=True),
        Column(N_("text"), text=lambda lives: lives[0].text),
    )
    title, empty = _title(tr("Alarms"), str(len(alarms))), _empty(shown, tr("no alarm in this time"))
    return table_of(title, columns, alarms, lambda lives: lives[-1], arrangement=arrangement, empty=empty)


def _count(lives: Sequence[AlarmLife]) -> int:
    return sum(life.count for life in lives)


def curve_of(charges: Sequence[ChargeTotal], time: Division) -> list[BatterySample]:
    """Return the levels as samples, in Unix seconds, with gaps where nobody watched."""
    before = -2
    samples = []
    for one in charges:
        samples.append(
            BatterySample(time.since + (one.part + 0.5) * time.step, one.last, one.part == before + 1)
        )
        before = one.part
    return samples


def moment_of(key: Hashable) -> tuple[str, float] | None:
    """Return whom a row is about, and when it was, None if it is about no moment."""
    match key:
        case PastEvent():
            return key.subject, key.told_at
        case AlarmLife():
            return key.source, key.raised
    return None


def _title(name: str, count: str) -> tuple[Run, ...]:
    return ((name, StyleRole.TITLE), (f" {count}", StyleRole.DIM))


def _empty(shown: ShownShift, nothing: str) -> str:
    return translate(sanitize(shown.problem)) or nothing


def _times(time: Division, clock: Clock) -> str:
    """Return local times above the cells of a picture, a few of them."""
    text = ""
    for part in range(0, time.parts - 10, max(12, time.parts // 6)):
        text = text.ljust(part) + clock(time.since + part * time.step)
    return text


def _levels(charges: Sequence[ChargeTotal], low: float, is_ascii: bool) -> list[Run]:
    last, lowest = charges[-1].last, min(one.low for one in charges)
    role = StyleRole.ALARM if lowest < low else StyleRole.DIM
    mark = ("v" if is_ascii else "▾") if lowest < low else " "
    return [(f"{last:4.0f}% ", StyleRole.TEXT), (f"{mark}{lowest:3.0f}%", role)]


def _curve(charges: Sequence[ChargeTotal], parts: int, is_ascii: bool) -> str:
    cells = [" "] * parts
    for one in charges:
        cells[one.part] = level(one.last / 100.0, is_ascii)
    return "".join(cells)


def _lasts(guess: BatteryForecast | None) -> str:
    return "" if guess is None else tr("empty in {age}", age=age(guess.empty_in))


def _by_alarm(shown: ShownShift) -> list[list[AlarmLife]]:
    found: dict[tuple[str, str], list[AlarmLife]] = {}
    for life in shown.alarms:
        found.setdefault((life.source, life.kind), []).append(life)
    return list(found.values())


def _span(life: AlarmLife, time: Division) -> tuple[float, float]:
    over = life.returned if life.returned is not None else life.ended
    return max(life.raised, time.since), min(time.until if over is None else over, time.until)


def _held(life: AlarmLife, time: Division) -> float:
    began, ended = _span(life, time)
    return max(0.0, ended - began)


def _held_cells(lives: Sequence[AlarmLife], time: Division, is_ascii: bool) -> list[Run]:
    cells = [False] * time.parts
    for life in lives:
        began, ended = _span(life, time)
        for part in range(time.part(began), time.part(ended) + 1):
            cells[part] = True
    held, free = (HELD[1], ".") if is_ascii else (HELD[0], "·")
    return [
        ((held if is_held else free) * len(list(same)), StyleRole.ALARM if is_held else StyleRole.DIM)
        for is_held, same in groupby(cells)
    ]
