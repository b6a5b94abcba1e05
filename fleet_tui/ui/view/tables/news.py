"""The news of a robot: what is not as usual, the most urgent first."""

from collections.abc import Iterator, Sequence

from fleet_tui.commands.rivals import rivals
from fleet_tui.model.alarm import Alarm, AlarmStage, Priority
from fleet_tui.model.fleet import FleetState, is_missing, missing_text
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.orders.newest import own_pause
from fleet_tui.situation.alarms.members import issue_text
from fleet_tui.situation.alarms.trouble import AGING, in_trouble, shelved, unexplained_end
from fleet_tui.situation.deadlocks import deadlock
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import BAD_DATA, FAULT, INACTIVE, MISPLACED, SILENT
from fleet_tui.situation.localisation import uncertain
from fleet_tui.situation.navigation import inactive, silent_navigation
from fleet_tui.situation.pauses import own_pause_text
from fleet_tui.situation.pose_checks.jumps import is_jumping
from fleet_tui.situation.pose_checks.misplaced import misplaced_text
from fleet_tui.situation.reported_motion import moves_despite_pause
from fleet_tui.situation.robots import absence, adrift, bad_data, drives_on, last_contact, obstacle
from fleet_tui.situation.vehicles import FINDERS
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run, width_of

_NAMES = {name: name for name in AGING} | {"paused": "pause"}
"""Values that may be old, with their names."""


def _old(state: FleetState, robot: Robot, unheard: Fact | None) -> Iterator[Run]:
    """Yield the old values of a robot that is online, and a missing pose: they must not look live."""
    if is_missing(state, robot, "pose"):
        yield translate(missing_text(state, robot, "pose")), StyleRole.WARN
    if not robot.is_undated and not state.has_old(robot, _NAMES):
        return  # nearly always, and one look tells it
    for value, name in _NAMES.items():
        if state.is_old(robot, value):
            reading: Reading[object] = getattr(robot, value)
            if value == "pose" and unheard is not None:
                is_calm = unheard.priority is Priority.LOW
                yield translate(unheard.short), StyleRole.DIM if is_calm else StyleRole.WARN
                continue
            yield tr("{name} {age} old", name=tr(name), age=age(state.now - reading.at)), StyleRole.WARN


def _paused(state: FleetState, robot: Robot) -> Run:
    fact = moves_despite_pause(state, robot)
    if fact is not None:
        return translate(fact.text), StyleRole.ALARM if fact.priority is Priority.HIGH else StyleRole.WARN
    if robot.paused is None:
        return translate(own_pause_text(state, robot)), StyleRole.WARN
    return tr("paused") if own_pause(state, robot) else tr("paused (elsewhere)"), StyleRole.WARN


def without_cause(alarm: Alarm, text: Message) -> Message:
    """Return `order A -> B failed` of `order A -> B failed: no path`, another text of an alarm as it is."""
    over = alarm.condition.over
    return over if text.startswith(f"{over}: ") else text


def failed_command(state: FleetState, robot: Robot, short: bool = False) -> Iterator[Run]:
    """Return the alarms of a command and of an order that failed, as far as there are any; `short`: without
    the name of the order, which stands before what happened to it."""
    keys = (robot.name, "command"), (robot.name, "order")
    for alarm in state.alarms:
        if alarm.key in keys and alarm.holds and alarm.stage is not AlarmStage.SHELVED:
            is_of_order = alarm.key == keys[1] or without_cause(alarm, alarm.text) != alarm.text
            if is_of_order and (fact := drives_on(state, robot)) is not None:
                yield translate(fact.text), StyleRole.ALARM
                continue
            yield (
                translate(Message("order failed") if short and is_of_order else sanitize(alarm.text)),
                StyleRole.ALARM,
            )


def is_on_its_way(state: FleetState, robot: Robot) -> bool:
    """Tell whether what a robot says may still be on its way over a late bridge, which is what needs a
    person."""
    fact = absence(state, robot)
    return fact is not None and not fact.is_certain and robot.name not in in_trouble(state)


def _absent(state: FleetState, robot: Robot, fact: Fact) -> Run:
    """Return why nothing is known of a robot that is not online."""
    if robot.last_received is not None and is_on_its_way(state, robot):
        return translate(fact.short), StyleRole.WARN
    is_urgent = fact.kind in (SILENT, BAD_DATA) or robot.name in in_trouble(state)
    return translate(fact.short), StyleRole.ALARM if is_urgent else StyleRole.DIM


def news(state: FleetState, robot: Robot) -> Iterator[Run]:
    """Return the news of a robot, the most urgent first."""
    online = state.is_online(robot)
    unheard = absence(state, robot)
    if unheard is not None and not online:
        yield _absent(state, robot, unheard)
    yield from _vehicle(state, robot)
    if (fact := obstacle(state, robot)) is not None:
        yield translate(fact.text), StyleRole.WARN if robot.name in shelved(state) else StyleRole.ALARM
    if (wait := deadlock(state, robot)) is not None:
        is_alarm = robot.name in in_trouble(state)
        yield translate(wait.text), StyleRole.ALARM if is_alarm else StyleRole.WARN
    yield from _navigation(state, robot)
    yield from _member(state, robot)
    if state.is_paused(robot) and robot.last_received is not None:
        yield _paused(state, robot)
    if fact is None and (past := last_contact(state, robot)) is not None:
        yield translate(past.text), StyleRole.DIM
    yield from _ended(state, robot)
    yield from _operators(state, robot)
    if online:
        yield from _old(state, robot, unheard)
    bad = bad_data(state, robot)
    if bad is not None and (unheard is None or unheard.kind is not BAD_DATA):
        yield translate(bad.short), StyleRole.WARN


