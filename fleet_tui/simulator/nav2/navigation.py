"""The action servers of one robot: accept goals and drive the robot. Pure."""

import random
from dataclasses import dataclass, field

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.logs import ERROR, WARN
from fleet_tui.simulator.messages import FRAME, Message, flat, stamped
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.navigating.world import Clock
from fleet_tui.simulator.ros.goals import ABORTED, CANCELED, CANCELING, SUCCEEDED, ActionServer, ServedGoal

TO_POSE = "navigate_to_pose"
THROUGH = "navigate_through_poses"
WAYPOINTS = "follow_waypoints"
DOCK = "dock_robot"
SPIN = "spin"
TYPES = {
    TO_POSE: "nav2_msgs/NavigateToPose",
    THROUGH: "nav2_msgs/NavigateThroughPoses",
    WAYPOINTS: "nav2_msgs/FollowWaypoints",
    DOCK: "nav2_msgs/DockRobot",
    SPIN: "nav2_msgs/Spin",
}
NOT_STAGED = 903
NODES = (
    "controller_server",
    "planner_server",
    "behavior_server",
    "velocity_smoother",
    "collision_monitor",
    "bt_navigator",
    "waypoint_follower",
)
"""Nodes with a lifecycle, in the order of their start."""


@dataclass(eq=False)
class _Tour:
    """A goal of which each pose is driven to as a goal of navigate_to_pose."""

    goal: ServedGoal
    poses: list[Message]
    at: int = 0
    leg: ServedGoal | None = None
    missed: list[Message] = field(default_factory=list)


