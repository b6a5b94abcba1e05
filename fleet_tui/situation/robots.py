"""Facts about robots: what they say, and whether they say anything."""

import math

from fleet_tui.model.alarm import Priority
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import CONTACT, FleetState, obstacle_text
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.navigation import blocked_text
from fleet_tui.model.robot import Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import (
    ADRIFT,
    AGE_UNKNOWN,
    BAD_DATA,
    DRIVES_ON,
    NEVER_SEEN,
    OBSTACLE,
    OLD_STAMPS,
    REPEATED_POSE,
    SILENT,
    STOP,
    UNDATED_POSE,
)
from fleet_tui.situation.links import bridge_remedy, is_late
from fleet_tui.situation.reported_motion import SELDOM
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.units import age

WAKE = Message("Wake it through its master control (stopHibernation)")
"""The action at a vehicle that said that it sleeps."""
NO_STATES = Message("Check its software, and the right of this user to read its states at the broker")
"""The action at a vehicle that is connected, and of which no state arrives: mosquitto grants a subscription
whose messages it then keeps back."""
BAD_FOR = 10.0
"""Seconds without bad data until it counts as over."""
SPEAKS_WITHIN = 2.0
"""Seconds for a vehicle to speak of which the broker keeps that it is gone: some leave an old last will there
for good, and send a state each second."""


ADRIFT_FOR = 3.0
"""Seconds for which a localised pose may be overdue: one waits for the next scan."""


def silent_from(state: FleetState, robot: Robot) -> float:
    """Return the monotonic second from which a robot counts as silent, if it sends nothing until then. What
    its bridge is late by may still be on its way; a new link restarts the silence of all its robots."""
    last, link = _last_word(state, robot), state.links[robot.link]
    if robot.is_gone and robot.connection is not None:
        is_kept = robot.connection.at < link.ready_since
        return link.ready_since + SPEAKS_WITHIN if is_kept else robot.connection.at
    return max(last or 0.0, link.ready_since) + state.patience(robot) + link.late


def _last_word(state: FleetState, robot: Robot) -> float | None:
    """Return the monotonic second of its last message: of one that nobody could read once it is no news."""
    last, bad = robot.last_received, robot.fault_at
    if bad is None or state.now - bad <= state.patience(robot):
        return last
    return max(last or bad, bad)


def absence(state: FleetState, robot: Robot) -> Fact | None:
    """Find why nothing current is known of a robot, or of its position: it is silent, was never seen, its one
    message is of unknown age, nothing that it sends can be read, or its poses arrive old. One whose bridge is
    late may have spoken: that is not certain."""
    if state.is_online(robot):
        return _old_stamps(state, robot)
    return _unreadable(state, robot) or silence(state, robot)


def silence(state: FleetState, robot: Robot) -> Fact:
    """Return the fact that a robot sends nothing, as it is if nothing comes until it is one."""
    since, link = silent_from(state, robot), state.links[robot.link]
    is_certain = not link.hides(robot.name) and (not is_late(link) or state.now > since)
    known = robot.connection.value if robot.connection is not None else None
    last = _last_word(state, robot)
    if last is not None:
        since_last = state.now - last
        is_told = known is not None and (robot.is_gone or known.is_asleep)
        kind = SILENT
        word = SILENT.word if is_certain else Message("silent")
        text = Message("{word} {age}", word=word, age=age(since_last))
        if known is not None and is_told:
            text = Message("{text} ({why})", text=text, why=known.text)
        evidence = Message("link up, no messages")
        question = Message("{name} is {word} {age}", name=robot.name, word=SILENT.word, age=age(since_last))
    elif known is not None and robot.is_gone:
        kind = SILENT
        text = Message("{word} ({text})", word=SILENT.word, text=known.text)
        evidence = Message("link up, no messages")
        question = Message("{name} is {text}", name=robot.name, text=text)
    elif robot.is_undated or robot.kept_at is not None:
        kind = AGE_UNKNOWN
        text = AGE_UNKNOWN.word
        evidence = Message("link up, one message received: it may be an old one")
        question = Message("the one message of {name} is of unknown age", name=robot.name)
    else:
        kind = NEVER_SEEN
        text = NEVER_SEEN.word if known is None else Message("no state yet ({text})", text=known.text)
        what = Message("message") if known is None else Message("state")
        evidence = Message("link up, no {what} received", what=what)
        question = Message("{name} was {word}", name=robot.name, word=NEVER_SEEN.word)
        if known is not None:
            question = Message("{name} has sent no state yet: it sends one every 30 s", name=robot.name)
    if known is not None and known.is_asleep:
        remedy = WAKE
    else:
        remedy = bridge_remedy(state, robot) or (NO_STATES if kind is NEVER_SEEN and known else EMPTY)
    pose = robot.pose
    is_behind = last is not None and pose is not None and last - pose.at >= 1.0
    return Fact(
        kind,
        robot.name,
        text,
        Priority.MEDIUM,
        since,
        remedy=remedy,
        # Behind a late bridge that of the map, if something else has come since.
        short=Message("pose {age} old", age=age(state.now - pose.at))
        if pose and is_behind and not is_certain
        else text,
        evidence=evidence,
        question=question,
        is_certain=is_certain,
    )


