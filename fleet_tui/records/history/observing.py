"""The history that a sequence of fleet states tells: it remembers only what it needs for the next one."""

from collections.abc import Iterator, Mapping
from functools import partial

from fleet_tui.model.alarm import Key
from fleet_tui.model.commands import CORRECTABLE, OPEN, ORDER_ENDS, CommandRecord, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Charge, LaterCause, LinkChange, OrderChange, Span
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.order import Order, route_text
from fleet_tui.model.order_life import OrderTrace
from fleet_tui.model.robot import Robot
from fleet_tui.orders.ends import EVIDENCE_WITHIN, ended_orders, given_elsewhere, placed_by, seen_end
from fleet_tui.orders.local_queue import GOING
from fleet_tui.situation.activity import activity, may_do_anything
from fleet_tui.situation.alarms.past import told
from fleet_tui.situation.why.reason import name_of
from fleet_tui.text.language import EMPTY, Message, joined

HOUR = 3600.0
"""Seconds at whose multiples spans are cut, so that a few hours of them are found quickly."""
EVERY = 60.0
"""Seconds after which a battery is told again."""
GOES_ON = 15.0
"""Seconds after which an activity that goes on is told again: a killed process loses no more."""
SLEPT = 60.0
"""Seconds between two states, by the clock, after which what was between them is unknown: the machine
slept, or its clock was set."""
PERCENT = 1.0
"""A change of a battery that is told at once."""
QUEUED = "queued"
BEGUN = "begun"

_Gone = tuple[str, float]
"""The id of an order, and when it left the queue."""
Fact = Span | Charge | OrderChange | LinkChange | LaterCause


class Observer:
    """Compares each state with the one before it."""

    def __init__(self) -> None:
        self._spans: dict[str, Span] = {}
        self._told: dict[str, float] = {}
        self._charges: dict[str, Charge] = {}
        self._traces: dict[str, Mapping[str, OrderTrace]] = {}
        self._told_by: dict[tuple[str, str], str] = {}
        """The goal that told of an order of another console, by robot and first goal, which may have ended
        before it was known whose it was."""
        self._links: dict[str, bool] = {}
        self._causes: dict[Key, Message] = {}
        self._ends: dict[str, dict[_Gone, Stage]] = {}
        """The ends of the orders that left each robot's queue, as told: one may be corrected."""

    def observe(self, state: FleetState) -> Iterator[Fact]:
        """Return what is new in a state. Robots count from their first message on."""
        for link in state.links.values():
            yield from self._link(state, link)
        for robot in state.robots.values():
            if robot.last_received is None:
                continue
            yield from self._orders(state, robot)
            yield from self._span(state, robot)
            yield from self._charge(state, robot)
        yield from self._later_causes(state)

    def finish(self) -> Iterator[Fact]:
        """Return the spans that still go on, as long as they were observed."""
        yield from (span for span in self._spans.values() if span.ended > span.began)

    def _link(self, state: FleetState, link: LinkState) -> Iterator[LinkChange]:
        is_up = link.phase is Phase.UP
        if link.name not in self._links and link.phase is Phase.CONNECTING:
            return  # neither up nor down yet
        if self._links.get(link.name) != is_up:
            yield LinkChange(link.name, _wall(state, link.since), is_up, "" if is_up else link.reason)
        self._links[link.name] = is_up

    def _later_causes(self, state: FleetState) -> Iterator[LaterCause]:
        causes = {alarm.key: told(alarm) for alarm in state.alarms if alarm.holds}
        for alarm in state.alarms:
            text = causes.get(alarm.key, alarm.first_text)
            if text not in (alarm.first_text, self._causes.get(alarm.key)):
                yield LaterCause(alarm.condition.source, alarm.condition.kind, text)
        self._causes = causes

    def _orders(self, state: FleetState, robot: Robot) -> Iterator[OrderChange]:
        yield from self._order_ends(state, robot)
        traces = self._traces.get(robot.name)
        if traces is robot.traces or _is_sending(state, robot) or _may_be_told(state, robot):
            return
        self._traces[robot.name] = robot.traces
        for id_, trace in robot.traces.items():
            record = placed_by(state, robot, trace.order)
            elsewhere = given_elsewhere(state, robot, trace.order)
            if record and record.earlier_goals:
                continue  # it was told with its first goal
            if elsewhere and self._told_by.setdefault((robot.name, elsewhere.goals[0]), id_) != id_:
                continue
            known = traces.get(id_) if traces else None
            if known is not None and not _is_same(known.order, trace.order):
                known = None
            begun = state.now if trace.began_at is None else trace.began_at
            if known is None:
                taken = state.now if trace.order.taken_at is None else trace.order.taken_at
                yield _change(state, robot, trace.order, record, min(taken, begun), QUEUED)
            if trace.begun and not (known and known.begun):
                yield _change(state, robot, trace.order, record, begun, BEGUN)
        known_there = {(one.robot, one.goals[0]) for one in state.desk.elsewhere if one.goals}
        self._told_by = {first: told for first, told in self._told_by.items() if first in known_there}

    def _order_ends(self, state: FleetState, robot: Robot) -> Iterator[OrderChange]:
        told, now = self._ends.get(robot.name, {}), dict[_Gone, Stage]()
        for gone in ended_orders(state, robot):
            key = gone.order.id, gone.at
            before = told.get(key)
            if before is not None and before not in CORRECTABLE:
                now[key] = before
                continue
            end = seen_end(state, robot, gone)
            if end.is_open:
                continue
            now[key] = end.stage
            if before is not end.stage:
                record = placed_by(state, robot, gone.order)
                yield _change(state, robot, gone.order, record, gone.at, end.stage.value, end.reason)
        for key, change in _ends_between_goals(state, robot):
            now[key] = Stage(change.stage)
            if key not in told:
                yield change
        if now or told:
            self._ends[robot.name] = now

    def _span(self, state: FleetState, robot: Robot) -> Iterator[Span]:
        does, now, before = activity(state, robot), state.wall, self._spans.get(robot.name)
        place = (robot.floor or "", *_at(robot))
        # It may work on, unseen.
        is_unknown = state.links[robot.link].phase is not Phase.UP or may_do_anything(state, robot)
        if before is not None and (is_unknown or now - before.ended > SLEPT):
            yield self._spans.pop(robot.name)
            before = None
        if is_unknown:
            return
        if before is None:
            self._spans[robot.name] = Span(robot.name, does, now, now, *place)
            self._told[robot.name] = now
            return
        same = _until(before, now)
        self._spans[robot.name] = same
        has_changed = (does, place[0]) != (before.activity, before.floor)
        if has_changed or before.began // HOUR != now // HOUR or abs(now - self._told[robot.name]) >= GOES_ON:
            yield same
            self._told[robot.name] = now
        if has_changed or before.began // HOUR != now // HOUR:
            self._spans[robot.name] = Span(robot.name, does, now, now, *place)

    def _charge(self, state: FleetState, robot: Robot) -> Iterator[Charge]:
        if robot.battery is None or not state.is_fresh(robot, "battery"):
            return
        now, percent, before = state.wall, robot.battery.value, self._charges.get(robot.name)
        if before is None or abs(percent - before.percent) >= PERCENT or abs(now - before.at) >= EVERY:
            self._charges[robot.name] = Charge(robot.name, now, percent)
            yield self._charges[robot.name]