def _operators(state: FleetState, robot: Robot) -> Iterator[Run]:
    """Yield who else commands it now, and who has claimed it."""
    if others := rivals(state, robot.name):
        names = " and ".join(dict.fromkeys(one.by for one in others))
        yield tr("also commanded by {names}", names=sanitize(names)), StyleRole.ACCENT
    if holders := state.desk.holders(robot.name):
        yield tr("claimed by {holders}", holders=sanitize(" and ".join(holders))), StyleRole.ACCENT


def _ended(state: FleetState, robot: Robot) -> Iterator[Run]:
    """Yield that an order was lost or left the queue, unless an alarm tells which."""
    end = unexplained_end(state, robot)
    if end is not None and not any(failed_command(state, robot)):
        yield tr("order {end}", end=tr(end.value)), StyleRole.WARN


def _navigation(state: FleetState, robot: Robot) -> Iterator[Run]:
    if (servers := inactive(state, robot)) is not None:
        yield translate(servers.text), StyleRole.ALARM
    elif (silence := silent_navigation(state, robot)) is not None:
        yield translate(silence.short), StyleRole.ALARM
    if (doubt := uncertain(robot)) is not None:
        yield translate(doubt.short), StyleRole.WARN
    if (estimate := adrift(state, robot)) is not None:
        yield translate(estimate.short), StyleRole.WARN
    if state.is_fresh(robot, "pose") and is_jumping(robot, state.now):
        yield tr("pose jumps"), StyleRole.WARN
    if misplaced_text(state, robot) and state.is_fresh(robot, "pose"):
        yield translate(MISPLACED.word), StyleRole.WARN  # steady: where it was changes with each shelf


def _vehicle(state: FleetState, robot: Robot) -> Iterator[Run]:
    """Yield what a vehicle of a master control reports about itself."""
    if robot.vehicle is None or not state.is_fresh(robot, "vehicle"):
        return
    for find in FINDERS:
        if (fact := find(robot)) is not None:
            text = sanitize(fact.short)
            is_own_word = fact.kind is FAULT  # the type of an error, by its maker
            is_high = fact.priority is Priority.HIGH
            yield text if is_own_word else translate(text), StyleRole.ALARM if is_high else StyleRole.WARN


def _member(state: FleetState, robot: Robot) -> Iterator[Run]:
    """Yield what the adapter of a fleet reports about a robot."""
    if state.is_online(robot) and robot.member is not None and (text := issue_text(robot.member.value)):
        yield translate(sanitize(text)), StyleRole.ALARM


def _short(text: str) -> str:
    """Return `refused: no path` of `refused: no path (order A -> B)`, `lost: order` of
    `lost: order A -> B`."""
    told = text.rpartition(" (")[0] or text
    what, colon, rest = told.partition(": ")
    return f"{what}{colon}{rest.partition(' ')[0]}" if " -> " in rest else told


def shortened_news(texts: list[Run], cells: int) -> list[Run]:
    """Return the news of a robot, if more would be cut, with the command that failed without what it was (the
    alarm has it), then one word for a pause, and beside others its sign."""
    if width_of(listed(texts)) > cells:
        whole = translate(INACTIVE.word) + ": "  # its cause says as much, unless that is cut, too
        causes = [(text.removeprefix(whole), role) for text, role in texts]
        texts = [
            cause if width_of([cause]) <= cells else text for text, cause in zip(texts, causes, strict=True)
        ]
    if width_of(listed(texts)) > cells:
        texts = [(_short(text) if role is StyleRole.ALARM else text, role) for text, role in texts]
    paused = tr("paused")
    for short in (paused, "‖")[: len(texts)]:
        if width_of(listed(texts)) <= cells:
            break
        texts = [(short if text.startswith(paused) else text, role) for text, role in texts]
    return texts


def with_commas(texts: Sequence[Run]) -> list[Run]:
    """Return texts with a comma after each but the last."""
    return [(f"{text},", role) for text, role in texts[:-1]] + list(texts[-1:])


def listed(texts: Sequence[Run]) -> list[Run]:
    return [run for text in with_commas(texts) for run in ((" ", StyleRole.TEXT), text)][1:]


def in_cells(texts: Sequence[Run], cells: int) -> list[Run]:
    """Return a list of texts in so many cells: of one that would be cut no more than what is before its
    cause, and an ellipsis for others that have no space."""
    for kept in range(len(texts), 0, -1):
        told = listed(texts[:kept])
        if kept < len(texts):
            told.append(("…", StyleRole.DIM))
        if width_of(told) <= cells:
            return told
    (text, role), more = texts[0], "…" * (len(texts) > 1)
    what, colon, _ = text.partition(": ")
    return [(what + "…" if colon else text + more, role)]
