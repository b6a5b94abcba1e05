"""The diagnostics of each link: state, response time, rate, losses."""

from collections import Counter
from collections.abc import Iterator, Sequence
from operator import attrgetter
from typing import NamedTuple

from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.situation.facts import LATE_LINK
from fleet_tui.situation.links import is_late
from fleet_tui.text.language import N_, counted, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age, ago, duration, milliseconds, size_text
from fleet_tui.ui.view.bars import level
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.table import Run, Table

Links = Sequence[tuple[LinkState, LinkCounter]]

POSES = "pose", "odometry"
"""Kinds of topics with the positions of robots."""
LATE = 11.0
"""Seconds after which a heartbeat is overdue: sent every 5 s, it may take 5 s."""


def down(links: Links) -> tuple[Run, ...]:
    """Return `no link`, and to which bridge, or how late messages are, if some data can't be live; empty if
    all links are up and on time."""
    names = [sanitize(link.name) for link, _ in links if link.phase is not Phase.UP]
    late = max((link.late for link, _ in links if is_late(link)), default=0.0)
    if not names:
        return ((tr(" messages {duration} late", duration=duration(late)), StyleRole.WARN),) if late else ()
    return (
        (
            " " + (tr("no link") if len(links) == 1 else tr("no link: {names}", names=", ".join(names))),
            StyleRole.ALARM,
        ),
    )


class ShownField(NamedTuple):
    """A value of a link; that of the empty name is its address."""

    link: LinkState
    name: str
    runs: tuple[Run, ...]

    @property
    def key(self) -> tuple[str, str]:
        return self.link.name, self.name

    @property
    def head(self) -> Run:
        return (f"  {tr(self.name)}", StyleRole.DIM) if self.name else (self.link.name, StyleRole.TITLE)


_COLUMNS: Sequence[Column[ShownField]] = (
    Column(N_("name"), lambda field: field.head, (10, 16), "", stays=True),
    Column(N_("value"), lambda field: list(field.runs), None, ""),
    Column(N_("link"), text=lambda field: field.link.name, is_apart=True),
)


def link_table(
    links: Links, now: float, width: int = UNBOUNDED, arrangement: RowArrangement | None = None
) -> Table:
    """Return all links, one below the other. `now` is monotonic."""
    fields = [
        ShownField(link, name, runs)
        for link, counter in links
        for name, runs in (("", ((link.url, StyleRole.TEXT),)), *_fields(link, counter, now))
    ]
    title, empty = ((tr("Link"), StyleRole.TITLE),), tr("console starting")
    return table_of(title, _COLUMNS, fields, attrgetter("key"), width, arrangement=arrangement, empty=empty)


def _fields(link: LinkState, counter: LinkCounter, now: float) -> Iterator[tuple[str, tuple[Run, ...]]]:
    yield N_("state"), (_state(link, now),)
    yield N_("commands"), (_commands(link, counter.round_trips.at, now),)
    yield N_("round trip"), tuple(_round_trip(counter, now))
    took = counter.round_trips.took
    if len(took) > 1:
        curve = "".join(level(one / max(took)) for one in took)
        yield (
            N_("trend"),
            (
                (curve, StyleRole.DIM),
                (tr(" up to {milliseconds}", milliseconds=milliseconds(max(took))), StyleRole.DIM),
            ),
        )
    messages, size = counter.all.rates(now) or (0.0, 0.0)
    total = tr(
        ", {count} and {size_text} in total",
        count=f"{counter.all.count:,}",
        size_text=size_text(counter.all.bytes),
    )
    late = duration(link.late) + (f": {translate(LATE_LINK.word)}" if is_late(link) else "")
    yield N_("late by"), ((late, StyleRole.WARN if is_late(link) else StyleRole.TEXT),)
    yield (
        N_("messages"),
        ((f"{messages:.1f} /s, {size_text(size)}/s", StyleRole.TEXT), (total, StyleRole.DIM)),
    )
    at = counter.all.at
    silent = at is None or now - at > 2.0
    if told := _rates(counter):
        yield N_("rates"), ((told, StyleRole.TEXT),)
    yield N_("last message"), ((translate(ago(at, now)), StyleRole.WARN if silent else StyleRole.TEXT),)
    yield N_("connections"), tuple(_connections(counter, now))
    yield N_("dropped"), (_count(counter.dropped, tr("frames: too large, or queue full")),)
    yield (N_("superseded"), (_count(counter.overtaken, tr("frames: replaced by newer ones")),))
    why = (
        tr("frames, last {ago}: {text}", ago=ago(counter.bad.raw.at, now), text=counter.bad.text)
        if counter.bad
        else tr("frames")
    )
    yield N_("unreadable"), (_count(counter.unreadable, why),)
    errors = sum(topic.errors for topic in counter.topics.values())
    yield N_("bad data"), (_count(errors, tr("messages: see Topics") if errors else tr("messages")),)


