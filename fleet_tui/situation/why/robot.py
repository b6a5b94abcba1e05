"""Reasons to stand still from the robot: its own reports, and whether it is online."""

from functools import partial

from fleet_tui.model.alarm import Priority
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState, obstacle_text
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.robot import Robot
from fleet_tui.orders.newest import own_pause
from fleet_tui.situation import links
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.situation.battery.charging import (
    CHARGES,
    charger_used,
    charging_remedy,
    charging_reported,
    has_low_battery,
)
from fleet_tui.situation.facts import BAD_DATA, MISPLACED, NO_POSE
from fleet_tui.situation.localisation import no_pose
from fleet_tui.situation.movement import JUMPS_WITHIN
from fleet_tui.situation.pauses import is_held, own_pause_text
from fleet_tui.situation.pose_checks.jumps import recent_jumps
from fleet_tui.situation.pose_checks.misplaced import (
    OFF_ROUTE,
    is_misplaced,
    misplaced_for_long,
    misplaced_text,
)
from fleet_tui.situation.pose_checks.off_route import is_off_route, metres_off
from fleet_tui.situation.reported_motion import STANDS_AFTER, moves_despite_pause, says_driving
from fleet_tui.situation.robots import absence, last_contact, silent
from fleet_tui.situation.why.reason import LOOK_AT, Reason, Strength, name_of, reason_of, stationary_since
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.units import age, ago, duration

WRONG_POSE = Message("Set its pose to where it stands, or check its localisation")
DIAGNOSE = ("diagnostics",)
FULL = 95.0
"""Per cent below which a robot at a charger may be charging."""


_UNRESOLVED = frozenset(
    {Stage.SENT, Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN, Stage.NOT_CONFIRMED, Stage.LATE}
)
"""States in which a pause may hold the robot without evidence."""


def moves(state: FleetState, robot: Robot) -> Reason | None:
    """Report that the robot is driving: by its own word if it has one."""
    says = says_driving(state, robot)
    if says is not None and robot.vehicle is not None:
        name = Message("{name} is driving", name=robot.name)
        return Reason(name, Message("reported by the vehicle"), seen=robot.vehicle.at) if says else None
    since = stationary_since(robot)
    if robot.pose is None or since is None or state.is_old(robot, "pose"):
        return None
    if state.now - since >= STANDS_AFTER:
        return None
    evidence = Message("pose changed {ago}", ago=ago(since, state.now))
    return Reason(Message("{name} is driving", name=robot.name), evidence, seen=robot.pose.at)


