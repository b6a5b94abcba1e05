"""Values of vehicles that a master control moves over nodes, for `status --json`."""

from typing import Any

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import VehicleError
from fleet_tui.situation.reported_motion import running_action


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
