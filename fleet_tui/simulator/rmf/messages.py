"""Messages of fleets, levels, lifts and doors, as the nodes of Open-RMF write them."""

import io
import json
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from PIL import Image

from fleet_tui.simulator.floorplan import FREE, HEIGHT, OCCUPIED, ORIGIN, RESOLUTION
from fleet_tui.simulator.rmf.dispatcher import SimDispatch
from fleet_tui.simulator.rmf.lifts import MOVING, OPEN, SimDoor, SimLift
from fleet_tui.simulator.rmf.member import SimMember
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.warehouse import Building, SimFloor

Message = dict[str, Any]

BOTH_WAYS = 0
STRING = 1
BOOL = 4
"""Types of a parameter."""


def text(value: Message) -> Message:
    """Return a std_msgs/String with JSON."""
    return {"data": json.dumps(value)}


def fleet_state(
    fleet: str, members: Iterable[SimMember], seen: dict[str, float], dialect: Dialect
) -> Message:
    """Return a rmf_fleet_msgs/FleetState; `seen`: the time of each driver's last update."""
    return {"name": fleet, "robots": [_member(one, dialect.time(seen[one.name])) for one in members]}


def _member(one: SimMember, stamp: Message) -> Message:
    place = {"t": stamp, "x": one.body.pose.x, "y": one.body.pose.y, "yaw": one.body.pose.yaw}
    return {
        "name": one.own_name,
        "model": "",
        "task_id": one.active.id if one.active else "",
        "seq": 0,
        "mode": {"mode": one.mode, "mode_request_id": 0, "performing_action": ""},
        "battery_percent": one.body.battery,
        "location": {**place, "level_name": one.body.floor.name, "index": 0},
        "path": [],
    }


def fleet_update(fleet: str, members: Iterable[SimMember], millis: int) -> Message:
    """Return a fleet_state_update. The adapter's clock goes on, whatever its robots do."""
    robots = {one.own_name: _status(one, millis) for one in members}
    return text({"type": "fleet_state_update", "data": {"name": fleet, "robots": robots}})


def _status(one: SimMember, millis: int) -> Message:
    pose = one.body.pose
    return {
        "name": one.own_name,
        "status": "working" if one.active else "charging" if one.mode == 1 else "idle",
        "task_id": one.active.id if one.active else "",
        "unix_millis_time": millis,
        "battery": one.body.battery / 100.0,
        "location": {"map": one.body.floor.name, "x": pose.x, "y": pose.y, "yaw": pose.yaw},
        "issues": one.issues,
    }


def dispatches(active: Sequence[SimDispatch], finished: Sequence[SimDispatch]) -> Message:
    """Return a rmf_task_msgs/DispatchStates."""
    return {"active": list(map(_dispatch, active)), "finished": list(map(_dispatch, finished))}


def _dispatch(one: SimDispatch) -> Message:
    task = one.task
    assigned = {"is_assigned": bool(task.robot), "fleet_name": task.fleet, "expected_robot_name": task.robot}
    return {"task_id": task.id, "status": one.status, "assignment": assigned, "errors": one.errors}


def nav_graph(fleet: str, building: Building) -> Message:
    """Return a rmf_building_map_msgs/Graph: the vertices of all levels, numbered through."""
    ids = [id_ for floor in building.floors for id_ in floor.graph.vertices]
    numbers = {id_: number for number, id_ in enumerate(ids)}
    edges = [
        {"v1_idx": numbers[one.start], "v2_idx": numbers[one.end], "params": [], "edge_type": BOTH_WAYS}
        for one in building.graph.edges
    ]
    return {"name": fleet, "vertices": [_vertex(building, id_) for id_ in ids], "edges": edges, "params": []}


def _vertex(building: Building, id_: int) -> Message:
    floor = building.floor_of(id_)
    spot, type_ = floor.graph.vertices[id_], floor.types[id_]
    params = [_param("map_name", floor.name), _param("is_charger", type_ == "charger")]
    if type_ == "elevator":
        params.append(_param("lift", "lift_1"))
    return {"x": spot.x, "y": spot.y, "name": floor.labels.get(id_, ""), "params": params}


def _param(name: str, value: str | bool) -> Message:
    is_text = isinstance(value, str)
    words = {"value_string": value if is_text else "", "value_bool": False if is_text else value}
    return {"name": name, "type": STRING if is_text else BOOL, "value_int": 0, "value_float": 0.0, **words}


def building_map(building: Building) -> Message:
    """Return a rmf_building_map_msgs/BuildingMap: a picture of each level, by its upper left corner."""
    levels = [
        {"name": floor.name, "elevation": 4.0 * number, "images": [_image(floor)]}
        for number, floor in enumerate(building.floors)
    ]
    return {"name": "hospital", "levels": levels}


def _image(floor: SimFloor) -> Message:
    shades = np.where(floor.cells == FREE, 254, np.where(floor.cells == OCCUPIED, 0, 205)).astype(np.uint8)
    file = io.BytesIO()
    Image.fromarray(shades[::-1]).save(file, "PNG")
    x, y = ORIGIN
    return {
        "name": floor.name,
        "x_offset": x,
        "y_offset": y + HEIGHT * RESOLUTION,
        "yaw": 0.0,
        "scale": RESOLUTION,
        "encoding": "png",
        "data": np.frombuffer(file.getvalue(), np.uint8),
    }


def lift_state(lift: SimLift, stamp: Message) -> Message:
    """Return a rmf_lift_msgs/LiftState."""
    is_moving = lift.floor != lift.destination
    return {
        "lift_time": stamp,
        "lift_name": "lift_1",
        "available_floors": lift.floors,
        "current_floor": lift.floor,
        "destination_floor": lift.destination,
        "door_state": 0 if is_moving else OPEN if lift.session else 0,
        "motion_state": MOVING if is_moving else 0,
        "available_modes": "",
        "current_mode": lift.mode,
        "session_id": lift.session,
    }


def door_state(door: SimDoor, stamp: Message) -> Message:
    """Return a rmf_door_msgs/DoorState."""
    return {"door_time": stamp, "door_name": door.name, "current_mode": {"value": door.mode}}


def work_state(name: str, is_offline: bool, stamp: Message) -> Message:
    """Return a rmf_dispenser_msgs/DispenserState or a rmf_ingestor_msgs/IngestorState."""
    mode = 2 if is_offline else 0
    return {"time": stamp, "guid": name, "mode": mode, "request_guid_queue": [], "seconds_remaining": 0.0}