def _until(span: Span, now: float) -> Span:
    """A clock that was set back must not end a span before it began."""
    return Span(span.robot, span.activity, span.began, max(span.began, now), span.floor, span.x, span.y)


def _is_sending(state: FleetState, robot: Robot) -> bool:
    """Tell whether a goal of this console has left, and is not known by its id yet: it may be listed."""
    return robot.kind.keeps_goals and any(
        one.command.robot == robot.name and isinstance(one.command, PlaceOrder) and one.stage in GOING
        for one in state.commands
    )


def _may_be_told(state: FleetState, robot: Robot) -> bool:
    """Tell whether another console drives an order of a robot goal by goal, and may just now tell that a new
    goal belongs to it."""
    is_driven = any(
        one.robot == robot.name
        and one.way
        and (one.stage in GOING or (one.goals and one.stage not in ORDER_ENDS))
        for one in state.desk.elsewhere
    )
    return is_driven and any(
        given_elsewhere(state, robot, trace.order) is None
        and trace.listed_at is not None
        and state.now - trace.listed_at < EVIDENCE_WITHIN
        for trace in robot.traces.values()
    )


def _ends_between_goals(state: FleetState, robot: Robot) -> Iterator[tuple[_Gone, OrderChange]]:
    """Yield the ends of orders that ended while their console kept the next goal, or as it was not taken."""
    for record in state.commands:
        command = record.command
        if command.robot != robot.name or not isinstance(command, PlaceOrder):
            continue
        if record.earlier_goals and record.is_decided and record.order_serial is None:
            first = record.earlier_goals[0]
            end, reason = _end_of(record.stage, record.detail)
            order = Order(first, command.stops, None, "", 0)
            yield (first, record.at), _change(state, robot, order, record, record.at, end, reason)
    for one in state.desk.elsewhere:
        if one.robot == robot.name and one.goes_on and one.stage not in OPEN:
            first = one.goals[0]
            end, reason = _end_of(one.stage)
            order = Order(first, (), None, "", 0)
            yield (first, one.at), _change(state, robot, order, None, state.now, end, reason)


def _end_of(stage: Stage, detail: Message = EMPTY) -> tuple[str, Message]:
    """Return the end and the reason of an order whose next goal was not taken."""
    if stage in ORDER_ENDS:
        return stage.value, detail
    return Stage.FAILED.value, joined(": ", filter(None, (Message(stage.value), detail)))


def _is_same(one: Order, other: Order) -> bool:
    return (one.serial, one.stops) == (other.serial, other.stops)


def _at(robot: Robot) -> tuple[float, float]:
    return (robot.pose.value.x, robot.pose.value.y) if robot.pose else (0.0, 0.0)


def _wall(state: FleetState, at: float) -> float:
    return state.wall - (state.now - at)


def _change(
    state: FleetState,
    robot: Robot,
    order: Order,
    record: CommandRecord | None,
    at: float,
    stage: str,
    reason: str = "",
) -> OrderChange:
    """`record` placed it; None for another client's."""
    elsewhere = given_elsewhere(state, robot, order)
    way = order.label or route_text(order.stops, partial(name_of, robot))
    request = record.id if record else None
    name = record.earlier_goals[0] if record and record.earlier_goals else order.id
    if elsewhere is not None:
        way = elsewhere.way
        name = elsewhere.goals[0]
    return OrderChange(robot.name, name, way, _wall(state, at), stage, robot.floor or "", reason, request)
