"""The fleets of a hospital as the bridge sees them."""

import io
import json
import time
from collections import deque
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from PIL import Image

from fleet_tui.simulator.fleets import Fleet, Subscriptions
from fleet_tui.simulator.floorplan import FREE, HEIGHT, OCCUPIED, ORIGIN, RESOLUTION
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.logs import HEALTHY, entry
from fleet_tui.simulator.messages import Message, Topic
from fleet_tui.simulator.rmf.dispatcher import SimDispatch, SimDispatcher
from fleet_tui.simulator.rmf.lifts import DOORS, MOVING, OPEN, SimDoor, SimLift
from fleet_tui.simulator.rmf.member import SimMember
from fleet_tui.simulator.rmf.naming import FLEETS
from fleet_tui.simulator.rmf.tasks import SimTask
from fleet_tui.simulator.robot import STEP
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.warehouse import Building, SimFloor
from fleet_tui.simulator.world import SimWorld

STATES = "/fleet_states"
UPDATES = "/fleet_state_update"
TASKS = "/task_state_update"
RESPONSES = "/task_api_responses"
REQUESTS = "/task_api_requests"
DISPATCHES = "/dispatch_states"
GRAPHS = "/nav_graphs"
MAP = "/map"
LIFTS = "/lift_states"
DOOR_STATES = "/door_states"
DISPENSERS = "/dispenser_states"
INGESTORS = "/ingestor_states"
LANES = "/lane_states"
PHARMACY = "pharmacy"
RETURNS = "returns"
"""The dispenser and the ingestor."""
TYPES = {
    STATES: "rmf_fleet_msgs/FleetState",
    DISPATCHES: "rmf_task_msgs/DispatchStates",
    RESPONSES: "rmf_task_msgs/ApiResponse",
    LIFTS: "rmf_lift_msgs/LiftState",
    DOOR_STATES: "rmf_door_msgs/DoorState",
    DISPENSERS: "rmf_dispenser_msgs/DispenserState",
    INGESTORS: "rmf_ingestor_msgs/IngestorState",
}
TASKS_KEPT = 10
RESPONDING = 2


BOTH_WAYS = 0
STRING = 1
BOOL = 4
"""Types of a parameter."""


