"""Alarm rules: one function for each source, over the newest state.

A rule returns None while all is well. `active` are the conditions of the last check: a battery has to leave
its dead band, and conditions from before a link loss continue.
"""

import math
from collections.abc import Iterator

from fleet_tui.model.alarm import Condition, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.robot import Robot
from fleet_tui.situation import links
from fleet_tui.situation.alarms.facilities import facility_conditions
from fleet_tui.situation.alarms.floods import ActiveConditions, was_active
from fleet_tui.situation.alarms.members import MEMBER_RULES
from fleet_tui.situation.alarms.navigation import NAVIGATION_RULES
from fleet_tui.situation.alarms.vehicles import VEHICLE_RULES
from fleet_tui.situation.battery.charging import (
    LOOK_AT_CHARGER,
    charger_used,
    charging_remedy,
    charging_reported,
)
from fleet_tui.situation.causes import cause_of_standing
from fleet_tui.situation.deadlocks import deadlock
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import BAD_DATA, DESPITE_PAUSE, SILENT, STUCK
from fleet_tui.situation.failures import failed_commands
from fleet_tui.situation.navigation import silent_navigation
from fleet_tui.situation.pauses import is_held
from fleet_tui.situation.reported_motion import moves_despite_pause, running_action, says_driving
from fleet_tui.situation.robots import (
    absence,
    is_blocked_for_long,
    is_fresh,
    last_contact,
    last_stop,
    silence,
)
from fleet_tui.situation.robots import bad_data as find_bad_data
from fleet_tui.text.language import Message
from fleet_tui.text.units import age

FIRST_LINK = 10.0
"""Seconds that a first connection, which nothing refuses, may take: on a busy machine it is slow."""
BAD_AFTER = 1.0
"""Seconds from bad data to its alarm: other robots may send some, too."""
BEHIND_FOR = 2.0
"""Seconds for which the console or a bridge must be behind: a map may take a moment."""
CHARGES_WITHIN = 1800.0
"""Seconds at a charger after which a battery that is still low needs a person."""
DEADLOCK_AFTER = 30.0
"""Seconds for which two robots wait for each other: one may still give way."""
STILL = 2.0
"""Seconds without a step after which a robot counts as standing."""


