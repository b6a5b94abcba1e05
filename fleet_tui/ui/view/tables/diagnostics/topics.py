"""Every requested topic: its state, rate and age, and unreadable messages."""

import math
from collections.abc import Mapping, Sequence
from operator import attrgetter
from typing import NamedTuple

from fleet_tui.model.counters import TopicCounter
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.situation.links import is_late
from fleet_tui.text.language import N_, tr, translate
from fleet_tui.text.units import ago, size_text
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.diagnostics.links import Links, down
from fleet_tui.ui.view.tables.table import Run, Table

BAD_FOR = 10.0
"""Seconds for which a bad message marks its topic."""
LEAST = 10
"""Cells that a topic has at least."""
SLOW = 0.5
"""Of the rate that was requested: below it a topic of an overloaded bridge is slow."""
_FIRST = {StyleRole.ALARM: 0, StyleRole.WARN: 1}

Entry = tuple[LinkState, TopicCounter]


class ShownTopic(NamedTuple):
    """A topic with its state at one moment; `rates` are messages and bytes per second, None if unknown."""

    state: Run
    link: LinkState
    topic: TopicCounter
    rates: tuple[float, float] | None

    @property
    def key(self) -> tuple[str, str]:
        return self.link.name, self.topic.topic


def topic_state(link: LinkState, topic: TopicCounter, now: float, silent_after: float) -> Run:
    """Return the state of a topic, as a sign and words."""
    if topic.not_subscribed:
        return tr("✗ not subscribed"), StyleRole.ALARM
    if link.phase is not Phase.UP:
        return tr("○ no link"), StyleRole.WARN
    if topic.bad is not None and now - topic.bad.raw.at < BAD_FOR:
        return tr("▲ bad data"), StyleRole.ALARM
    if topic.at is None:
        if topic.on_change:
            return tr("· on change"), StyleRole.DIM
        waits = topic.on_demand or not topic.robot
        return (tr("· on demand"), StyleRole.DIM) if waits else (tr("○ none yet"), StyleRole.WARN)
    if topic.once or topic.on_demand or topic.on_change or not topic.robot:
        return tr("● received"), StyleRole.TEXT
    if now - topic.at > silent_after:
        return tr("○ silent"), StyleRole.WARN
    if is_late(link):
        return tr("▲ slow") if _is_slow(topic, now) else tr("▲ late"), StyleRole.WARN
    return tr("● live"), StyleRole.GOOD


def _is_slow(topic: TopicCounter, now: float) -> bool:
    rates = topic.rates(now)
    return bool(rates and topic.asked_ms and rates[0] < SLOW * 1000 / topic.asked_ms)


def entries(state: FleetState, links: Links, selected: str = "") -> list[Entry]:
    """Return the topics of the selected robot, then robot by robot in the order of the config, then the
    others."""
    first = {name: -1 for name in state.robots if name == selected}
    places: Mapping[str, int] = {robot: n for n, robot in enumerate(state.robots)} | first
    found = [(link, topic) for link, counter in links for topic in counter.topics.values()]
    return sorted(found, key=lambda one: places.get(one[1].robot, len(places)))


def topic_table(
    state: FleetState,
    links: Links,
    now: float,
    selected: str = "",
    width: int = UNBOUNDED,
    arrangement: RowArrangement | None = None,
) -> Table:
    """Return a row for each in `width` cells, those with problems first, then those of the selected robot;
    its key is link and topic."""
    topics = [
        ShownTopic(topic_state(link, topic, now, _silent_after(state, topic)), link, topic, topic.rates(now))
        for link, topic in entries(state, links, selected)
    ]
    late = tr("▲ late")
    topics.sort(key=lambda one: (_FIRST.get(one.state[1], len(_FIRST)), one.state[0] == late))
    trouble = sum(one.state[1] in (StyleRole.WARN, StyleRole.ALARM) for one in topics)
    note = tr(" {topics}, {trouble} with problems", topics=len(topics), trouble=trouble)
    title = (tr("Topics"), StyleRole.TITLE), (note, StyleRole.DIM), *down(links)
    if any(is_late(link) for link, _ in links):
        title = (*title, (tr(": lower the rates"), StyleRole.WARN))
    empty, columns = tr("console starting"), _columns(topics, now)
    return table_of(title, columns, topics, attrgetter("key"), width, arrangement=arrangement, empty=empty)


def _columns(topics: Sequence[ShownTopic], now: float) -> Sequence[Column[ShownTopic]]:
    def last(one: ShownTopic) -> Run:
        is_odd = one.state[1] is StyleRole.WARN
        return translate(ago(one.topic.at, now)), StyleRole.WARN if is_odd else StyleRole.TEXT

    def rate(one: ShownTopic) -> Run:
        return "" if one.rates is None else f"{one.rates[0]:.1f} Hz", StyleRole.TEXT

    def size(one: ShownTopic) -> Run:
        return "" if one.rates is None else f"{size_text(one.rates[1])}/s", StyleRole.DIM

    def bad(one: ShownTopic) -> Run:
        return tr("{errors} bad", errors=f"{one.topic.errors:,}") if one.topic.errors else "", StyleRole.WARN

    def why(one: ShownTopic) -> Run:
        topic = one.topic
        return topic.not_subscribed or (topic.bad.text if topic.bad is not None else ""), StyleRole.DIM

    def most(one: ShownTopic) -> Run:
        return asked_rate(one.topic.asked_ms), StyleRole.DIM

    def count(one: ShownTopic) -> Run:
        return f"{one.topic.count:,}", StyleRole.DIM

    is_bad = any(one.topic.errors for one in topics)
    return (
        Column(N_("state"), lambda one: one.state, (16, 20), tr("State")),
        Column(N_("age"), last, 10, tr("Last"), order=lambda one: one.topic.at or -math.inf, is_right=True),
        Column(
            N_("topic"),
            lambda one: one.topic.topic,
            (LEAST, UNBOUNDED),
            tr("Topic"),
            sorts=True,
            ends_differ=True,
        ),
        Column(
            N_("rate"),
            rate,
            8,
            tr("Rate"),
            order=lambda one: -one.rates[0] if one.rates else 0.0,
            is_right=True,
        ),
        Column("", most, 8, tr("At most"), is_right=True),
        Column("", bad if is_bad else None, 7, "", is_right=True),
        Column(
            N_("bytes"),
            size,
            9,
            tr("Bytes"),
            order=lambda one: -one.rates[1] if one.rates else 0.0,
            is_right=True,
            may_go=True,
        ),
        Column("", count, 8, tr("Messages"), is_right=True, may_go=True),
        Column(N_("why"), why if any(why(one)[0] for one in topics) else None, None, "", may_go=True),
        Column(N_("link"), text=lambda one: one.link.name, is_apart=True),
    )


def _silent_after(state: FleetState, topic: TopicCounter) -> float:
    robot, usual = state.robots.get(topic.robot), state.limits.offline_after
    return robot.kind.silence_of(topic.kind, usual) if robot else usual


def asked_rate(ms: int | None) -> str:
    """Return the highest rate that was requested, empty without a limit."""
    return f"{1000 / ms:.1f} Hz" if ms else ""