class RmfFleet(SimWorld[SimMember], Fleet):
    """Robots in `fleets`. `period`: seconds between two states of a fleet."""

    kind = "rmf"
    robots: dict[str, SimMember]

    def __init__(
        self,
        robots: int,
        floors: int,
        seed: int = 0,
        quiet: bool = False,
        first: int = 0,
        step: int = 1,
        fleets: tuple[str, ...] = FLEETS,
        period: float = 1.0,
    ) -> None:
        self.fleets = fleets
        super().__init__(robots, floors, seed, quiet, first, step)
        self.dispatcher = SimDispatcher(self.robots, _millis)
        self.lift = SimLift(self.building)
        self.doors = [
            SimDoor(name, floor.name, spot) for floor in self.building.floors for name, spot in DOORS.items()
        ]
        self.closed_lanes: list[int] = []
        """The numbers of closed edges, alike for all fleets."""
        self.offline = set[str]()
        """Dispensers and ingestors that are offline."""
        self.period = period
        self._next = 3.0
        self._given = 0
        self._due = 0.0
        self._told_lanes: list[int] = []
        self._seen = dict.fromkeys(self.robots, time.time())
        self._responses: list[tuple[str, Message]] = []
        self._last_tasks: deque[Payload] = deque(maxlen=TASKS_KEPT)
        self._last_updates: dict[str, Payload] = {}

    def _new_robot(self, turn: int, index: int) -> SimMember:
        _, vertex = self._start_of(index)
        return SimMember(turn, index, self.building, vertex, self._rng, self._quiet, self.fleets)

    def _live(self) -> None:
        for member in self.robots.values():
            member.live()
        self.dispatcher.step(STEP)
        self.lift.step(self.robots, self.building)
        for door in self.doors:
            door.step(self.robots, STEP)

    def _employ(self) -> None:
        self._next -= STEP
        if self._next > 0.0:
            return
        self._next = self._rng.uniform(10.0, 25.0)
        second = [*self.robots.values()][1::2]
        idle = [member for member in second if not member.tasks]
        if idle:
            member = self._rng.choice(idle)
            self._given += 1
            places = tuple(self._rng.sample(sorted(member.places), 2))
            member.assign(SimTask(f"patrol.web-{self._given}", places, "rmf-web"))

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic: none is of one robot alone."""
        for name, type_ in TYPES.items():
            yield Topic(name, dialect.message_type(type_), lambda _: Payload({}))
        text = dialect.message_type("std_msgs/String")
        nothing = Payload({"data": ""})
        yield Topic(TASKS, text, lambda _: nothing, latched=True, history=lambda: list(self._last_tasks))
        updates = self._last_updates
        yield Topic(UPDATES, text, lambda _: nothing, latched=True, history=lambda: list(updates.values()))
        graphs = [Payload(nav_graph(fleet, self.building)) for fleet in self.fleets]
        type_ = dialect.message_type("rmf_building_map_msgs/Graph")
        yield Topic(GRAPHS, type_, lambda _: graphs[0], latched=True, history=lambda: graphs)

        type_ = dialect.message_type("rmf_fleet_msgs/LaneStates")
        yield Topic(LANES, type_, lambda _: Payload({}), latched=True, history=self._lanes)
        building = Payload(building_map(self.building))
        type_ = dialect.message_type("rmf_building_map_msgs/BuildingMap")
        yield Topic(MAP, type_, lambda _: building, latched=True)

    def _lanes(self) -> list[Payload]:
        return [Payload({"fleet_name": one, "closed_lanes": self.closed_lanes}) for one in self.fleets]

    def subscriptions(self) -> Subscriptions:
        return {REQUESTS: ("rmf_task_msgs/ApiRequest", self.take)}

    def take(self, message: Message) -> None:
        """Take a request, as the dispatcher and every fleet adapter do."""
        if answer := self.dispatcher.take(message["json_msg"], message["request_id"]):
            self._responses.append(answer)

    def news(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        """Return answers, tasks that changed, and what is due on a timer."""
        for request_id, answer in self._responses:
            response = {"type": RESPONDING, "json_msg": json.dumps(answer), "request_id": request_id}
            yield RESPONSES, Payload(response)
        self._responses.clear()
        for member in self.robots.values():
            for task in member.changed:
                update = text({"type": "task_state_update", "data": task.state()})
                self._last_tasks.append(payload := Payload(update))
                yield TASKS, payload
            member.changed.clear()
        if time.monotonic() >= self._due:
            self._due = time.monotonic() + self.period
            yield from self._on_timer(dialect)

    def _on_timer(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        now = time.time()
        self._seen |= {name: now for name, one in self.robots.items() if not one.silence}
        for fleet in self.fleets:
            members = [one for one in self.robots.values() if one.fleet == fleet]
            yield STATES, Payload(fleet_state(fleet, members, self._seen, dialect))
            update = Payload(fleet_update(fleet, members, _millis()))
            self._last_updates[fleet] = update
            yield UPDATES, update
        yield DISPATCHES, Payload(dispatches(self.dispatcher.active, self.dispatcher.finished))
        stamp = dialect.time(now)
        yield LIFTS, Payload(lift_state(self.lift, stamp))
        for door in self.doors:
            yield DOOR_STATES, Payload(door_state(door, stamp))
        yield DISPENSERS, Payload(work_state(PHARMACY, PHARMACY in self.offline, stamp))
        yield INGESTORS, Payload(work_state(RETURNS, RETURNS in self.offline, stamp))
        if self.closed_lanes != self._told_lanes:
            self._told_lanes = list(self.closed_lanes)
            for payload in self._lanes():
                yield LANES, payload

    def health(self) -> Iterable[Message]:
        for robot in self.robots.values():
            if not robot.silence:
                yield entry(robot, "battery", HEALTHY, "charged", percent=f"{robot.body.battery:.1f}")


def _millis() -> int:
    return int(time.time() * 1000)


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