class SimNavigation:
    """Its attributes are for tests to read and change. `clock`: nanoseconds since 1970."""

    def __init__(self, robot: NavigatingRobot, ids: random.Random, clock: Clock) -> None:
        self.robot = robot
        self._ids = ids
        self._clock = clock
        begins = {TO_POSE: self._begin, THROUGH: self._begin, WAYPOINTS: self._tour, DOCK: self._dock}
        begins[SPIN] = self._spin
        self.servers = {
            verb: ActionServer(f"/{robot.name}/{verb}", TYPES[verb], self._decide, begin)
            for verb, begin in begins.items()
        }
        self.active = True
        """False: the lifecycle manager has deactivated the servers, which reject goals."""
        self.waits_in = ""
        """The node whose start waits, as for a pose: then the lifecycle manager does not answer."""
        self.reject = 0
        """The number of goals that are rejected from now on."""
        self.received: list[Message] = []
        """Every goal that reached a server, legs of tours too; the newest last."""
        self.complaints: list[tuple[int, str, str]] = []
        """Levels, nodes and texts of what its nodes are to log."""
        self.publishes = True
        """False: no feedback is sent."""
        self.distro = "jazzy"
        self._current: ServedGoal | None = None
        self._tours: dict[str, _Tour] = {}

    def give(self, x: float, y: float, yaw: float = 0.0) -> ServedGoal | None:
        return self.take(TO_POSE, {"pose": stamped(Pose(x, y, yaw)), "behavior_tree": ""})

    def take(self, verb: str, request: Message) -> ServedGoal | None:
        """Send any goal with complete fields under a new id; None if it is rejected."""
        return self.servers[verb].take(self.new_id(), self._clock(), request)

    def employ(self, rng: random.Random) -> None:
        """Send it to a labelled vertex, every third time by way of another, as another client would."""
        floor = self.robot.floor
        spots = [floor.graph.vertices[id_] for id_ in rng.sample(tuple(floor.labels), 2)]
        poses = [stamped(Pose(spot.x, spot.y, rng.uniform(-3.0, 3.0))) for spot in spots]
        if rng.random() < 0.3:
            self.take(WAYPOINTS, {"number_of_loops": 0, "goal_index": 0, "poses": poses})
        else:
            self.take(TO_POSE, {"pose": poses[0], "behavior_tree": ""})

    def recharge(self) -> None:
        self.take(DOCK, {"use_dock_id": True, "dock_id": "charger"})

    @property
    def busy(self) -> bool:
        return any(server.running for server in self.servers.values())

    def cancel_all(self) -> None:
        for server in self.servers.values():
            server.cancel(bytes(16), 0)

    def new_id(self) -> bytes:
        return self._ids.randbytes(16)

    def abort(self, code: int = 105, message: str = "Failed to make progress") -> None:
        if self._current is not None:
            self.robot.fail(code, message)

    def warn(self, node: str, text: str, is_error: bool = False) -> None:
        self.complaints.append((ERROR if is_error else WARN, node, text))

    def state_of(self, node: str) -> str:
        """The lifecycle state of one of its nodes, all of which start one after the other."""
        if self.waits_in:
            at = NODES.index(self.waits_in) - NODES.index(node)
            return "active" if at > 0 else "activating" if at == 0 else "inactive"
        return "active" if self.active else "inactive"

    def step(self, dt: float) -> None:
        for server in self.servers.values():
            server.age(dt)
        self._advance_drive()
        self._advance_spin()
        for verb, tour in list(self._tours.items()):
            self._advance_tour(verb, tour)

    def waypoint(self) -> int:
        """The index of the waypoint that follow_waypoints is driving to."""
        tour = self._tours.get(WAYPOINTS)
        return tour.at if tour else 0

    def _decide(self, request: Message) -> bool:
        self.received.append(request)
        del self.received[:-1000]
        if self.reject > 0:
            self.reject -= 1
            return False
        poses = request.get("poses", [request["pose"]] if "pose" in request else [])
        return self.active and all(pose["header"]["frame_id"] == FRAME for pose in poses)

    def _begin(self, goal: ServedGoal) -> None:
        """Drive to a goal's pose or poses. Only one navigator is active at a time; a new goal replaces its
        old one."""
        mine, other = (TO_POSE, THROUGH) if "pose" in goal.request else (THROUGH, TO_POSE)
        if self.servers[other].running:
            self.servers[mine].advance(goal, ABORTED, _result())
            return
        if self._current is not None:
            self.servers[mine].advance(self._current, ABORTED, _result())
        self._current = goal
        poses = [goal.request["pose"]] if mine == TO_POSE else goal.request["poses"]
        self.robot.drive([flat(pose["pose"]) for pose in poses])

    def _advance_drive(self) -> None:
        goal = self._current
        if goal is None:
            return
        server = self.servers[TO_POSE if "pose" in goal.request else THROUGH]
        if not server.alive:
            self._current = None
            self.robot.halt()
        elif goal.status == CANCELING:
            self._finish(server, goal, CANCELED, _result())
        elif self.robot.failure is not None:
            self._finish(server, goal, ABORTED, _result(*self.robot.failure))
        elif not self.robot.driving:
            self._finish(server, goal, SUCCEEDED, _result())

    def _finish(self, server: ActionServer, goal: ServedGoal, status: int, result: Message) -> None:
        self._current = None
        self.robot.halt()
        server.advance(goal, status, result)

    def _tour(self, goal: ServedGoal) -> None:
        self._replace(WAYPOINTS, _Tour(goal, goal.request["poses"]))

    def _dock(self, goal: ServedGoal) -> None:
        dock = self.robot.floor.charger
        self._replace(DOCK, _Tour(goal, [stamped(Pose(dock.x, dock.y))]))

    def _spin(self, goal: ServedGoal) -> None:
        for before in self.servers[SPIN].running:
            if before is not goal:
                self.servers[SPIN].advance(before, ABORTED, _spun(before))
        self.robot.turns_left = abs(goal.request["target_yaw"])

    def _advance_spin(self) -> None:
        server = self.servers[SPIN]
        for goal in server.running:
            if goal.status == CANCELING:
                self.robot.turns_left = 0.0
                server.advance(goal, CANCELED, _spun(goal))
            elif self.robot.turns_left <= 0.0:
                server.advance(goal, SUCCEEDED, _spun(goal))

    def _replace(self, verb: str, tour: _Tour) -> None:
        before = self._tours.get(verb)
        if before is not None:
            self.servers[verb].advance(before.goal, ABORTED, self._result_of(verb, before))
        self._tours[verb] = tour

    def _advance_tour(self, verb: str, tour: _Tour) -> None:
        server, leg = self.servers[verb], tour.leg
        if not server.alive:
            del self._tours[verb]
        elif tour.goal.status == CANCELING:
            if leg is not None:
                self.servers[TO_POSE].cancel(leg.id, 0)
            self._end_tour(verb, tour, CANCELED)
        elif tour.at == len(tour.poses):
            self._end_tour(verb, tour, ABORTED if verb == DOCK and tour.missed else SUCCEEDED)
        elif leg is None:
            tour.leg = self.take(TO_POSE, {"pose": tour.poses[tour.at], "behavior_tree": ""})
            if tour.leg is None:
                self._pass(tour, 0)
        elif leg.over or leg.id not in self.servers[TO_POSE].goals:
            self._pass(tour, None if leg.status == SUCCEEDED else leg.result.get("error_code", 0))

    def _pass(self, tour: _Tour, code: int | None) -> None:
        """Continue with the next waypoint; code None: the current one was reached."""
        if code is not None:
            goal = tour.poses[tour.at]
            tour.missed.append({"index": tour.at, "goal": goal, "error_code": code})
        tour.at = tour.at + 1
        tour.leg = None

    def _end_tour(self, verb: str, tour: _Tour, status: int) -> None:
        del self._tours[verb]
        if verb == DOCK:
            self.robot.docked = status == SUCCEEDED
        self.servers[verb].advance(tour.goal, status, self._result_of(verb, tour))

    def _result_of(self, verb: str, tour: _Tour) -> Message:
        if verb == DOCK:
            code = NOT_STAGED if tour.missed else 0
            return {"success": not tour.missed, "error_code": code, "num_retries": 0}
        return {"missed_waypoints": tour.missed, **_result()}


def _spun(goal: ServedGoal) -> Message:
    return {"total_elapsed_time": {"sec": int(goal.age), "nanosec": 0}, "error_code": 0, "error_msg": ""}


def _result(code: int = 0, message: str = "") -> Message:
    return {"error_code": code, "error_msg": message}
