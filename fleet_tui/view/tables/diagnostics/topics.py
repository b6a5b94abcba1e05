"""Every requested topic: its state, rate and age, and unreadable messages."""

from collections.abc import Mapping, Sequence
from itertools import accumulate

from fleet_tui.model.counters import TopicCounter
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.rules.lag import is_overloaded
from fleet_tui.text.durations import duration
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import cell_width, fit, sanitize
from fleet_tui.text.units import ago, size_text
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.diagnostics.links import Links, down
from fleet_tui.view.tables.table import LateRows, Row, Run, Table, column

BAD_FOR = 10.0
"""Seconds for which a bad message marks its topic."""

NAMES = 34
"""Cells of the longest topic."""
BAD = 8
"""Cells of the number of bad messages, if there are any."""
_FIRST = {StyleRole.ALARM: 0, StyleRole.WARN: 1}

Entry = tuple[LinkState, TopicCounter]


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
    if is_overloaded(link):
        return tr(f"▲ {duration(link.late)} late"), StyleRole.WARN
    return tr("● live"), StyleRole.GOOD


def entries(state: FleetState, links: Links, wanted: str, selected: str = "") -> list[Entry]:
    """Return the topics that contain `wanted`, those of the selected robot, then robot by robot in the order
    of the config, then the others."""
    first = {name: -1 for name in state.robots if name == selected}
    places: Mapping[str, int] = {robot: n for n, robot in enumerate(state.robots)} | first
    found = [
        (link, topic)
        for link, counter in links
        for topic in counter.topics.values()
        if wanted.casefold() in topic.topic.casefold()
    ]
    return sorted(found, key=lambda one: places.get(one[1].robot, len(places)))


def topic_table(
    state: FleetState, links: Links, wanted: str, now: float, selected: str = "", width: int = 200
) -> Table:
    """Return a row for each, those with problems first, then those of the selected robot; its key is link and
    topic. Columns beyond `width` cells are left out as a whole."""
    looked = [
        (topic_state(link, topic, now, _silent_after(state, topic)), (link, topic))
        for link, topic in entries(state, links, wanted, selected)
    ]
    looked.sort(key=lambda one: _FIRST.get(one[0][1], len(_FIRST)))
    states, found = [one for one, _ in looked], [entry for _, entry in looked]
    names = column((topic.topic for _, topic in found), 10, NAMES)
    bad = BAD * any(topic.errors for _, topic in found)
    keys = [(link.name, topic.topic) for link, topic in found]

    def row(n: int) -> Row:
        topic = found[n][1]
        why = topic.not_subscribed or (topic.bad.text if topic.bad is not None else "")
        runs = _fitting(_runs(states[n], topic, names, bad, now), width)
        return Row(keys[n], (*runs, (sanitize(why), StyleRole.DIM)))

    rows = LateRows(keys, row)
    trouble = sum(role in (StyleRole.WARN, StyleRole.ALARM) for _, role in states)
    note = tr(f" {len(found)}, {trouble} with problems") + (
        tr(f", matching {sanitize(wanted)}") if wanted else ""
    )
    title = (tr("Topics"), StyleRole.TITLE), (note, StyleRole.DIM), *down(links)
    empty = tr("no matching topic") if wanted else tr("console starting")
    return Table(title, rows, empty, head=_fitting(_head(names, bad), width))


def _fitting(runs: Sequence[Run], width: int) -> tuple[Run, ...]:
    """Return the columns that have space as a whole."""
    ends = accumulate(cell_width(text) for text, _ in runs)
    return tuple(run for run, end in zip(runs, ends, strict=True) if end <= width + 1)  # a gap is last


def _head(names: int, bad: int) -> Sequence[Run]:
    words = map(tr, ("State", "Topic", "Rate", "At most", "Last", "Bytes", "Messages"))
    state, topic, rate, most, last, size, count = words
    columns = f"{state:<17}", f"{last:>10} ", f"{topic:<{names}} ", f"{rate:>8} ", f"{most:>8} "
    return [(text, StyleRole.DIM) for text in (*columns, f"{'':{bad}}", f"{size:>9} ", f"{count:>8} ")]


def _shortened(name: str, cells: int) -> str:
    """Return a name of at most so many letters: topics of a robot differ at their ends."""
    kept = cells - 1
    return name if len(name) <= cells else f"{name[: kept // 3]}…{name[len(name) - kept + kept // 3 :]}"


def _silent_after(state: FleetState, topic: TopicCounter) -> float:
    robot, usual = state.robots.get(topic.robot), state.limits.offline_after
    return robot.kind.silence_of(topic.kind, usual) if robot else usual


def asked_rate(ms: int | None) -> str:
    """Return the highest rate that was requested, empty without a limit."""
    return f"{1000 / ms:.1f} Hz" if ms else ""


def _runs(state: Run, topic: TopicCounter, names: int, bad: int, now: float) -> Sequence[Run]:
    word, role = state
    rates = topic.rates(now)
    rate = "" if rates is None else f"{rates[0]:.1f} Hz"
    size = "" if rates is None else f"{size_text(rates[1])}/s"
    errors = tr(f"{topic.errors:,} bad") if topic.errors else ""
    return [
        (f"{word:<17}", role),
        (f"{tr(ago(topic.at, now)):>10} ", StyleRole.WARN if role is StyleRole.WARN else StyleRole.TEXT),
        (fit(_shortened(sanitize(topic.topic), names), names) + " ", StyleRole.TEXT),
        (f"{rate:>8} ", StyleRole.TEXT),
        (f"{asked_rate(topic.asked_ms):>8} ", StyleRole.DIM),
        (f"{errors:>{bad - 1}} " if bad else "", StyleRole.WARN),
        (f"{size:>9} ", StyleRole.DIM),
        (f"{topic.count:>8,} ", StyleRole.DIM),
    ]