def _rates(counter: LinkCounter) -> str:
    """Return how many robots have their poses at which rate, empty if all have the same."""
    poses = [topic for topic in counter.topics.values() if topic.kind in POSES]
    asked = Counter(topic.asked_ms for topic in poses if topic.asked_ms)
    if len(asked) < 2:
        return ""
    rates = (
        tr("{count} at {rate} Hz", count=count, rate=f"{1000 / ms:g}") for ms, count in sorted(asked.items())
    )
    return tr("poses: {rates}", rates=", ".join(rates))


def _state(link: LinkState, now: float) -> Run:
    lasted = age(now - link.since)
    if link.phase is Phase.UP:
        return tr("● up for {lasted}", lasted=lasted), StyleRole.GOOD
    trying = tr("connecting")
    if link.phase is Phase.WAITING and link.next_try is not None:
        trying = tr("retry in {seconds} s", seconds=f"{max(0.0, link.next_try - now):.0f}")
    why = f": {translate(sanitize(link.reason))}" if link.reason else ""
    return tr("○ no link for {lasted}{why}, {trying}", lasted=lasted, why=why, trying=trying), StyleRole.ALARM


def _commands(link: LinkState, replied_at: float | None, now: float) -> Run:
    """Return whether commands get through: not without a reply to the heartbeats for a while."""
    if link.command_path is CommandPath.ALIVE and replied_at is not None and now - replied_at > LATE:
        return tr("▲ replies late {age}", age=age(now - replied_at)), StyleRole.WARN
    match link.command_path:
        case CommandPath.ALIVE if link.command_reason:
            return f"○ {translate(sanitize(link.command_reason))}", StyleRole.WARN
        case CommandPath.ALIVE:
            return tr("● ok"), StyleRole.GOOD
        case CommandPath.DEAD:
            return tr(
                "✗ dead: {command_reason}", command_reason=sanitize(link.command_reason)
            ), StyleRole.ALARM
        case CommandPath.UNREGISTERED:
            return f"▲ {translate(sanitize(link.command_reason))}", StyleRole.ALARM
        case CommandPath.UNTRIED:
            return tr("○ not tried yet"), StyleRole.WARN


def _round_trip(counter: LinkCounter, now: float) -> Iterator[Run]:
    trips = counter.round_trips
    took = trips.took
    if not took:
        yield tr("no heartbeat reply yet"), StyleRole.WARN
    else:
        late = trips.at is None or now - trips.at > LATE
        newest = f"{milliseconds(took[-1])}, {translate(ago(trips.at, now))}"
        yield (
            tr("{newest}: overdue", newest=newest) if late else newest,
            StyleRole.WARN if late else StyleRole.TEXT,
        )
        spread = tr("{least} to {most}", least=milliseconds(min(took)), most=milliseconds(max(took)))
        mean = milliseconds(sum(took) / len(took))
        jitter = tr(", jitter {milliseconds}", milliseconds=milliseconds(trips.jitter)) if took[1:] else ""
        yield (
            tr(
                "  last {took}: {spread}, mean {mean}{jitter}",
                took=len(took),
                spread=spread,
                mean=mean,
                jitter=jitter,
            ),
            StyleRole.DIM,
        )
    if trips.unanswered:
        yield tr("  {unanswered} unanswered", unanswered=trips.unanswered), StyleRole.WARN


def _connections(counter: LinkCounter, now: float) -> Iterator[Run]:
    if not counter.connections:
        yield tr("none yet"), StyleRole.DIM
        return
    again = counter.connections - 1
    yield (
        translate(counted("{count} reconnect", "{count} reconnects", again)),
        StyleRole.WARN if again else StyleRole.TEXT,
    )
    if counter.lost_at is not None:
        yield (
            tr(
                ", last lost {ago}: {lost_why}",
                ago=ago(counter.lost_at, now),
                lost_why=sanitize(counter.lost_why),
            ),
            StyleRole.DIM,
        )


def _count(count: int, what: str) -> Run:
    return f"{count:,} {sanitize(what)}", StyleRole.WARN if count else StyleRole.DIM
