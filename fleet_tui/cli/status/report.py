"""The fleet at one moment as plain values, for `status --json`. The schema is in docs/status-json.md."""

import math
from collections.abc import Iterator
from typing import Any

from fleet_tui.cli.session import missing
from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState, missing_text
from fleet_tui.model.fleets.facility import LANES, Facility
from fleet_tui.model.kind import PAUSE
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.model.order import Order, Stop, route_text
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.model.vehicles.vehicle import VehicleError
from fleet_tui.orders.local_queue import foreign, waiting_orders_of
from fleet_tui.situation.alarms.trouble import to_look_at
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import OBSTACLE, STOP
from fleet_tui.situation.links import behind, dead_commands, late_link, no_link, untried_commands
from fleet_tui.situation.pauses import is_held
from fleet_tui.situation.reported_motion import running_action
from fleet_tui.situation.robots import absence, adrift, blocked_robots
from fleet_tui.text.language import translate
from fleet_tui.text.limits import some
from fleet_tui.text.units import counted
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.news import news


def navigation(state: FleetState, robot: Robot) -> dict[str, Any]:
    """Return the additional values of such a robot; empty for a kind without any."""
    found: dict[str, Any] = {}
    if "progress" in robot.kind.reports:
        found["progress"] = _progress(state, robot)
    if "blocked" in robot.kind.reports:
        blocked = robot.blocked.value if robot.blocked else None
        found["blocked"] = blocked.action or None if blocked else None
        stopped = blocked is not None and blocked.is_stopped
        found["blocked_s"] = round(state.now - blocked.since, 1) if blocked and stopped else None
    if "odometry" in robot.kind.reports:
        estimate = adrift(state, robot)
        found["localisation_silent_s"] = _silence(state, robot) if estimate else None
        found["position_variance_m2"] = round(robot.variance.value, 3) if robot.variance else None
    if robot.kind.keeps_goals:
        found["kept_here"] = [_kept(robot, order) for order in waiting_orders_of(state, robot)]
        found["held"] = robot.held or None
        found["not_ours"] = [order.id for order in foreign(state, robot)]
    return found


def _silence(state: FleetState, robot: Robot) -> float | None:
    return round(state.now - robot.located_at, 1) if robot.located_at is not None else None


def _kept(robot: Robot, order: Order) -> dict[str, Any]:
    way = route_text(order.stops, lambda vertex: robot.name_of(vertex) or vertex)
    return {"id": order.id, "mission": order.label or way}


def _progress(state: FleetState, robot: Robot) -> dict[str, Any] | None:
    if robot.progress is None or robot.orders.current is None or not state.is_fresh(robot, "progress"):
        return None
    reported = robot.progress.value
    return {
        "metres": reported.metres,
        "seconds": reported.seconds,
        "elapsed_s": reported.elapsed,
        "recoveries": reported.recoveries,
        "stop": reported.stop,
    }


def vehicle(state: FleetState, robot: Robot) -> dict[str, Any]:
    """Return the additional values of such a vehicle; empty for other kinds, and before its first message."""
    found: dict[str, Any] = {}
    if robot.connection is not None:
        found["connection"] = robot.connection.value.word.lower()
        found["protocol"] = robot.connection.value.version or None
    if robot.vehicle is None:
        return found
    known, action = robot.vehicle.value, running_action(state, robot)
    return found | {
        "protocol": known.version or None,
        "state_s": round(max(0.0, state.now - robot.vehicle.at), 1),
        "mode": known.mode.lower() or None,
        "e_stop": known.e_stop.lower() or None,
        "field_violation": known.field_violation,
        "driving": known.driving,
        "speed_m_s": None if known.speed is None else round(known.speed, 2),
        "action": action.action.type if action is not None else None,
        "action_s": None if action is None else round(state.now - action.since, 1),
        "charging": known.charging,
        "localised": known.localised,
        "load": known.load,
        "last_node": known.last_node or None,
        "nodes_left": list(known.nodes_left),
        "waits_for_clearance": known.waits,
        "errors": [_error(one) for one in known.errors],
    }


