"""The console on itself: what its pictures cost, what it takes of the machine, and its own log."""

from collections.abc import Iterator, Sequence

from msgspec import Struct

from fleet_tui.text.sanitize import visible
from fleet_tui.text.units import milliseconds, size_text
from fleet_tui.view.roles import Ink
from fleet_tui.view.tables.table import LateRows, Row, Table

Spread = tuple[float, float, float]
"""Median, the 95 % and the longest, in seconds."""


class OwnFacts(Struct, frozen=True):
    """`tick` and `paint` are what the last hundred took: making the picture, and turning what changed of
    it into bytes; `budget` are the seconds between two ticks;
    `held` counts pictures that were held back because the terminal did not read; memory in bytes,
    None where the system does not tell."""

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
        return "not measured yet"
    median, most, longest = map(milliseconds, spread)
    return f"{median}, 95 % within {most}, the longest {longest}"


def _facts(facts: OwnFacts) -> Iterator[tuple[str, str, Ink]]:
    over = facts.tick is not None and facts.tick[1] > facts.budget
    budget = f"  budget {milliseconds(facts.budget)}" + (" is exceeded" if over else "")
    yield "tick", _spread(facts.tick) + budget, Ink.WARN if over else Ink.TEXT
    yield "encoding", _spread(facts.paint), Ink.TEXT
    sent = f"{facts.pictures:.1f} pictures/s, {size_text(facts.sent)}/s"
    held = f", {facts.held:,} held back: it did not read" if facts.held else ", none held back"
    yield "terminal", sent + held, Ink.TEXT
    memory = "not told by this system"
    if facts.memory is not None and facts.peak is not None:
        memory = f"{size_text(facts.memory)}, at most {size_text(facts.peak)}"
    yield "memory", memory, Ink.TEXT
    yield "process", f"{facts.threads} threads, up for {facts.up}", Ink.TEXT


def console_table(facts: OwnFacts, log: Sequence[str], wanted: str) -> Table:
    """The facts, then the log, newest first, as far as `wanted` stands in a line."""
    above = [Row(name, ((f"{name:<10}", Ink.DIM), (text, ink))) for name, text, ink in _facts(facts)]
    sought = wanted.casefold()
    lines = [line for line in reversed(log) if sought in line.casefold()]
    note = f"log, newest first: {len(lines)} of {len(log)} lines" + (f", with {wanted}" if wanted else "")
    above.append(Row("log", ((f"── {visible(note)}", Ink.DIM),)))

    def row(n: int) -> Row:
        if n < len(above):
            return above[n]
        line = lines[n - len(above)]
        return Row(id(line), ((visible(line), _ink(line)),))

    keys = [*(one.key for one in above), *map(id, lines)]
    return Table((("Console", Ink.TITLE),), LateRows(keys, row))


def _ink(line: str) -> Ink:
    if " ERROR " in line or " CRITICAL " in line:
        return Ink.ALARM
    return Ink.WARN if " WARNING " in line else Ink.TEXT
