"""Every requested topic: its state, rate and age, and unreadable messages."""

from collections.abc import Mapping, Sequence

from fleet_tui.model.counters import TopicCounter
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.situation.links import is_late
from fleet_tui.text.language import tr, translate
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.text.units import ago, size_text
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.diagnostics.links import Links, down
from fleet_tui.view.tables.table import LateRows, Row, Run, Table, column

UNBOUNDED = 10_000
BAD_FOR = 10.0
"""Seconds for which a bad message marks its topic."""

LEAST = 10
"""Cells that a topic has at least."""
PARTS = 0.7
"""Share of them from which the whole parts at its end stand for it."""
BAD = 8
"""Cells of the number of bad messages, if there are any."""
FIXED = 47
SIZES = 20
WHY = 10
"""Cells of state, age and rates with their gaps, of bytes and messages, which a narrow pane has not, and from
which a reason is shown."""
SLOW = 0.5
"""Of the rate that was requested: below it a topic of an overloaded bridge is slow."""
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
    if is_late(link):
        return tr("▲ slow") if _is_slow(topic, now) else tr("▲ late"), StyleRole.WARN
    return tr("● live"), StyleRole.GOOD


def _is_slow(topic: TopicCounter, now: float) -> bool:
    rates = topic.rates(now)
    return bool(rates and topic.asked_ms and rates[0] < SLOW * 1000 / topic.asked_ms)


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
    state: FleetState, links: Links, wanted: str, now: float, selected: str = "", width: int = UNBOUNDED
) -> Table:
    """Return a row for each in `width` cells, those with problems first, then those of the selected robot;
    its key is link and topic."""
    looked = [
        (topic_state(link, topic, now, _silent_after(state, topic)), (link, topic))
        for link, topic in entries(state, links, wanted, selected)
    ]
    late = tr("▲ late")
    looked.sort(key=lambda one: (_FIRST.get(one[0][1], len(_FIRST)), one[0][0] == late))
    states, found = [one for one, _ in looked], [entry for _, entry in looked]
    bad = BAD * any(topic.errors for _, topic in found)
    longest = column((topic.topic for _, topic in found), LEAST, UNBOUNDED)
    has_sizes = FIXED + longest + bad + SIZES <= width
    has_why = FIXED + longest + bad + SIZES + WHY <= width
    names = max(LEAST, min(longest, width - FIXED - bad - SIZES * has_sizes))
    keys = [(link.name, topic.topic) for link, topic in found]
    rows = LateRows(
        keys, lambda n: Row(keys[n], (*_runs(states[n], found[n][1], names, bad, now, has_sizes, has_why),))
    )
    trouble = sum(role in (StyleRole.WARN, StyleRole.ALARM) for _, role in states)
    note = tr(" {topics}, {trouble} with problems", topics=len(found), trouble=trouble) + (
        tr(", matching {text}", text=sanitize(wanted)) if wanted else ""
    )
    title = (tr("Topics"), StyleRole.TITLE), (note, StyleRole.DIM), *down(links)
    if any(is_late(link) for link, _ in links):
        title = (*title, (tr(": lower the rates"), StyleRole.WARN))
    empty = tr("no matching topic") if wanted else tr("console starting")
    return Table(title, rows, empty, head=_head(names, bad, has_sizes))


def _head(names: int, bad: int, has_sizes: bool) -> tuple[Run, ...]:
    words = (
        tr("State"),
        tr("Topic"),
        tr("Rate"),
        tr("At most"),
        tr("Last"),
        tr("Bytes"),
        tr("Messages"),
    )
    state, topic, rate, most, last, size, count = words
    heads = f"{state:<17}{last:>10} {topic:<{names}} {rate:>8} {most:>8} {'':{bad}}"
    heads += f"{size:>9} {count:>8}" * has_sizes
    return ((heads, StyleRole.DIM),)


def _shortened(name: str, cells: int) -> str:
    """Return a name of at most so many letters, cut at its front, before a part if that leaves most of it:
    `…/scan`, but `…e_to_pose/_action/status`, for other actions have such an end, too."""
    if len(name) <= cells:
        return name
    end = name[1 - cells :]
    whole = end[max(0, end.find("/")) :]
    return f"…{whole if len(whole) >= cells * PARTS else end}"


def _silent_after(state: FleetState, topic: TopicCounter) -> float:
    robot, usual = state.robots.get(topic.robot), state.limits.offline_after
    return robot.kind.silence_of(topic.kind, usual) if robot else usual


def asked_rate(ms: int | None) -> str:
    """Return the highest rate that was requested, empty without a limit."""
    return f"{1000 / ms:.1f} Hz" if ms else ""


def _runs(
    state: Run, topic: TopicCounter, names: int, bad: int, now: float, has_sizes: bool, has_why: bool
) -> Sequence[Run]:
    word, role = state
    rates = topic.rates(now)
    rate = "" if rates is None else f"{rates[0]:.1f} Hz"
    size = "" if rates is None else f"{size_text(rates[1])}/s"
    errors = tr("{errors} bad", errors=f"{topic.errors:,}") if topic.errors else ""
    runs = [
        (f"{word:<17}", role),
        (
            f"{translate(ago(topic.at, now)):>10} ",
            StyleRole.WARN if role is StyleRole.WARN else StyleRole.TEXT,
        ),
        (fit(_shortened(sanitize(topic.topic), names), names) + " ", StyleRole.TEXT),
        (f"{rate:>8} ", StyleRole.TEXT),
        (f"{asked_rate(topic.asked_ms):>8} ", StyleRole.DIM),
        (f"{errors:>{bad - 1}} " if bad else "", StyleRole.WARN),
        (f"{size:>9} {topic.count:>8,}  " * has_sizes, StyleRole.DIM),
    ]
    why = topic.not_subscribed or (topic.bad.text if topic.bad is not None else "")
    if topic.not_subscribed and not has_why:
        runs = runs[:3]  # it has no rate
    return [*runs, (sanitize(why), StyleRole.DIM)] if has_why or topic.not_subscribed else runs