def no_link(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its state is unknown without a link, or behind a bridge that is half dead."""
    link = state.links[robot.link]
    if (lost := links.no_link(state, link)) is not None:
        return reason_of(lost, since=lost.since)
    fact = links.hidden(link, robot.name)
    if fact is None or (state.is_online(robot) and not link.is_half_dead):
        return None
    return reason_of(fact)


def unreachable(state: FleetState, robot: Robot) -> Reason | None:
    """Report that no command gets through, though its messages arrive: likely why it has no order."""
    link = state.links[robot.link]
    fact = links.dead_commands(link)
    if fact is None or link.phase is not Phase.UP or link.command_path is not CommandPath.DEAD:
        return None
    if link.is_half_dead:
        return None  # that is told first of all
    return reason_of(fact, Strength.LIKELY if robot.orders.current is None else Strength.POSSIBLE)


def late_link(state: FleetState, robot: Robot) -> Reason | None:
    """Report that newer messages of a robot may still come: its bridge is late."""
    link = state.links[robot.link]
    fact = links.late_link(state, link)
    if fact is None or (state.is_online(robot) and not state.is_old(robot, "pose")):
        return None
    name, evidence = (
        Message("messages {duration} late", duration=duration(link.late)),
        Message("bridge of {name} overloaded", name=link.name),
    )
    return Reason(name, evidence, keys=fact.kind.keys, remedy=fact.action)


def silent_robot(state: FleetState, robot: Robot) -> Reason | None:
    """Report that it is offline while the link is up: certain unless its bridge is late by as much."""
    fact = absence(state, robot)
    if fact is None or state.links[robot.link].phase is not Phase.UP or state.is_online(robot):
        return None
    strength = Strength.CERTAIN if fact.is_certain else Strength.POSSIBLE
    beside = [other for other in state.robots.values() if other.link == robot.link]
    remedy = fact.action
    if fact.kind is not BAD_DATA and len(beside) > 1 and all(map(partial(silent, state), beside)):
        remedy = Message(
            "All {beside} robots of {link} are silent: check its bridge and the network first",
            beside=len(beside),
            link=robot.link,
        )
    keys, page = fact.kind.keys, fact.kind.page
    return Reason(fact.short, fact.evidence, strength, robot.last_received, fact.seen, keys, remedy, page)


def paused(state: FleetState, robot: Robot) -> Reason | None:
    """Report a pause: by its own report, or by our accepted pause if it sends none."""
    if not is_held(state, robot):
        return None
    record = own_pause(state, robot)
    since = record.time_of(Stage.SENT) if record is not None else None
    if robot.paused is None:
        name = own_pause_text(state, robot)
        return Reason(name, Message("pause accepted by the robot"), since=since, keys=("resume",))
    is_own = since is not None
    by = Message("sent by this console") if is_own else Message("not sent by this console")
    return Reason(
        Message("paused") if is_own else Message("paused (elsewhere)"),
        by,
        since=since,
        seen=robot.paused.at,
        keys=("resume",),
    )


def not_stopped(state: FleetState, robot: Robot) -> Reason | None:
    """Report that it is paused and does not stand: it brakes, moves on, or is driven by another client."""
    fact = moves_despite_pause(state, robot)
    if fact is None:
        return None
    keys, remedy = fact.kind.keys, fact.action if fact.priority is not Priority.LOW else EMPTY
    return Reason(fact.text, fact.evidence, since=fact.since, seen=fact.seen, keys=keys, remedy=remedy)


def own_late_pause(state: FleetState, robot: Robot) -> Reason | None:
    """Report a pause from here that may still take effect, or took it late, if no topic reports it."""
    record = own_pause(state, robot)
    if record is None or state.is_paused(robot) or record.stage not in _UNRESOLVED:
        return None
    return Reason(
        Message("pause from this console: {stage}", stage=Message(record.stage.value)),
        record.detail or Message("issued {age} ago", age=age(state.now - record.issued_at)),
        Strength.LIKELY,
        since=record.issued_at,
        keys=("resume",),
    )


def obstacle(state: FleetState, robot: Robot) -> Reason | None:
    """Report contact with an obstacle; a short contact may be a passing one."""
    contact, is_old = robot.obstacle, state.is_old(robot, "obstacle")
    lasts = last_contact(state, robot) is not None
    if contact is None or contact.value <= 0.0 or (is_old and not lasts):
        return None
    strength = Strength.CERTAIN if lasts else Strength.LIKELY
    evidence = Message("obstacle contact: clear the path at the robot")
    return Reason(
        obstacle_text(state, robot, contact),
        evidence if not is_old else Message("last report, none received since"),
        strength if not is_old else Strength.POSSIBLE,
        since=contact.at - contact.value,
        seen=contact.at,
        keys=(*LOOK_AT, "cancel") if robot.orders.open else LOOK_AT,
    )


def unread(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its bridge cannot read its messages, if its pose or its orders are not known."""
    fact = links.unsourced(state.links[robot.link])
    expected = filter(robot.kind.expects, ("pose", "queue"))
    if fact is None or all(state.is_fresh(robot, value) for value in expected):
        return None
    return reason_of(fact)


def stale_pose(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its pose is old while its other values are fresh: it may be moving."""
    lost = no_pose(state, robot) if state.is_online(robot) else None
    if lost is None or links.unsourced(state.links[robot.link]) is not None:
        return None  # else that is the cause
    if robot.pose is None:
        return reason_of(lost)
    if (fact := absence(state, robot)) is not None:
        return Reason(fact.short, fact.evidence, seen=fact.seen)
    return reason_of(lost, since=lost.since)


def jumps(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its localisation jumps: most robots then stop, and the pose means nothing."""
    recent = recent_jumps(robot, state.now)
    if not recent:
        return None
    last, name = (
        recent[-1],
        Message("pose jumps: {jumps} in {seconds} s", jumps=len(recent), seconds=f"{JUMPS_WITHIN:.0f}"),
    )
    evidence, keys = (
        Message("last by {metres} m: do not trust its pose", metres=f"{last.value:.1f}"),
        ("pose", "centre", *DIAGNOSE),
    )
    return Reason(name, evidence, since=recent[0].at, seen=last.at, keys=keys, remedy=NO_POSE.action)


def misplaced(state: FleetState, robot: Robot) -> Reason | None:
    """Report a pose at which it cannot be: its localisation is wrong, or it is on another floor."""
    text, found = misplaced_text(state, robot), robot.misplaced
    if not text or robot.pose is None or found is None or text == OFF_ROUTE:
        return None  # off its routes is another rule's, with the metres
    pose, is_now = robot.pose.value, is_misplaced(robot)
    evidence: Message = Message(
        "no robot can be at {x}, {y} m on {floor}", x=f"{pose.x:.1f}", y=f"{pose.y:.1f}", floor=robot.floor
    )
    evidence = evidence if is_now else Message("its pose was just at an impossible place")
    is_sure = is_now or misplaced_for_long(state, robot) is not None
    strength = Strength.CERTAIN if is_sure else Strength.LIKELY
    strength = strength if state.is_fresh(robot, "pose") else Strength.POSSIBLE
    remedy, keys = to_place(state, robot)
    name = Message("{word}: {fault}", word=MISPLACED.word, fault=text)
    return Reason(name, evidence, strength, seen=found.at, keys=keys, remedy=remedy)


def off_graph(state: FleetState, robot: Robot) -> Reason | None:
    """Report a pose beside all edges of a robot with an order that drives only on these."""
    if robot.pose is None or not state.is_fresh(robot, "pose") or not is_off_route(robot):
        return None
    name, evidence = (
        Message(
            "{word}: {metres_off} m off the route graph",
            word=MISPLACED.word,
            metres_off=f"{metres_off(robot):.1f}",
        ),
        Message("its order leads along the edges"),
    )
    strength = Strength.LIKELY if misplaced_for_long(state, robot) is None else Strength.CERTAIN
    remedy, keys = to_place(state, robot)
    return Reason(name, evidence, strength, seen=robot.pose.at, keys=keys, remedy=remedy)


def to_place(state: FleetState, robot: Robot) -> tuple[Message, tuple[str, ...]]:
    """Return what to do about a wrong pose, and its keys: while a robot drives none is set."""
    if robot.orders.current is None or is_held(state, robot):
        return WRONG_POSE, ("pose", "centre")
    return CLASSES["localisation"].action, ("pause", "pose", "centre")


def charges(state: FleetState, robot: Robot) -> Reason | None:
    """Report that it is at a charger, is not full, and drives no order; by its own word whatever its orders
    are. That explains a low battery, and that it has no order."""
    charger, battery, since = charger_used(state, robot), robot.battery, stationary_since(robot)
    keys, remedy = ((), CHARGES) if has_low_battery(state, robot) else (("order",), EMPTY)
    if (reported := charging_reported(state, robot)) is not None:
        is_own = reported is robot.vehicle
        by = Message("reported by the vehicle") if is_own else Message("reported by its driver")
        return Reason(Message("charging"), by, Strength.LIKELY, since, reported.at, keys, remedy)
    if charger is None or battery is None or battery.value >= FULL:
        return None
    evidence = Message("at the charger, battery {percent} %, no order active", percent=int(battery.value))
    name = Message("charging at {name_of}", name_of=name_of(robot, charger.id))
    return Reason(name, evidence, Strength.LIKELY, since, battery.at, keys, remedy)


def battery(state: FleetState, robot: Robot) -> Reason | None:
    """Report a low battery: many robots drive no order on the last of their charge; fewer respect the low
    limit."""
    charge, limits = robot.battery, state.limits
    if charge is None or charge.value >= max(limits.battery_low, limits.battery_critical):
        return None
    if charges(state, robot) is not None:
        return None  # which explains it
    critical = charge.value < limits.battery_critical and not state.is_old(robot, "battery")
    limit = limits.battery_critical if critical else limits.battery_low
    strength = Strength.LIKELY if critical else Strength.POSSIBLE
    evidence = Message(
        "below {limit} %: the robot may reserve the rest to reach a charger", limit=f"{limit:.0f}"
    )
    name, on_its_way = (
        Message("battery {percent} %", percent=int(charge.value)),
        charging_remedy(state, robot),
    )
    remedy, keys = (on_its_way, ()) if on_its_way else (CLASSES["battery"].action, ("charge",))
    return Reason(name, evidence, strength, seen=charge.at, keys=keys, remedy=remedy)
