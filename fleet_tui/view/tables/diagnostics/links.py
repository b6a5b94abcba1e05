"""The diagnostics of each link: state, response time, rate, losses."""

from collections import Counter
from collections.abc import Iterator, Sequence

from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.situation.facts import LATE_LINK
from fleet_tui.situation.links import is_late
from fleet_tui.text.language import Message, tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age, ago, duration, milliseconds, size_text
from fleet_tui.view.history.bars import level
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Row, Run, Table

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


def link_table(links: Links, now: float) -> Table:
    """Return all links, one below the other. `now` is monotonic."""
    rows: list[Row] = []
    for link, counter in links:
        runs = (f"{sanitize(link.name)} ", StyleRole.TITLE), (sanitize(link.url), StyleRole.TEXT)
        rows.append(Row((link.name, ""), runs))
        rows += [
            Row(
                (link.name, name),
                ((f"  {tr(name):<14}", StyleRole.DIM), *((tr(text), role) for text, role in runs)),
            )
            for name, runs in _fields(link, counter, now)
        ]
    return Table(((tr("Link"), StyleRole.TITLE),), rows, tr("console starting"))


def _fields(link: LinkState, counter: LinkCounter, now: float) -> Iterator[tuple[str, tuple[Run, ...]]]:
    yield "state", (_state(link, now),)
    yield "commands", (_commands(link, counter.round_trips.at, now),)
    yield "round trip", tuple(_round_trip(counter, now))
    took = counter.round_trips.took
    if len(took) > 1:
        curve = "".join(level(one / max(took)) for one in took)
        yield (
            "trend",
            (
                (curve, StyleRole.DIM),
                (Message(" up to {milliseconds}", milliseconds=milliseconds(max(took))), StyleRole.DIM),
            ),
        )
    messages, size = counter.all.rates(now) or (0.0, 0.0)
    total = Message(
        ", {count} and {size_text} in total",
        count=f"{counter.all.count:,}",
        size_text=size_text(counter.all.bytes),
    )
    late = f"{duration(link.late)}: {LATE_LINK.word}" if is_late(link) else duration(link.late)
    yield "late by", ((late, StyleRole.WARN if is_late(link) else StyleRole.TEXT),)
    yield "messages", ((f"{messages:.1f} /s, {size_text(size)}/s", StyleRole.TEXT), (total, StyleRole.DIM))
    at = counter.all.at
    silent = at is None or now - at > 2.0
    if told := _rates(counter):
        yield "rates", ((told, StyleRole.TEXT),)
    yield "last message", ((ago(at, now), StyleRole.WARN if silent else StyleRole.TEXT),)
    yield "connections", tuple(_connections(counter, now))
    yield "dropped", (_count(counter.dropped, "frames: too large, or queue full"),)
    yield (
        "superseded",
        (_count(counter.overtaken, "frames: replaced by newer ones"),),
    )
    why = (
        Message(
            "frames, last {ago}: {text}",
            ago=Message(ago(counter.bad.raw.at, now)),
            text=Message(counter.bad.text),
        )
        if counter.bad
        else "frames"
    )
    yield "unreadable", (_count(counter.unreadable, why),)
    errors = sum(topic.errors for topic in counter.topics.values())
    yield "bad data", (_count(errors, "messages: see Topics" if errors else "messages"),)


def _rates(counter: LinkCounter) -> str:
    """Return how many robots have their poses at which rate, empty if all have the same."""
    poses = [topic for topic in counter.topics.values() if topic.kind in POSES]
    asked = Counter(topic.asked_ms for topic in poses if topic.asked_ms)
    if len(asked) < 2:
        return ""
    return "poses: " + ", ".join(f"{count} at {1000 / ms:g} Hz" for ms, count in sorted(asked.items()))


def _state(link: LinkState, now: float) -> Run:
    lasted = age(now - link.since)
    if link.phase is Phase.UP:
        return Message("● up for {lasted}", lasted=lasted), StyleRole.GOOD
    trying = "connecting"
    if link.phase is Phase.WAITING and link.next_try is not None:
        trying = Message("retry in {value} s", value=f"{max(0.0, link.next_try - now):.0f}")
    why = f": {sanitize(link.reason)}" if link.reason else ""
    return Message(
        "○ no link for {lasted}{why}, {trying}", lasted=lasted, why=Message(why), trying=Message(trying)
    ), StyleRole.ALARM


def _commands(link: LinkState, replied_at: float | None, now: float) -> Run:
    """Return whether commands get through: not without a reply to the heartbeats for a while."""
    if link.command_path is CommandPath.ALIVE and replied_at is not None and now - replied_at > LATE:
        return Message("▲ replies late {age}", age=age(now - replied_at)), StyleRole.WARN
    match link.command_path:
        case CommandPath.ALIVE if link.command_reason:
            return f"○ {tr(sanitize(link.command_reason))}", StyleRole.WARN
        case CommandPath.ALIVE:
            return "● ok", StyleRole.GOOD
        case CommandPath.DEAD:
            return Message(
                "✗ dead: {command_reason}", command_reason=Message(sanitize(link.command_reason))
            ), StyleRole.ALARM
        case CommandPath.UNREGISTERED:
            return f"▲ {tr(sanitize(link.command_reason))}", StyleRole.ALARM
        case CommandPath.UNTRIED:
            return "○ not tried yet", StyleRole.WARN


def _round_trip(counter: LinkCounter, now: float) -> Iterator[Run]:
    trips = counter.round_trips
    took = trips.took
    if not took:
        yield "no heartbeat reply yet", StyleRole.WARN
    else:
        late = trips.at is None or now - trips.at > LATE
        newest = f"{milliseconds(took[-1])}, {ago(trips.at, now)}"
        yield (
            Message("{newest}: overdue", newest=Message(newest)) if late else newest,
            StyleRole.WARN if late else StyleRole.TEXT,
        )
        spread = Message(
            "{milliseconds} to {milliseconds2}",
            milliseconds=milliseconds(min(took)),
            milliseconds2=milliseconds(max(took)),
        )
        mean = milliseconds(sum(took) / len(took))
        jitter = (
            Message(", jitter {milliseconds}", milliseconds=milliseconds(trips.jitter)) if took[1:] else ""
        )
        yield (
            Message(
                "  last {took}: {spread}, mean {mean}{jitter}",
                took=len(took),
                spread=spread,
                mean=mean,
                jitter=Message(jitter),
            ),
            StyleRole.DIM,
        )
    if trips.unanswered:
        yield Message("  {unanswered} unanswered", unanswered=trips.unanswered), StyleRole.WARN


def _connections(counter: LinkCounter, now: float) -> Iterator[Run]:
    if not counter.connections:
        yield "none yet", StyleRole.DIM
        return
    again = counter.connections - 1
    yield f"{again} reconnect{'s' * (again != 1)}", StyleRole.WARN if again else StyleRole.TEXT
    if counter.lost_at is not None:
        yield (
            Message(
                ", last lost {ago}: {lost_why}",
                ago=Message(ago(counter.lost_at, now)),
                lost_why=Message(sanitize(counter.lost_why)),
            ),
            StyleRole.DIM,
        )


def _count(count: int, what: str) -> Run:
    return f"{count:,} {tr(sanitize(what))}", StyleRole.WARN if count else StyleRole.DIM
