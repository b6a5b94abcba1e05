"""The line that is always visible: the link, the alarms, the selected robot."""

import re
from collections.abc import Iterator, Mapping, Sequence

from fleet_tui.keys.key import key_name
from fleet_tui.model.fleet import FleetState, behind_text
from fleet_tui.model.kind import PAUSE
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.sites import alarms_by_site, site_of, sites_of
from fleet_tui.situation.alarms.trouble import to_look_at
from fleet_tui.situation.facts import LATE_LINK
from fleet_tui.situation.links import LATE_FROM, dead_commands, is_late, withheld
from fleet_tui.situation.pauses import is_held
from fleet_tui.situation.reported_motion import is_moving
from fleet_tui.text.language import Message, counted, tr, translate
from fleet_tui.text.sanitize import cell_width, fit_words, sanitize
from fleet_tui.text.units import age, duration
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run, width_of

# A link with a message within this many seconds is well.
SILENT_AFTER = 2.0
# Seconds without a first connection after which there is no link; until then the console is connecting.
STARTING = 2.0
# The writer ticks ten times a second. Without ticks, ages stop and everything looks live.
BLIND_AFTER = 2.0
HUNG_AFTER = 10.0
"""Seconds without a tick: a busy machine may cause the first, after the second only a restart helps."""
PAUSED = Message("PAUSED")
"""The end of the note that robots are paused."""
LEAST = 12
"""Cells below which a note or an address says nothing."""
_PATH = re.compile(r"(?:/[^/\s:'\"]+)+(/[^/\s:'\"]+)")
SEVERAL = 2
"""Paused robots from which that is a note; a single one among others tells it in its row."""


def console_notes(state: FleetState, read_only: bool, armed: bool, standstill: float) -> list[str]:
    """Return notes on this console, such as its delay, or a stalled clock when the state is `standstill`
    seconds old."""
    able = [robot for robot in state.robots.values() if robot.kind.can(PAUSE)]
    # Of a robot that is not heard nobody knows whether it stands, and one that was paused may drive on.
    held = [robot for robot in able if state.is_online(robot) and is_held(state, robot)]
    stopped = [robot for robot in held if not is_moving(robot, state.now)]
    # A robot whose kind has no pause drives on: beside it not all are paused.
    robots = len(state.robots)
    paused = (
        tr("ALL {paused}", paused=translate(PAUSED))
        if len(stopped) == robots
        else tr(
            "{stopped} of {robots} {paused}", stopped=len(stopped), robots=robots, paused=translate(PAUSED)
        )
    )
    notes = {
        paused: len(stopped) >= min(SEVERAL, max(1, sum(map(state.is_online, able)))),
        tr("read-only"): read_only,
        tr("not armed"): not armed,
        translate(behind_text(state)): state.behind >= LATE_FROM,
        _stalled(standstill): standstill > BLIND_AFTER,
    }
    return [note for note, holds in notes.items() if holds]


def _stalled(seconds: float) -> str:
    if seconds < HUNG_AFTER:
        return tr("no updates for {age}", age=age(seconds))
    return tr("no updates for {age}: restart this console", age=age(seconds))


def resume_all(keys: Mapping[str, tuple[str, ...]]) -> str:
    """Return the way to resume all robots: a key, or typed in the palette."""
    if keys["resume_all"]:
        return tr("{key_name} resumes all", key_name=key_name(keys["resume_all"][0]))
    key = "".join(map(key_name, keys["palette"][:1]))
    return key + " " * (len(key) > 1) + tr("resume all")


def _age_runs(link: LinkState, now: float, address: str) -> Iterator[Run]:
    """Yield whether there is a link, and how old what is shown is: what no line may cut."""
    if link.phase is not Phase.UP:
        if not link.was_up and now - link.since < STARTING:
            yield tr("○ connecting "), StyleRole.TEXT
            return
        yield tr("○ no link for {age}, ", age=age(now - link.since)), StyleRole.ALARM
        if link.phase is Phase.CONNECTING or link.next_try is None:
            yield tr("connecting"), StyleRole.TEXT
        else:
            yield tr("retry in {seconds} s", seconds=f"{max(0.0, link.next_try - now):.0f}"), StyleRole.TEXT
        return
    late = is_late(link)
    yield "● ", StyleRole.WARN if late else StyleRole.GOOD
    if late:
        yield (
            tr("{duration} late: {word} ", duration=duration(link.late), word=translate(LATE_LINK.word)),
            StyleRole.WARN,
        )
    yield f"{address} ", StyleRole.TEXT
    if link.last_received is None:
        yield tr("nothing received yet"), StyleRole.DIM
    elif not late:  # what arrives just now is old
        silent = max(0.0, now - link.last_received)
        yield f"{duration(silent)}", StyleRole.DIM if silent < SILENT_AFTER else StyleRole.WARN


