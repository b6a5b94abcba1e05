"""The sections of a robot's page: state, route, orders, alarms, commands."""

from collections.abc import Callable, Iterator, Sequence
from textwrap import wrap

from msgspec import Struct

from fleet_tui.commands.routes.remaining import metres_left
from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.audit_record import PastAlarm
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.alarms.facilities import listed
from fleet_tui.situation.traffic import stops_left
from fleet_tui.situation.why.complaints import Complaint
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import SIGNS
from fleet_tui.ui.view.tables.doing import page_texts
from fleet_tui.ui.view.tables.missions import progress_text, way, whose_mission
from fleet_tui.ui.view.tables.news import with_commas
from fleet_tui.ui.view.tables.selected_robot import NAME, command_rows, ended_rows, named, value_rows
from fleet_tui.ui.view.tables.table import Run, cut, width_of

STATE = 47
"""Cells of a value with its age."""
LAST = 5
"""Waiting orders and alarms that are listed."""

Line = tuple[Run, ...]
Clock = Callable[[float], str]
"""Formats Unix seconds as a local time."""


SHOWN = 12
"""Properties that are listed."""


class PageSection(Struct, frozen=True):
    """Lines under a title, or the text that is shown without one."""

    title: tuple[Run, ...]
    lines: Sequence[Line]
    empty: str = ""

    def drawn(self, width: int) -> list[Line]:
        """Return the title in a rule and the lines, each `width` cells wide."""
        title = (("─ ", StyleRole.RULE), *self.title, (" ", StyleRole.RULE))
        rule = ("─" * max(0, width - width_of(title)), StyleRole.RULE)
        lines = self.lines or [((self.empty, StyleRole.DIM),)]
        return [cut(line, width) for line in ((*title, rule), *lines)]


def _titled(title: str, lines: Iterator[Line], empty: str) -> PageSection:
    return PageSection(((title, StyleRole.TITLE),), [line for line in lines if line], empty)


def state_section(state: FleetState, robot: Robot, complaints: Sequence[Complaint] = ()) -> PageSection:
    """Return the news, the robot's own complaints, and each value with its age."""
    return _titled(tr("State"), _state(state, robot, complaints), "")


def _state(state: FleetState, robot: Robot, complaints: Sequence[Complaint]) -> Iterator[Line]:
    holding = [one for one in state.alarms if one.holds and one.condition.source == robot.name]
    alarms = [
        (translate(sanitize(one.text)), StyleRole.ALARM if one.needs_acknowledgement else StyleRole.WARN)
        for one in holding
    ]
    does = page_texts(state, robot)
    alarms = [one for one in alarms if one[0] not in {text for text, _ in does}]
    for n, runs in enumerate(
        _packed(with_commas([*does, *(alarms if len(does) == 1 else [])]), STATE - NAME)
    ):
        yield named("" if n else tr("State"), *runs)
    for one in complaints:
        role = StyleRole.ALARM if one.is_error else StyleRole.WARN
        for n, runs in enumerate(_packed([(sanitize(one.text), role)], STATE - NAME)):
            yield named(tr("") if n else tr("Reports"), *runs)
    yield from value_rows(state, robot, STATE)
    yield from vehicle_rows(state, robot)


def _packed(runs: Sequence[Run], cells: int) -> list[list[Run]]:
    """Return runs in lines of at most `cells` cells, with a space between two; longer ones in pieces."""
    lines: list[list[Run]] = [[]]
    for run in ((piece, role) for text, role in runs for piece in wrap(text, cells - 1)):
        if lines[-1] and width_of([*lines[-1], run]) + len(lines[-1]) > cells:
            lines.append([])
        lines[-1].append(run)
    return lines


def factsheet_section(robot: Robot) -> PageSection:
    """Return the properties of a vehicle."""
    return _titled(tr("Factsheet"), factsheet_rows(robot), "")


def route_section(state: FleetState, robot: Robot) -> PageSection:
    """Return the current order, its stops that are left, and the metres."""
    return _titled(
        tr("Route"),
        _route(state, robot),
        tr("no order started yet") if robot.orders.open else tr("no order in process"),
    )


def _route(state: FleetState, robot: Robot) -> Iterator[Line]:
    order = robot.orders.current
    if order is None:
        return
    yield named(tr("Order"), (whose_mission(state, robot, order), StyleRole.TEXT))
    yield named(tr("Stops"), (way(robot, stops_left(robot, order)), StyleRole.TEXT))
    if progress := progress_text(state, robot, order):
        yield named(tr("Left"), (progress, StyleRole.TEXT))
        return
    metres = metres_left(robot, order)
    if metres is None or robot.pose is None:
        yield named(tr("Left"), (tr("no path on the graph is known"), StyleRole.DIM))
    elif state.is_old(robot, "pose"):
        seen = tr(
            "{metres} m from its pose {age} ago", metres=f"{metres:.0f}", age=age(state.now - robot.pose.at)
        )
        yield named(tr("Left"), (seen, StyleRole.WARN))
    else:
        yield named(tr("Left"), (tr("{metres} m on the graph", metres=f"{metres:.0f}"), StyleRole.TEXT))