def contact(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise after contact with an obstacle for longer than the limit."""
    return _blocked(state, robot, last_contact(state, robot), active)


def stop(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise after a stop by its collision monitor for longer than the limit."""
    return _blocked(state, robot, last_stop(state, robot), active)


def _blocked(
    state: FleetState, robot: Robot, fact: Fact | None, active: ActiveConditions
) -> Condition | None:
    """Raise for an obstacle by a fresh report; an earlier alarm continues by the last one."""
    if fact is None:
        return None
    if not is_fresh(state, robot, fact) and not was_active(active, robot.name, robot.link, fact.kind.name):
        return None
    return fact.condition(fact.since + state.limits.obstacle_after)


def battery(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise below a limit, or until above its dead band; at a charger only if that does not help."""
    limits, reading = state.limits, robot.battery
    if reading is None or reading.value >= limits.battery_low + limits.battery_band:
        return None
    before = active.get((robot.name, "battery"))
    if reading.value >= limits.battery_low and before is None:
        return None
    was_critical = before is not None and before.priority is Priority.MEDIUM
    critical = limits.battery_critical + (limits.battery_band if was_critical else 0.0)
    # Rounded down: 19.6 is below 20, and must not read 20.
    text: Message = Message("battery {percent} %", percent=int(reading.value))
    if state.is_old(robot, "battery"):
        text += Message(", {age} ago", age=age(state.now - reading.at))
    due = -math.inf
    charges = charger_used(state, robot) is not None or charging_reported(state, robot) is not None
    if robot.standing is not None and charges:
        due = robot.standing.at + CHARGES_WITHIN
        text += Message(" after {age} at the charger", age=age(state.now - robot.standing.at))
    priority = Priority.MEDIUM if reading.value < critical else Priority.LOW
    over, remedy = Message("battery charging or recovered"), charging_remedy(state, robot)
    if charges and state.now >= due:
        remedy = LOOK_AT_CHARGER
    return Condition(robot.name, "battery", priority, text, over, due, remedy=remedy)


def pause(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise after a pause for longer than the limit."""
    last_word = robot.paused.value if robot.paused is not None else robot.paused_by_us
    if not last_word or not (state.is_paused(robot) or was_active(active, robot.name, robot.link, "pause")):
        return None
    since = state.began.get((robot.name, "pause"), state.now)
    fact = moves_despite_pause(state, robot)
    if fact is not None and fact.priority is Priority.HIGH:
        return fact.condition(fact.since)
    if fact is not None and fact.kind is DESPITE_PAUSE:
        return fact.condition(math.inf)  # it needs no alarm, and is not paused for long
    text = Message("paused for {age}", age=age(state.now - since))
    if not state.is_paused(robot) and robot.paused is not None:
        text = Message("pause last reported {age} ago", age=age(state.now - robot.paused.at))
    due = since + state.limits.pause_after
    return Condition(robot.name, "pause", Priority.LOW, text, Message("pause ended"), due)


def stuck(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise for an order to drive without movement.

    An obstacle or a pause explains it, and silence hides it: neither begins it, and none ends the alarm: a
    robot that was stuck when it was paused still is.
    """
    order, place = robot.orders.current, robot.place
    if order is None or place is None or state.now - place.at < STILL:
        return None
    if running_action(state, robot) is not None or (robot.is_estimated and says_driving(state, robot)):
        return None
    began = state.began.get((robot.name, STUCK.name), state.now)
    due = began + state.limits.stuck_after - STILL
    is_paused = is_held(state, robot)
    if is_paused and due > state.began.get((robot.name, "pause"), state.now):
        return None
    known = state.is_fresh(robot, "pose")
    # An obstacle explains it only where that is an alarm: contact that comes and goes may never be one.
    explained = not known or is_blocked_for_long(state, robot)
    explained = explained or silent_navigation(state, robot) is not None or robot.name in state.deadlocks
    if explained and not was_active(active, robot.name, robot.link, STUCK.name):
        return None
    cause, driven = cause_of_standing(state, robot), robot.order_text(order)
    text = Message(
        "{paused}{word} for {age} ({driven})",
        paused=Message("paused, ") if is_paused else "",
        word=STUCK.word,
        age=age(state.now - place.at),
        driven=driven,
    )
    if not known:
        text = Message("{driven}: not moving at last report", driven=driven)
    elif cause:
        text = Message(
            "{word} for {age}: {cause} ({driven})",
            word=STUCK.word,
            age=age(state.now - place.at),
            cause=Message(cause),
            driven=driven,
        )
    return Condition(robot.name, STUCK.name, Priority.MEDIUM, text, STUCK.over, due)


def waits_mutually(state: FleetState, robot: Robot, _active: ActiveConditions) -> Condition | None:
    """Raise for two robots that wait for each other for a while, for each of them."""
    fact = deadlock(state, robot)
    return None if fact is None else fact.condition(fact.since + DEADLOCK_AFTER)


def bad_data(state: FleetState, source: Robot | LinkState, _active: ActiveConditions) -> Condition | None:
    """Raise after unreadable data from a robot or over a link, a short while ago."""
    fact = find_bad_data(state, source)
    if fact is None:
        return None
    kind = BAD_DATA.name if isinstance(source, Robot) else "frames"
    due = state.began.get((source.name, kind), state.now) + BAD_AFTER
    return Condition(source.name, kind, fact.priority, fact.text, BAD_DATA.over, due)


def no_link(state: FleetState, link: LinkState, _active: ActiveConditions) -> Condition | None:
    """Raise without a link in either direction."""
    is_first = not (link.was_up or link.reason)
    after = max(state.limits.link_after, FIRST_LINK) if is_first else state.limits.link_after
    if state.now - link.since <= after:
        return None
    fact = links.no_link(state, link)
    return None if fact is None else fact.condition()


def dead_commands(state: FleetState, link: LinkState, active: ActiveConditions) -> Condition | None:
    """Raise if telemetry flows, but a command would not get through: a late bridge has its own alarm."""
    fact = links.dead_commands(link)
    is_news = link.phase is Phase.UP and not links.is_late(link)
    if fact is None or not (is_news or (link.name, fact.kind.name) in active):
        return None
    return fact.condition()


def offline(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise after silence for longer than the limit, pending from half of it.

    While the link is down its own alarm covers its robots; earlier alarms continue.
    """
    last, limit = robot.last_received, state.patience(robot)
    if not robot.is_gone and last is not None and state.now - last <= limit / 2:
        return None
    raised = was_active(active, robot.name, robot.link, SILENT.name)
    fact = silence(state, robot) if state.is_online(robot) else absence(state, robot)
    if raised and fact is not None and fact.kind is BAD_DATA:
        # It speaks, and nobody can tell what: it is not back yet.
        over, remedy = SILENT.over, fact.action
        return Condition(robot.name, SILENT.name, fact.priority, fact.text, over, -math.inf, remedy=remedy)
    if fact is None or fact.kind.name != SILENT.name:
        return None
    link = state.links[robot.link]
    if state.is_online(robot) if raised else (link.phase is not Phase.UP or link.hides(robot.name)):
        return None
    if not raised:
        return fact.condition(fact.since)
    # A new link restarts the silence, and ends no alarm.
    if robot.is_gone and robot.connection is not None:
        return fact.condition(robot.connection.at)
    return fact.condition((last or 0.0) + limit)


def behind(state: FleetState) -> Condition | None:
    """Raise if this console does not keep up with incoming messages for a while."""
    fact = links.behind(state)
    return None if fact is None else fact.condition(fact.since + BEHIND_FOR)


def late(state: FleetState, link: LinkState, _active: ActiveConditions) -> Condition | None:
    """Raise if a bridge is late for a while."""
    fact = links.late_link(state, link)
    return None if fact is None else fact.condition(fact.since + BEHIND_FOR)


def withheld(_state: FleetState, link: LinkState, _active: ActiveConditions) -> Condition | None:
    """Raise if a connected bridge does not pass on messages of its robots."""
    fact = links.withheld(link)
    return None if fact is None else fact.condition()


ROBOT_RULES = (
    offline,
    contact,
    stop,
    *VEHICLE_RULES,
    *MEMBER_RULES,
    *NAVIGATION_RULES,
    battery,
    pause,
    waits_mutually,
    stuck,
    bad_data,
)
LINK_RULES = (dead_commands, no_link, bad_data, late, withheld)


def conditions(state: FleetState, active: ActiveConditions) -> Iterator[Condition]:
    """Return every condition that needs a person now, or soon: see `due`."""
    own = behind(state)
    if own is not None:
        yield own
    for link in state.links.values():
        for link_rule in LINK_RULES:
            found = link_rule(state, link, active)
            if found is not None:
                yield found
    for robot in state.robots.values():
        for rule in ROBOT_RULES:
            found = rule(state, robot, active)
            if found is not None:
                yield found
    yield from facility_conditions(state)
    yield from failed_commands(state)
