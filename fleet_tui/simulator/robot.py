"""The body of a simulated robot, and a robot with a queue of orders: its work is a generator that advances by
STEP seconds at each `next`."""

import math
import random
from collections.abc import Iterator
from dataclasses import dataclass

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.senses.belief import Belief
from fleet_tui.simulator.senses.wheels import Wheels
from fleet_tui.simulator.warehouse import Building, SimFloor

STEP = 0.05  # seconds of world time per step
SPEED = 1.1  # m/s
TURN = 1.5  # rad/s, in place
LOADING = 3.0  # seconds to load or unload
RIDE = 6.0  # seconds in the elevator

# per cent per second
DRAIN = 0.05
DRAIN_STANDING = 0.01
CHARGE = 0.5
# per cent: orders wait / an idle robot docks / it has charged
EMPTY = 10.0
LOW = 25.0
FULL = 80.0

Work = Iterator[None]


class RobotBody:
    """What drives, whatever its orders are: a battery, wheels, a belief of its pose, and obstacles that come
    and go. `quiet`: none do. The attributes without an underscore may be changed."""

    obstacle = 0.0
    """Seconds in front of an obstacle, 0 = none."""
    silence = 0.0
    """Seconds for which none of the robot's topics are published."""
    stuck = False
    """True: its wheels are blocked."""
    _obstacle_for = 0.0

    def __init__(
        self,
        index: int,
        pose: Pose,
        rng: random.Random,
        quiet: bool,
        charged: tuple[float, float] = (45.0, 95.0),
    ) -> None:
        """`charged`: the lowest and the highest battery that it may begin with, in per cent."""
        self.name = f"robot_{index}"
        self.index = index
        self.pose = pose
        self.belief = Belief()
        self.wheels = Wheels()
        self.battery = rng.uniform(*charged)
        """Per cent."""
        self._rng = rng
        self._quiet = quiet
        self._obstacle_in = rng.uniform(25.0, 90.0)
        """Seconds until the next random obstacle."""

    def block(self) -> None:
        self.obstacle = STEP
        self._obstacle_for = math.inf

    def _blocked(self, one_may_come: bool) -> bool:
        """Tell whether an obstacle is in the way; it appears about once a minute and stays for 2 to 8 s."""
        if self.obstacle == 0.0:
            if not one_may_come:
                return False
            self._obstacle_in -= STEP
            if self._obstacle_in > 0.0:
                return False
            self._obstacle_in, self._obstacle_for = self._rng.uniform(60.0, 90.0), self._rng.uniform(2.0, 8.0)
        self.obstacle += STEP
        if self.obstacle > self._obstacle_for:
            self.obstacle = 0.0
        return self.obstacle > 0.0

    def _charge_by(self, rate: float) -> None:
        """Charge for a step, at a rate in per cent per second."""
        self.battery = min(100.0, max(0.0, self.battery + rate * STEP))

    def _reach(self, x: float, y: float) -> Work:
        """Turn towards a place, and drive straight to it."""
        if math.dist((x, y), (self.pose.x, self.pose.y)) > 1e-9:
            yield from self._face(math.atan2(y - self.pose.y, x - self.pose.x))
            yield from self._roll_to(x, y)

    def _face(self, wanted: float) -> Work:
        while abs(left := math.remainder(wanted - self.pose.yaw, math.tau)) > 1e-9:
            turned = math.copysign(min(abs(left), TURN * STEP), left)
            self.pose = Pose(self.pose.x, self.pose.y, math.remainder(self.pose.yaw + turned, math.tau))
            yield

    def _roll_to(self, x: float, y: float) -> Work:
        while (left := math.dist((x, y), (self.pose.x, self.pose.y))) > 1e-9:
            part = min(1.0, SPEED * STEP / left)
            at = self.pose
            self.pose = Pose(at.x + part * (x - at.x), at.y + part * (y - at.y), at.yaw)
            yield


@dataclass
class SimOrder:
    """A transport order; status is `Q` queued, `W` in process or `C` cancelled."""

    id: int
    start: int
    end: int
    loaded: bool = False
    status: str = "Q"


