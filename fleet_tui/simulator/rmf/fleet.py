"""The fleets of a hospital as the bridge sees them."""

import json
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.logs import HEALTHY, entry
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.rmf import messages
from fleet_tui.simulator.rmf.naming import FLEETS
from fleet_tui.simulator.rmf.world import RmfWorld
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.ros_types import ServiceType

Message = dict[str, Any]

STATES = "/fleet_states"
UPDATES = "/fleet_state_update"
TASKS = "/task_state_update"
RESPONSES = "/task_api_responses"
REQUESTS = "/task_api_requests"
DISPATCHES = "/dispatch_states"
GRAPHS = "/nav_graphs"
MAP = "/map"
LIFTS = "/lift_states"
DOORS = "/door_states"
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
    DOORS: "rmf_door_msgs/DoorState",
    DISPENSERS: "rmf_dispenser_msgs/DispenserState",
    INGESTORS: "rmf_ingestor_msgs/IngestorState",
}
TASKS_KEPT = 10
RESPONDING = 2


class RmfFleet(RmfWorld):
    """The robots of an RmfWorld on the wire. `period`: seconds between two states of a fleet."""

    kind = "rmf"

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
        super().__init__(robots, floors, seed, quiet, first, step, fleets, _millis)
        self.actions: Mapping[str, ActionServer] = {}
        self.period = period
        self._due = self._tick = 0.0
        self._told_lanes: list[int] = []
        self._seen = dict.fromkeys(self.robots, time.time())
        self._responses: list[tuple[str, Message]] = []
        self._last_tasks: deque[Payload] = deque(maxlen=TASKS_KEPT)
        self._last_updates: dict[str, Payload] = {}

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic: none is of one robot alone."""
        for name, type_ in TYPES.items():
            yield Topic(name, dialect.message_type(type_), lambda _: Payload({}))
        text = dialect.message_type("std_msgs/String")
        nothing = Payload({"data": ""})
        yield Topic(TASKS, text, lambda _: nothing, latched=True, history=lambda: list(self._last_tasks))
        updates = self._last_updates
        yield Topic(UPDATES, text, lambda _: nothing, latched=True, history=lambda: list(updates.values()))
        graphs = [Payload(messages.nav_graph(fleet, self.building)) for fleet in self.fleets]
        type_ = dialect.message_type("rmf_building_map_msgs/Graph")
        yield Topic(GRAPHS, type_, lambda _: graphs[0], latched=True, history=lambda: graphs)

        type_ = dialect.message_type("rmf_fleet_msgs/LaneStates")
        yield Topic(LANES, type_, lambda _: Payload({}), latched=True, history=self._lanes)
        building = Payload(messages.building_map(self.building))
        type_ = dialect.message_type("rmf_building_map_msgs/BuildingMap")
        yield Topic(MAP, type_, lambda _: building, latched=True)

    def _lanes(self) -> list[Payload]:
        return [Payload({"fleet_name": one, "closed_lanes": self.closed_lanes}) for one in self.fleets]

    def subscriptions(self) -> Mapping[str, tuple[str, Callable[[Message], None]]]:
        """The topic of requests."""
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
                update = messages.text({"type": "task_state_update", "data": task.state()})
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
            yield STATES, Payload(messages.fleet_state(fleet, members, self._seen, dialect))
            update = Payload(messages.fleet_update(fleet, members, _millis()))
            self._last_updates[fleet] = update
            yield UPDATES, update
        yield DISPATCHES, Payload(messages.dispatches(self.dispatcher.active, self.dispatcher.finished))
        stamp = dialect.time(now)
        yield LIFTS, Payload(messages.lift_state(self.lift, stamp))
        for door in self.doors:
            yield DOORS, Payload(messages.door_state(door, stamp))
        yield DISPENSERS, Payload(messages.work_state(PHARMACY, PHARMACY in self.offline, stamp))
        yield INGESTORS, Payload(messages.work_state(RETURNS, RETURNS in self.offline, stamp))
        if self.closed_lanes != self._told_lanes:
            self._told_lanes = list(self.closed_lanes)
            for payload in self._lanes():
                yield LANES, payload

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """None: requests are messages."""
        return {}

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """Nothing."""
        return {}

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        """Nothing."""

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        """Nothing."""

    def lines(self) -> Iterable[Line]:
        """Nothing."""
        return ()

    def health(self) -> Iterable[Message]:
        """Return the battery of every robot that is not silent."""
        for robot in self.robots.values():
            if not robot.silence:
                yield entry(robot, "battery", HEALTHY, "charged", percent=f"{robot.body.battery:.1f}")


def _millis() -> int:
    return int(time.time() * 1000)