def _error(error: VehicleError) -> dict[str, Any]:
    return {
        "type": error.type,
        "level": error.level.lower() or None,
        "text": error.text or None,
        "hint": error.hint or None,
    }


VERSION = 2

Values = dict[str, Any]


def _age(state: FleetState, at: float | None) -> float | None:
    return None if at is None else round(max(0.0, state.now - at), 1)


def _link(state: FleetState, link: LinkState) -> Values:
    return {
        "name": link.name,
        "url": link.url,
        "site": link.site or None,
        "state": link.phase.value,
        "reason": link.reason or None,
        "since_s": _age(state, link.since),
        "last_message_s": _age(state, link.last_received),
        "commands": (CommandPath.UNTRIED if untried_commands(link) else link.command_path).value,
        "commands_reason": link.command_reason or None,
        "late_s": round(link.late, 1),
        "bad_frames": link.faults,
        "facilities": [_facility(state, one) for one in state.facilities.values() if one.link == link.name],
    }


def _facility(state: FleetState, one: Facility) -> Values:
    closed = {"closed": list(one.closed)} if one.sort == LANES else {}
    told = {"state": one.state or None, "fault": one.fault or None, "user": one.user or None}
    return {"sort": one.sort, "name": one.name, **told, **closed, "age_s": _age(state, one.at)}


def _value(reading: Reading[Any] | None, digits: int = 1) -> Any:
    if reading is None:
        return None
    return round(reading.value, digits) if isinstance(reading.value, float) else reading.value


def _pose(robot: Robot, state: FleetState) -> Values | None:
    if robot.pose is None:
        return None
    pose = robot.pose.value
    yaw = round(math.degrees(pose.yaw), 1)
    return {
        "x_m": round(pose.x, 2),
        "y_m": round(pose.y, 2),
        "yaw_deg": yaw,
        "age_s": None if robot.is_undated else _age(state, robot.pose.at),
        **({"estimated": True} if robot.is_estimated else {}),
    }


def _stop(robot: Robot, role: str, stop: Stop | None) -> Values:
    if stop is None or stop.pose is not None:
        place = None if stop is None or stop.pose is None else [round(stop.pose.x, 2), round(stop.pose.y, 2)]
        return {role: None, f"{role}_label": None, f"{role}_m": place}
    return {role: stop.vertex, f"{role}_label": robot.name_of(stop.vertex), f"{role}_m": None}


def _orders(robot: Robot) -> list[Values]:
    return [
        {
            "position": position,
            "id": order.id,
            **_stop(robot, "start", order.start),
            **_stop(robot, "end", order.end),
            "status": order.word,
            "status_text": order.state.value if order.state else None,
            "current": robot.orders.is_current(order),
        }
        for position, order in enumerate(robot.orders.in_sequence())
    ]


def _robot(state: FleetState, robot: Robot) -> Values:
    kind = robot.kind
    values: Values = {
        "name": robot.name,
        "kind": kind.name,
        "link": robot.link,
        "online": state.is_online(robot),
        "heard_s": _age(state, robot.last_received),
    }
    if "pose" in kind.reports:
        values |= {"floor": robot.floor, "frame_id": robot.frame_id or None, "pose": _pose(robot, state)}
    optional = {
        "battery": ("battery_percent", _value(robot.battery)),
        "cargo": ("cargo", _value(robot.cargo)),
        "obstacle": ("obstacle_s", _value(robot.obstacle)),
    }
    values |= {name: value for reported, (name, value) in optional.items() if reported in kind.reports}
    if "paused" in kind.reports or kind.can(PAUSE):
        values["paused"] = state.pause(robot) and is_held(state, robot)
    if kind.lists_orders:
        values["orders"] = _orders(robot) if robot.queue else None
    values |= navigation(state, robot) | vehicle(state, robot)
    return values | {"bad_messages": robot.faults, "never_came": missing(robot)}


def untried(state: FleetState) -> list[Fact]:
    """Return the bridges of which nothing shows that commands get through."""
    return [fact for fact in map(untried_commands, state.links.values()) if fact is not None]