def orders_section(state: FleetState, robot: Robot) -> PageSection:
    """Return the orders that wait, and how the last ones ended."""
    return _titled(
        tr("Orders"),
        _orders(state, robot),
        tr("no further orders") if robot.orders.current else tr("no orders"),
    )


def _orders(state: FleetState, robot: Robot) -> Iterator[Line]:
    if robot.queue is not None and state.is_old(robot, "queue"):
        yield named(tr("Queue"), (tr("{age} old", age=age(state.now - robot.queue.at)), StyleRole.WARN))
    waiting = [order for order in robot.orders.open if not robot.orders.is_current(order)]
    for order in waiting[:LAST]:
        yield named(tr("Waiting"), (whose_mission(state, robot, order), StyleRole.TEXT))
    if len(waiting) > LAST:
        yield named(tr(""), (tr("and {count} more", count=len(waiting) - LAST), StyleRole.DIM))
    yield from ended_rows(state, robot)


def alarms_section(
    state: FleetState, robot: Robot, past: Sequence[PastAlarm], clock: Clock, note: Message
) -> PageSection:
    """Return the alarms that are listed, and those of this session that are over; `note` is said about
    these."""
    section = _titled(tr("Alarms"), _alarms(state, robot, past, clock), tr("none in this session"))
    title = (*section.title, (f" {translate(sanitize(note))}", StyleRole.DIM)) if note else section.title
    return PageSection(title, section.lines, tr("none now") if note else section.empty)


def _alarms(state: FleetState, robot: Robot, past: Sequence[PastAlarm], clock: Clock) -> Iterator[Line]:
    own = [alarm for alarm in state.alarms if alarm.condition.source == robot.name]
    for alarm in own:
        role = StyleRole.ALARM if alarm.holds and alarm.needs_acknowledgement else StyleRole.TEXT
        since = tr(" since {first_wall}", first_wall=clock(alarm.first_wall))
        yield (
            (f"{translate(SIGNS[alarm.stage]):<6} {translate(sanitize(alarm.text))}", role),
            (since, StyleRole.DIM),
        )
        if alarm.holds:
            action = translate(action_of(alarm.condition))
            yield ((f"      {action}", StyleRole.DIM),)
    listed = {alarm.condition.kind for alarm in own if alarm.stage is AlarmStage.RETURNED}
    for over in past[:LAST]:
        if over.kind in listed:  # listed above, not acknowledged yet
            listed.remove(over.kind)
            continue
        times = tr("{began} to {ended}", began=sanitize(over.began), ended=sanitize(over.ended))
        yield (
            (tr("  over {times}  {text}", times=times, text=translate(sanitize(over.text))), StyleRole.DIM),
        )


def commands_section(state: FleetState, robot: Robot, clock: Clock) -> PageSection:
    """Return the last commands of this console and their outcomes."""
    return _titled(tr("Commands"), command_rows(state, robot, clock), tr("none from this console"))


def vehicle_rows(state: FleetState, robot: Robot) -> Iterator[tuple[Run, ...]]:
    """Yield its connection, mode, node, load and speed, each as far as it is reported."""
    if robot.connection is not None:
        known = robot.connection.value
        text = (
            Message("{text}, VDA 5050 {version}", text=known.text, version=known.version)
            if known.version
            else known.text
        )
        yield named(tr("Broker"), (sanitize(text), StyleRole.WARN if known.is_gone else StyleRole.TEXT))
    if robot.vehicle is not None:
        vehicle = robot.vehicle.value
        role = StyleRole.TEXT if state.is_fresh(robot, "vehicle") else StyleRole.DIM
        rows = (
            named(tr("Mode"), *_run(vehicle.mode.lower(), role)),
            named(tr("Node"), *_run(vehicle.last_node, role)),
            named(tr("Load"), *_run(vehicle.load or "", role)),
            named(tr("Maps"), *_run(", ".join(vehicle.maps), role)),
            named(tr("Zones"), *_run(", ".join(vehicle.zone_sets), role)),
            named(tr("Charging"), *_run(_yes_or_no(vehicle.charging), role)),
            named(tr("Speed"), *_run("" if vehicle.speed is None else f"{vehicle.speed:.2f} m/s", role)),
        )
        yield from (row for row in rows if row)
    for one in listed(state, robot.link):
        if one.user == robot.name:
            yield named(tr(one.sort.capitalize()), (sanitize(f"{one.name}: {one.state}"), StyleRole.TEXT))
    if robot.master is not None:
        text = Message(
            "{name}, {age} ago", name=Message(robot.master.value), age=age(state.now - robot.master.at)
        )
        yield named(tr("Master"), (sanitize(text), StyleRole.TEXT))


def _run(value: str, role: StyleRole) -> tuple[Run, ...]:
    return ((sanitize(value), role),) if value else ()


def _yes_or_no(value: bool | None) -> str:
    return "" if value is None else tr("yes") if value else tr("no")


def factsheet_rows(robot: Robot) -> Iterator[tuple[Run, ...]]:
    """Yield the properties of a vehicle from its factsheet."""
    for name, value in list(robot.factsheet.items())[:SHOWN]:
        yield ((f"{sanitize(name):<20} ", StyleRole.DIM), (sanitize(value), StyleRole.TEXT))
