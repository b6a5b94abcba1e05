"""The console's own page: the cost of its pictures, its use of the machine, and its own log."""

from collections.abc import Iterator, Sequence
from operator import itemgetter

from msgspec import Struct

from fleet_tui.text.language import N_, tr
from fleet_tui.text.units import milliseconds, size_text
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column, FittedColumns, rows_of
from fleet_tui.ui.view.tables.table import Row, Table

Spread = tuple[float, float, float]
"""Median, 95th percentile and maximum, in seconds."""
Fact = tuple[str, str, StyleRole]
"""Its name, what is shown of it, and how."""


class OwnFacts(Struct, frozen=True):
    """`tick` and `paint` are the times of the last hundred: making the picture, and encoding its changes;
    `budget` are the seconds between two ticks; `held` counts pictures held back because the terminal did
    not read; memory in bytes, None if unknown."""

    budget: float
    tick: Spread | None
    paint: Spread | None
    pictures: float
    sent: float
    held: int
    memory: int | None
    peak: int | None
    threads: int
    up: str


def _spread(spread: Spread | None) -> str:
    if spread is None:
        return tr("not measured yet")
    median, most, longest = map(milliseconds, spread)
    return tr("{median}, 95 % within {most}, max {longest}", median=median, most=most, longest=longest)


def _facts(facts: OwnFacts) -> Iterator[Fact]:
    over = facts.tick is not None and facts.tick[1] > facts.budget
    limit = milliseconds(facts.budget)
    budget = tr("  budget {limit} exceeded", limit=limit) if over else tr("  budget {limit}", limit=limit)
    yield N_("tick"), _spread(facts.tick) + budget, StyleRole.WARN if over else StyleRole.TEXT
    yield N_("encoding"), _spread(facts.paint), StyleRole.TEXT
    sent = tr(
        "{pictures} frames/s, {size_text}/s",
        pictures=f"{facts.pictures:.1f}",
        size_text=size_text(facts.sent),
    )
    held = tr(", none held back")
    if facts.held:
        held = tr(", {held} held back: terminal not reading", held=f"{facts.held:,}")
    yield N_("terminal"), sent + held, StyleRole.TEXT
    memory = tr("not available on this system")
    if facts.memory is not None and facts.peak is not None:
        memory = tr("{size}, peak {peak}", size=size_text(facts.memory), peak=size_text(facts.peak))
    yield N_("memory"), memory, StyleRole.TEXT
    yield (
        N_("process"),
        tr("{threads} threads, uptime {up}", threads=facts.threads, up=facts.up),
        StyleRole.TEXT,
    )


_FACTS: Sequence[Column[Fact]] = (
    Column("", lambda fact: (tr(fact[0]), StyleRole.DIM), (9, 12)),
    Column("", lambda fact: fact[1:], None),
)
_LOG: Sequence[Column[str]] = (Column(N_("line"), lambda line: (line, _role(line)), None, ""),)


def console_table(
    facts: OwnFacts, log: Sequence[str], width: int = UNBOUNDED, arrangement: RowArrangement | None = None
) -> Table:
    """Return the facts, then the log, newest first."""
    own = tuple(_facts(facts))
    above = rows_of(FittedColumns(_FACTS, own, width), own, itemgetter(0))
    note = tr("log, newest first: {count} lines", count=len(log))
    return table_of(
        ((tr("Console"), StyleRole.TITLE),),
        _LOG,
        log[::-1],
        id,
        width,
        arrangement=arrangement,
        above=[*above, Row("log", ((f"── {note}", StyleRole.DIM),))],
    )


def _role(line: str) -> StyleRole:
    if " ERROR " in line or " CRITICAL " in line:
        return StyleRole.ALARM
    return StyleRole.WARN if " WARNING " in line else StyleRole.TEXT
