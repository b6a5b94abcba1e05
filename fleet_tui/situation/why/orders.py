"""Reasons to stand still from the robot's orders, and from robots in its way."""

from collections.abc import Iterator

from fleet_tui.model.commands import (
    FAILURES,
    ORDER_ENDS,
    CancelOrder,
    ClearOrders,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.robot_numbers import LAST_KEY, mark_of
from fleet_tui.orders.ends import seen_end
from fleet_tui.orders.local_queue import waiting
from fleet_tui.orders.newest import last_command
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.situation.causes import cause_of_end, remedy_of
from fleet_tui.situation.deadlocks import deadlock
from fleet_tui.situation.facts import STUCK
from fleet_tui.situation.failures import failure_remedy
from fleet_tui.situation.links import is_late, unsourced
from fleet_tui.situation.navigation import silent_navigation
from fleet_tui.situation.reported_motion import is_stuck, waits_for
from fleet_tui.situation.robots import last_contact
from fleet_tui.situation.traffic import in_the_way, next_stop, vertex_here
from fleet_tui.situation.why.reason import (
    LOOK_AT,
    RECENT,
    Reason,
    Strength,
    mission,
    name_of,
    reason_of,
    stationary_since,
)
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import EMPTY, Message, joined
from fleet_tui.text.units import age

SHORT = 20.0
"""Seconds of standing with an order that need no cause."""
RESTART = Message("Restart the program that carries out its orders, then check them")
LOOK = Message("Go and check its path, wheels, emergency stop and manual mode")


def command(state: FleetState, robot: Robot) -> Reason | None:
    """Report that a command to drive is open, or failed a short while ago."""
    record = last_command(state, robot, ResumeRobot if state.is_paused(robot) else PlaceOrder)
    if record is None or (robot.orders.current is not None and not state.is_paused(robot)):
        return None
    failed = record.stage in FAILURES and state.now - record.at < RECENT
    if record.is_decided and not failed:
        return None
    verb = "resume" if isinstance(record.command, ResumeRobot) else "order"
    evidence = record.detail or Message("issued {age} ago", age=age(state.now - record.issued_at))
    strength = Strength.LIKELY if robot.orders.open else Strength.CERTAIN
    keys = (verb,) if failed else ()
    remedy = failure_remedy(state, robot, record) or CLASSES["command"].action if failed else EMPTY
    if record.stage is Stage.FAILED and remedy_of(evidence):
        keys = (*LOOK_AT, *keys, "diagnostics")
    stage = Message(record.stage.value)
    # A failure as its alarm and its row have it.
    name = Message("{verb}: {stage}", verb=verb, stage=stage)
    if failed:
        name = Message("{stage}: {verb}", verb=verb, stage=stage)
    return Reason(name, evidence, strength, since=record.at, keys=keys, remedy=remedy, page="log")


def failed_order(state: FleetState, robot: Robot) -> Reason | None:
    """Report that the last order ended otherwise than it should, whoever gave it, and none came since."""
    last = robot.gone[-1] if robot.gone else None
    if last is None or robot.orders.open or command(state, robot) is not None:
        return None
    end = seen_end(state, robot, last)
    if end.stage not in (Stage.FAILED, Stage.LEFT, Stage.LOST):
        return None
    evidence, cause = mission(robot, last.order), cause_of_end(robot, last)
    name = (
        Message("last order failed: {cause}", cause=cause)
        if cause
        else Message("last order failed, no reason reported")
    )
    remedy = remedy_of(cause)
    keys = (*(LOOK_AT if remedy else ()), "order", "diagnostics")
    remedy = remedy or CLASSES["command"].action
    if end.stage is not Stage.FAILED:
        name, evidence = (
            Message("last order {stage}", stage=Message(end.stage.value)),
            Message("{evidence}{detail}", evidence=evidence, detail=detail_text(end.reason)),
        )
        remedy = ORDER_ENDS[end.stage].remedy
    return Reason(name, evidence, since=last.at, keys=keys, remedy=remedy, page="log")


def cargo(state: FleetState, robot: Robot) -> Reason | None:
    """Report cargo without a destination."""
    if not robot.has_cargo or robot.queue is None or robot.orders.open:
        return None
    strength = Strength.POSSIBLE if state.is_old(robot, "queue") else Strength.CERTAIN
    evidence = Message("cargo on board, no orders: order a destination")
    return Reason(
        Message("cargo without destination"), evidence, strength, seen=robot.queue.at, keys=("order",)
    )


def no_orders(state: FleetState, robot: Robot) -> Reason | None:
    """Report that it has no order."""
    if not robot.kind.lists_orders or waiting(state, robot):
        return None
    if robot.queue is None:
        if robot.kind.expects("queue"):
            return Reason(Message("queue unknown"), Message("no queue received"), Strength.POSSIBLE)
        return Reason(
            Message("no orders"), Message("none reported so far"), Strength.POSSIBLE, keys=("order",)
        )
    if robot.orders.open or robot.has_cargo:
        return None
    record = last_command(state, robot, PlaceOrder, ClearOrders, CancelOrder)
    taken = record is not None and isinstance(record.command, ClearOrders | CancelOrder)
    evidence = Message(
        "{state}: waiting for an order",
        state=Message("no goal") if robot.kind.keeps_goals else Message("queue empty"),
    )
    if record is not None and taken and record.stage is Stage.CONFIRMED:
        evidence = Message("removed from the queue by this console {age} ago", age=age(state.now - record.at))
    strength = Strength.POSSIBLE if state.is_old(robot, "queue") else Strength.CERTAIN
    return Reason(Message("no orders"), evidence, strength, seen=robot.queue.at, keys=("order",))


FAIR_SHARE = 0.5
"""Of a robot's standstill: for so long another one must have stood before it to be the cause."""


def at_stop(state: FleetState, robot: Robot) -> Reason | None:
    """Report a stop: loading and unloading take a moment. For as long as counts as stuck they explain
    nothing."""
    order, here, since = robot.orders.current, vertex_here(robot), stationary_since(robot)
    if order is None or since is None or here is None or here != next_stop(robot):
        return None
    does = (
        Message("stops")
        if not robot.kind.brings_cargo
        else Message("unloading")
        if robot.has_cargo
        else Message("loading")
    )
    strength = Strength.LIKELY if state.now - since < RECENT else Strength.POSSIBLE
    strength = Strength.NONE if state.now - since >= state.limits.stuck_after else strength
    return Reason(
        Message("{does} at {name_of}", does=does, name_of=name_of(robot, here)),
        Message("for {mission}", mission=mission(robot, order)),
        strength,
        since,
    )


def waits_mutually(state: FleetState, robot: Robot) -> Reason | None:
    """Report a robot that waits for this one while this one waits for it."""
    fact = deadlock(state, robot)
    return None if fact is None else reason_of(fact, Strength.LIKELY, fact.since)


def waits_behind(state: FleetState, robot: Robot) -> Reason | None:
    """Report another robot on the next vertices and edges of its way: one without an order may be parked
    where there is room to pass."""
    found = in_the_way(state, robot)
    if found is None or robot.name in state.deadlocks:  # else that is another reason
        return None
    other = found.robot
    stood, waited = (state.now - (stationary_since(one) or state.now) for one in (other, robot))
    if stood < waited * FAIR_SHARE:
        return None  # it has just come, and is not the cause
    mark = mark_of(state, other)
    return Reason(
        Message("waiting behind {name}", name=other.name),
        Message(
            "{name} is {ahead} m ahead on the way to {name_of}",
            name=other.name,
            ahead=f"{found.ahead:.1f}",
            name_of=name_of(robot, found.vertex),
        ),
        Strength.LIKELY if other.orders.current is not None else Strength.POSSIBLE,
        since=stationary_since(other),
        seen=other.pose.at if other.pose else None,
        keys=(f"robot_{mark}" if 1 <= int(mark) <= LAST_KEY else "next_robot",),
    )


def none_current(_state: FleetState, robot: Robot) -> Reason | None:
    """Report orders of which none has begun."""
    waiting = robot.orders.open
    if robot.queue is None or not waiting or robot.orders.current is not None:
        return None
    evidence = Message("first: {mission}", mission=mission(robot, waiting[0]))
    name = Message("{waiting} orders queued but not started", waiting=len(waiting))
    if len(waiting) == 1:
        name = Message("order {id} queued but not started", id=waiting[0].id)
    seen, keys = robot.queue.at, ("clear", "order")
    return Reason(name, evidence, Strength.LIKELY, seen=seen, keys=keys, remedy=LOOK, page="log")


def stale_queue(state: FleetState, robot: Robot) -> Reason | None:
    """Report that its orders are not listed any more, while the robot itself reports."""
    if robot.queue is None or robot.orders.current is None or not state.is_old(robot, "queue"):
        return None
    if silent_navigation(state, robot) is not None or unsourced(state.links[robot.link]) is not None:
        return None  # that is the cause
    if not state.is_online(robot) or is_late(state.links[robot.link]):
        return None
    evidence = Message(
        "its other reports arrive: the program that carries out its orders has probably stopped"
    )
    return Reason(
        Message("queue {age} old", age=age(state.now - robot.queue.at)),
        evidence,
        Strength.LIKELY,
        keys=("diagnostics",),
        remedy=RESTART,
    )


def _ruled_out(state: FleetState, robot: Robot) -> Iterator[Message]:
    if robot.obstacle is not None and last_contact(state, robot) is None:
        yield Message("no obstacle")
    if robot.paused is not None and not state.is_paused(robot):
        yield Message("no pause")


def unexplained(state: FleetState, robot: Robot) -> Reason | None:
    """Report an active order without an explanation for standing."""
    order, since = robot.orders.current, stationary_since(robot)
    if order is None and not robot.kind.lists_orders:
        evidence = Message("this kind of robot does not report its orders")
        return Reason(Message("cause unknown"), evidence, Strength.NONE, since, remedy=LOOK)
    if order is None:
        return None
    ruled_out = joined(", ", _ruled_out(state, robot))
    evidence = Message(
        "{mission} active{ruled_out}", mission=mission(robot, order), ruled_out=ruled_out and "; " + ruled_out
    )
    waited = age(waits_for(state, robot))
    if since is not None and waits_for(state, robot) < SHORT:  # a turn, a crossing, loading: it may drive on
        return Reason(Message("waiting {age}, nothing wrong so far", age=waited), evidence, Strength.NONE)
    word = STUCK.word if is_stuck(state, robot) else Message("waiting")
    name = Message("{word} {age}: cause unknown", word=word, age=waited)
    kind = STUCK
    return Reason(name, evidence, Strength.NONE, since, keys=kind.keys, remedy=LOOK, page=kind.page)