def attention(state: FleetState) -> list[str]:
    """Return one line for each thing that needs attention; empty when all is well."""
    # Listed before they have lasted long enough for an alarm: this command does not wait for that.
    facts = [behind(state)]
    facts += [late_link(state, link) for link in state.links.values()]
    facts += [no_link(state, link) or dead_commands(link) for link in state.links.values()]
    facts += [fact for fact in untried(state) if fact.priority is not Priority.LOW]
    lines = [f"{fact.source}: {fact.text}" for fact in facts if fact is not None]
    alarms = [alarm for alarm in state.alarms if alarm.holds]
    told = {alarm.condition.source for alarm in alarms if alarm.condition.kind in (OBSTACLE.name, STOP.name)}
    if blocked := [name for name in blocked_robots(state) if name not in told]:
        lines.append(f"{counted(len(blocked), 'robot')} {OBSTACLE.word}: {some(blocked)}")
    lines += [f"{alarm.condition.source}: {alarm.text}" for alarm in alarms]
    lines += _unknown(state)
    lines += [line for name in to_look_at(state) if name not in blocked for line in _first_news(state, name)]
    # An alarm may have reported it already.
    return list(dict.fromkeys(lines))


def _first_news(state: FleetState, name: str) -> Iterator[str]:
    """Yield what needs a person first of a robot, unless it is that its pose is missing: that is said with
    all else that is."""
    robot = state.robots[name]
    urgent = (text for text, role in news(state, robot) if role is not StyleRole.DIM)
    text = next(urgent, "")
    if text and not (missing(robot) and text == translate(missing_text(state, robot, "pose"))):
        yield f"{name}: {text}"


def _unknown(state: FleetState) -> Iterator[str]:
    """Yield the robots of which nothing current is known, as far as no alarm tells it, and the values that
    never came."""
    told = {
        (name, alarm.condition.kind)
        for alarm in state.alarms
        if alarm.holds
        for name in (alarm.condition.source, *alarm.condition.parts)
    }
    for robot in state.robots.values():
        link, absent = state.links[robot.link], missing(robot)
        if link.phase is not Phase.UP:
            continue
        if absent and state.is_online(robot):
            yield f"{robot.name}: {', '.join(absent)} missing"
        fact = absence(state, robot)
        if fact is None or fact.priority is Priority.LOW or not fact.is_certain:
            continue
        if (robot.name, fact.kind.name) not in told:
            yield f"{robot.name}: {fact.short}"


def report(state: FleetState) -> Values:
    """Return the values for `status --json`."""
    return {
        "version": VERSION,
        "time": state.wall,
        "behind_s": round(state.behind, 1),
        "links": [_link(state, link) for link in state.links.values()],
        "robots": [_robot(state, robot) for robot in state.robots.values()],
        "alarms": [
            {
                "source": alarm.condition.source,
                "kind": alarm.condition.kind,
                "priority": alarm.condition.priority.name.lower(),
                "text": alarm.text,
                "active": alarm.holds,
            }
            for alarm in state.alarms
        ],
        "attention": attention(state),
    }


def changes(before: Values, after: Values) -> Values:
    """Return the changes of a report: whole links and robots, all alarms; ages alone are no change."""
    changed: Values = {}
    for part in ("links", "robots"):
        old = {entry["name"]: _ageless(entry) for entry in before[part]}
        new = [entry for entry in after[part] if _ageless(entry) != old.get(entry["name"])]
        if new:
            changed[part] = new
    for part in ("alarms", "attention"):
        if after[part] != before[part]:
            changed[part] = after[part]
    return {"version": VERSION, "time": after["time"], "changed": changed} if changed else {}


def _ageless(entry: Values) -> Values:
    ages = (
        "since_s",
        "last_message_s",
        "heard_s",
        "late_s",
        "blocked_s",
        "state_s",
        "action_s",
        "localisation_silent_s",
    )
    kept = {name: value for name, value in entry.items() if name not in ages}
    for part, age in (("pose", "age_s"), ("progress", "elapsed_s")):
        if kept.get(part):
            kept[part] = {name: value for name, value in kept[part].items() if name != age}
    if "facilities" in kept:
        kept["facilities"] = [{**one, "age_s": None} for one in kept["facilities"]]
    return kept