def may_be_back(state: FleetState, robot: Robot) -> bool:
    """Tell whether a vehicle that its broker knows as gone may still speak at once."""
    return robot.is_gone and state.now <= silent_from(state, robot)


def silent(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot has stopped speaking, or never did: while its link is up, and whatever its bridge is
    late by. One that sends only what nobody can read does speak."""
    fact = absence(state, robot)
    link = state.links[robot.link]
    if fact is None or fact.kind.name != SILENT.name or link.phase is not Phase.UP or link.hides(robot.name):
        return None
    return fact if state.now > fact.since else None


def _unreadable(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot sends, and nothing that can be read: then it is not silent, and its power and its
    network are well."""
    at = robot.fault_at
    if (
        at is None
        or robot.is_gone
        or state.links[robot.link].phase is not Phase.UP
        or state.now - at > state.patience(robot)
    ):
        return None
    return Fact(
        BAD_DATA,
        robot.name,
        Message(
            "all messages are bad, {faults} so far: {last_fault}",
            faults=robot.faults,
            last_fault=robot.last_fault,
        ),
        Priority.MEDIUM,
        at,
        short=bad_text(robot),
        evidence=Message("link up, messages arrive: {last_fault}", last_fault=robot.last_fault),
        question=Message(
            "no message of {name} is readable: {last_fault}", name=robot.name, last_fault=robot.last_fault
        ),
        seen=at,
    )


def bad_data(state: FleetState, source: Robot | LinkState) -> Fact | None:
    """Find unreadable data from a robot or over a link, a short while ago."""
    if source.fault_at is None or state.now - source.fault_at >= BAD_FOR:
        return None
    fact = absence(state, source) if isinstance(source, Robot) else None
    if fact is not None and fact.kind is BAD_DATA:
        return fact
    text = Message(
        "{word} x{faults}: {last_fault}",
        word=BAD_DATA.word,
        faults=source.faults,
        last_fault=source.last_fault,
    )
    return Fact(BAD_DATA, source.name, text, Priority.LOW, source.fault_at, short=bad_text(source))


def bad_text(source: Robot | LinkState) -> Message:
    """Return the short text of bad data."""
    return Message("{word} x{faults}", word=BAD_DATA.word, faults=source.faults)


def _old_stamps(state: FleetState, robot: Robot) -> Fact | None:
    """Find that poses of a robot arrive, and their stamps are old: its localisation is slow, or repeats its
    last pose. That means nothing while a robot without an order stands: many localisations give a pose only
    after a movement."""
    if robot.clock is None or robot.pose is None or not state.is_old(robot, "pose"):
        return None
    is_calm = robot.orders.current is None
    priority = Priority.LOW if is_calm else Priority.MEDIUM
    if robot.is_undated:
        return Fact(
            UNDATED_POSE,
            robot.name,
            UNDATED_POSE.word,
            priority,
            robot.clock.at,
            short=UNDATED_POSE.word,
            evidence=Message("one pose received: it may be an old one"),
            question=Message("the one pose of {name} is of unknown age", name=robot.name),
            seen=robot.clock.at,
        )
    patience = robot.kind.silence_of("pose", state.limits.offline_after) + state.behind
    if state.now - robot.clock.at > patience:
        return None
    lag = state.now - robot.pose.at
    kind = REPEATED_POSE if is_calm else OLD_STAMPS
    what = kind.word
    return Fact(
        kind,
        robot.name,
        Message("poses arrive {age} old", age=age(lag)),
        priority,
        robot.pose.at,
        short=Message("pose {age} old", age=age(lag)),
        evidence=Message("{what}: their time stamps lag", what=what),
        seen=robot.pose.at,
        is_certain=not is_late(state.links[robot.link]),
    )


def _repeats_feedback(state: FleetState, robot: Robot) -> bool:
    """Tell whether the feedback on its goal comes on, and its pose is an old one: navigation has no newer."""
    if robot.located_by != "feedback" or robot.located_at is None or robot.progress is None:
        return False
    is_new = state.now - robot.progress.at < ADRIFT_FOR
    return is_new and robot.progress.at - robot.located_at > ADRIFT_FOR


def adrift(state: FleetState, robot: Robot) -> Fact | None:
    """Find that only its wheels tell where a robot is: it has moved on, and its localisation is silent."""
    pose, located, located_at = robot.pose, robot.located, robot.located_at
    if pose is None or located is None or located_at is None or not state.is_fresh(robot, "pose"):
        return None
    since, repeats = robot.adrift_at, False
    if since is None and _repeats_feedback(state, robot):
        since, repeats = located_at, True
    if since is None or state.now - since < ADRIFT_FOR:
        return None
    metres = math.dist((located.x, located.y), (pose.value.x, pose.value.y))
    how = Message("{metres} m by its wheels alone", metres=f"{metres:.0f}")
    if repeats:
        how = Message("its feedback repeats the last pose")
    silence = age(state.now - located_at)
    return Fact(
        ADRIFT,
        robot.name,
        Message("pose estimated, localisation silent for {silence}", silence=silence),
        Priority.MEDIUM,
        since,
        remedy=bridge_remedy(state, robot, robot.kind.pose_topic),
        short=Message("pose estimated"),
        evidence=Message("localisation silent for {silence}: {how}", silence=silence, how=how),
        seen=pose.at,
    )


BRAKES_FOR = 3.0
DRIVES_FOR = 60.0
"""Seconds after the end of an order within which its robot brakes, and after which its movement is another
one's."""


def drives_on(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot drives on after its order failed: bt_navigator aborts if its controller is late with
    a word, and that drives to the end of the path."""
    last, standing = robot.gone[-1] if robot.gone else None, robot.standing
    if last is None or standing is None or last.stage is not Stage.FAILED or robot.orders.open:
        return None
    since_end = state.now - last.at
    is_moving = standing.at - last.at > BRAKES_FOR and state.now - standing.at < SELDOM
    if not robot.kind.keeps_goals or since_end > DRIVES_FOR or not is_moving:
        return None
    mission = robot.order_text(last.order)
    return Fact(
        DRIVES_ON,
        robot.name,
        DRIVES_ON.word,
        Priority.MEDIUM,
        last.at,
        evidence=Message(
            "{mission} failed {age} ago, and its pose still changes", mission=mission, age=age(since_end)
        ),
        seen=standing.at,
    )


def last_contact(state: FleetState, robot: Robot) -> Fact | None:
    """Find lasting contact with an obstacle, by its last report."""
    report = robot.obstacle
    if report is None or report.value <= _lasting(state):
        return None
    text, since = obstacle_text(state, robot, report), report.at - report.value
    return Fact(OBSTACLE, robot.name, text, Priority.HIGH, since)


def last_stop(state: FleetState, robot: Robot) -> Fact | None:
    """Find a lasting stop by its collision monitor or protective field, by its last report."""
    report = robot.blocked
    if report is None or not report.value.is_stopped or state.now - report.value.since <= _lasting(state):
        return None
    return Fact(STOP, robot.name, blocked_text(report.value, state.now), Priority.HIGH, report.value.since)


def _lasting(state: FleetState) -> float:
    return min(CONTACT, state.limits.obstacle_after)


def obstacle(state: FleetState, robot: Robot) -> Fact | None:
    """Find an obstacle that blocks a robot, by a fresh report: contact or a stop of a few seconds. Its alarm,
    which wants an acknowledgement, waits `obstacle_after`."""
    found = (last_contact(state, robot), last_stop(state, robot))
    return next((fact for fact in found if fact is not None and is_fresh(state, robot, fact)), None)


def is_blocked_for_long(state: FleetState, robot: Robot) -> bool:
    """Tell whether an obstacle blocks a robot for long enough to be an alarm."""
    fact = obstacle(state, robot)
    return fact is not None and state.now > fact.since + state.limits.obstacle_after


def is_fresh(state: FleetState, robot: Robot, fact: Fact) -> bool:
    """Tell whether the report of an obstacle, which is named as its fact, still holds."""
    return state.is_fresh(robot, fact.kind.name)


def blocked_robots(state: FleetState) -> list[str]:
    """Return the names of the robots that obstacles block."""
    return [name for name, robot in state.robots.items() if obstacle(state, robot) is not None]