def _trouble_runs(link: LinkState, now: float, address: str) -> Iterator[Run]:
    """Yield what else there is to say of a link; the end is cut first."""
    if link.phase is not Phase.UP:
        if not link.was_up and now - link.since < STARTING:
            yield f"{address} ", StyleRole.DIM
            yield translate(sanitize(link.reason)), StyleRole.DIM
            return
        if link.reason:
            yield f": {translate(sanitize(link.reason))}", StyleRole.WARN
        last = (
            ""
            if link.last_received is None
            else tr(", last message {age} ago", age=age(now - link.last_received))
        )
        yield f"{last} {address}", StyleRole.DIM
        return
    if link.waiting_topics:
        done = link.topics - link.waiting_topics
        yield tr(" subscribing: {done} of {topics} topics", done=done, topics=link.topics), StyleRole.TEXT
    for fact in (dead_commands(link), withheld(link)):
        if fact is not None:
            yield f" {translate(sanitize(fact.text))}", StyleRole.ALARM
    if link.faults:
        yield tr(" {faults} bad frames", faults=link.faults), StyleRole.WARN


def _worst(state: FleetState) -> LinkState:
    """Return the link that most needs a person; all of them in the order of the config."""
    return min(
        state.links.values(),
        key=lambda link: (
            link.phase is Phase.UP,
            dead_commands(link) is None,
            withheld(link) is None,
            not is_late(link),
            -link.waiting_topics,
            link.last_received or 0.0,
        ),
    )


def status_line(
    state: FleetState,
    selected: str,
    notes: Sequence[str] = (),
    addressed: bool = True,
    kept: Sequence[str] = (),
    width: int | None = None,
) -> tuple[Run, ...]:
    """Return the parts that must not be cut first: alarms, the selected robot, the link, by its address or
    only by its name; a recording always by its address.

    `kept` are notes on files, recordings and the desk. In `width` cells the link keeps its age: first their
    paths are shortened, then they are cut, then the address, then the other notes.
    """
    head = list(_head(state, selected))
    link = _worst(state)
    address = sanitize(link.url if addressed or link.is_bag else link.name)
    tail = _link_tail(state, link, address)
    if width is None:
        return (*head, *((note + "  ", StyleRole.WARN) for note in (*notes, *kept)), *tail)
    least = list(_age_runs(link, state.now, fit_words(address, LEAST).rstrip()))
    head += _in_space(notes, width - width_of(head) - width_of(least))
    space = width - width_of(head) - width_of(tail)
    if space < 0:
        tail = _link_tail(state, link, fit_words(address, max(LEAST, cell_width(address) + space)).rstrip())
    if cell_width("".join(note + "  " for note in kept)) > space:
        kept = [_PATH.sub(r"…\1", note) for note in kept]
    return (*head, *_in_space(kept, space), *tail)


def _in_space(notes: Sequence[str], space: int) -> Iterator[Run]:
    """Yield notes in so many cells, cut if need be, or none."""
    text = "".join(note + "  " for note in notes)
    if cell_width(text) <= space:
        yield text, StyleRole.WARN
    elif space > LEAST:
        yield f"{fit_words(text, space - 2).rstrip()}  ", StyleRole.WARN


def _head(state: FleetState, selected: str) -> Iterator[Run]:
    fresh, alarms = state.unacknowledged, len(state.alarms) - state.shelved
    site = site_of(state, selected) if sites_of(state) else ""
    shown = f"{sanitize(site)}: {sanitize(selected)}" if site else sanitize(selected)
    yield f" {shown}  ", StyleRole.ACCENT
    sign, role = ("▲", StyleRole.ALARM) if fresh else ("△", StyleRole.TEXT if alarms else StyleRole.DIM)
    new = tr(" ({fresh} new)", fresh=fresh) if fresh else ""
    yield (f"{sign} " + translate(counted("{count} alarm", "{count} alarms", alarms)) + new, role)
    if odd := len(to_look_at(state)):
        yield tr(", {odd} to look at", odd=odd), StyleRole.WARN
    yield from _by_site(state, role)
    yield "  ", StyleRole.TEXT


def _link_tail(state: FleetState, link: LinkState, address: str) -> list[Run]:
    others = len(state.links) - 1
    runs = [*_age_runs(link, state.now, address), *_trouble_runs(link, state.now, address)]
    if others > 0 and link.phase is not Phase.UP:  # before what a narrow line cuts
        runs.insert(0, (f"{sanitize(link.name)} ", StyleRole.ALARM))
    if others > 0:
        up = sum(link.phase is Phase.UP for link in state.links.values())
        runs.append((tr("  {up} of {others} links up", up=up, others=others + 1), StyleRole.DIM))
    return runs


def _by_site(state: FleetState, role: StyleRole) -> Iterator[Run]:
    """Yield the alarms of each site, of several."""
    if found := alarms_by_site(state):
        elsewhere = tr("no site")
        told = ", ".join(f"{sanitize(site) or elsewhere} {count}" for site, count in found.items())
        yield f": {told}", role


def status_right(clock: str, operator: str = "") -> tuple[Run, ...]:
    """Return the right end, as far as it fits: the program or the console in command, and the time."""
    return ((f"{sanitize(operator) or 'fleet-tui'}  ", StyleRole.DIM), (f"{clock} ", StyleRole.DIM))