class SimRobot(RobotBody):
    """A robot and its queue, stuck only while it has an order in process. If `quiet` it does not dock."""

    def __init__(self, index: int, building: Building, vertex: int, rng: random.Random, quiet: bool) -> None:
        self._building = building
        pose = Pose(*self._spot(vertex), yaw=rng.uniform(-math.pi, math.pi))
        charged = (28.0, 33.0) if index == 1 and not quiet else (45.0, 95.0)
        super().__init__(index, pose, rng, quiet, charged)
        self.vertex = vertex
        """The id of the vertex it reached last."""
        self.bound: int | None = None
        """The id of the vertex it drives to, None while it is at `vertex`."""
        self.cargo = False
        self.paused = False
        self.idle = 0.0
        """Seconds since it became idle."""
        self.orders: list[SimOrder] = []
        self.ended: list[SimOrder] = []
        """Orders that are over and still reported."""
        self.last_order_id = self.request_id = 0
        self._driving = False
        self._work = self._live()

    @property
    def floor(self) -> SimFloor:
        return self._building.floor_of(self.vertex)

    @property
    def current_order_id(self) -> int:
        """The id of the order in process, -1 = none."""
        return next((order.id for order in self.orders if order.status == "W"), -1)

    def take(self, start: int, end: int, request_id: int, loaded: bool = False) -> None:
        """Queue an order between two vertices; `loaded`: the cargo is on board, drive to `end` at once."""
        self.last_order_id += 1
        self.request_id = request_id
        self.orders.append(SimOrder(self.last_order_id, start, end, loaded))
        if self.current_order_id == -1:
            self.restart()

    def drop(self, ids: set[int]) -> int:
        """Remove these orders and return their number. Cargo stays on board."""
        gone = [order for order in self.orders if order.id in ids]
        self.orders = [order for order in self.orders if order.id not in ids]
        if any(order.status == "W" for order in gone):
            self.restart()
        return len(gone)

    def step(self) -> None:
        self.silence = max(0.0, self.silence - STEP)
        self._use_battery()
        held = self.paused or (self.stuck and self.current_order_id != -1)
        if not self._blocked(not (self._quiet or self.paused) and self._driving) and not held:
            before = self.pose
            next(self._work)
            if not self.orders:
                # The warehouse leaves a robot alone that a hand drives.
                self.pose = self.wheels.carry(self.pose, STEP)
                self.idle = min(self.idle, self.wheels.age)
            self.belief.carry(before, self.pose)

    def visit(self, pose: Pose | None) -> None:
        """Drive to a pose beside the graph, unless it has orders: to the nearest vertex, then straight. None:
        stop."""
        if not self.orders:
            self.restart()
            self._work = self._visit(pose)

    def restart(self) -> None:
        """Begin its work again from where it is; cargo of the order in process stays on board."""
        for order in self.orders:
            order.loaded |= order.status == "W" and self.cargo
        self._driving = False
        self._work = self._live()

    def _live(self) -> Work:
        while True:
            if self.orders and (self.battery > EMPTY or self._quiet):
                yield from self._carry_out(self.orders[0])
            elif self.battery < LOW and not self._quiet and self.floor.has("charger"):
                yield from self._charge()
            elif self.bound is not None:
                yield from self._go(self.bound)
            else:
                self.idle += STEP
                yield

    def _carry_out(self, order: SimOrder) -> Work:
        self.idle = 0.0
        order.status = "W"
        if not order.loaded:
            yield from self._drive(order.start)
            yield from _wait(LOADING)
            self.cargo = True
        yield from self._drive(order.end)
        yield from _wait(LOADING)
        self.cargo = False
        self.orders.remove(order)

    def _charge(self) -> Work:
        """Dock until the battery is full, or if orders are waiting, until it is no longer low."""
        self.idle = 0.0
        yield from self._drive(self.floor.vertex_of("charger"))
        while self.battery < (LOW if self.orders else FULL):
            yield

    def _drive(self, target: int) -> Work:
        """Drive the shortest path. An edge that was begun is driven to its end."""
        if self.bound is not None:
            yield from self._go(self.bound)
        while not (path := self._building.graph.path(self.vertex, target)):
            yield  # no way leads there: it stands until its orders change, or the graph
        for vertex in path[1:]:
            yield from self._go(vertex)

    def _go(self, vertex: int) -> Work:
        """Reach a neighbouring vertex: ride to it, or turn towards it and drive."""
        self.bound = vertex
        if self._building.floor_of(vertex) is not self.floor:
            yield from _wait(RIDE)
        else:
            yield from self._reach(*self._spot(vertex))
        self.vertex = vertex
        self.bound = None

    def _roll_to(self, x: float, y: float) -> Work:
        self._driving = True
        yield from super()._roll_to(x, y)
        self._driving = False

    def _visit(self, pose: Pose | None) -> Work:
        if pose is not None:
            yield from self._drive(self.floor.graph.nearest(pose.x, pose.y))
            yield from self._face(math.atan2(pose.y - self.pose.y, pose.x - self.pose.x))
            yield from self._roll_to(pose.x, pose.y)
            yield from self._face(pose.yaw)
        while not self.orders:
            yield
        yield from self._live()

    def _spot(self, vertex: int) -> tuple[float, float]:
        found = self._building.graph.vertices[vertex]
        return found.x, found.y

    def _use_battery(self) -> None:
        at_charger = self.bound is None and self.floor.types[self.vertex] == "charger"
        charging = at_charger and self.current_order_id == -1
        self._charge_by(CHARGE if charging else -DRAIN if self._driving else -DRAIN_STANDING)


def _wait(seconds: float) -> Work:
    for _ in range(round(seconds / STEP)):
        yield
