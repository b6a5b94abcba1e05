"""A fleet in the console's state without a wire: the simulator's world, told as events."""

import time
from collections.abc import Iterator

from fleet_tui.config.start import initial_state
from fleet_tui.model import events
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.simulator.floorplan import HEIGHT, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.state.store import Store
from fleet_tui.text.language import Message
from tests.support.fleets import order, order_queue
from tests.support.watched_store import config_of

TICK = 0.1
SLOW = 5  # ticks from one report of what changes rarely to the next


class DrivenFleet:
    """`step` lets a tick of time pass and tells the store what robots would tell in it."""

    def __init__(self, robots: int) -> None:
        self._world = OhFleet(robots, 1, seed=1)
        self.config = config_of("ws://site:9090", robots)
        self.store = Store(initial_state(self.config, time.monotonic()))
        self._ticks = 0
        for event in self._start():
            self.store.apply(event)

    def _start(self) -> Iterator[events.Event]:
        now = time.monotonic()
        yield events.LinkChanged("rosbridge", now, Phase.UP)
        yield events.CommandPathChanged("rosbridge", CommandPath.ALIVE, Message(""))
        floor = self._world.building.floors[0]
        labels = {str(id_): label for id_, label in floor.labels.items()}
        vertices = {str(one.id): Vertex(str(one.id), one.x, one.y) for one in floor.graph.vertices.values()}
        edges = tuple(Edge(str(one.id), str(one.start), str(one.end)) for one in floor.graph.edges)
        graph = RouteGraph(vertices, edges)
        frame = MapFrame(RESOLUTION, WIDTH, HEIGHT, Pose(*ORIGIN))
        for name in self._world.robots:
            yield events.GraphReceived(name, floor.name, graph)
            yield events.LabelsReceived(name, floor.name, labels)
            yield events.FrameReceived(name, floor.name, frame)
        cells = floor.cells.astype("int8").tobytes()
        yield events.GridReceived("robot_0", floor.name, grid_from_ros(frame, cells))

    def step(self) -> None:
        self._world.step(TICK)
        self._ticks += 1
        for event in self._reports(time.monotonic(), time.time()):
            self.store.apply(event)

    def _reports(self, now: float, wall: float) -> Iterator[events.Event]:
        for name, robot in self._world.robots.items():
            yield events.PoseReported(name, now, robot.pose, robot.floor.name, wall)
            if self._ticks == 1 or (self._ticks + robot.index) % SLOW == 0:
                yield events.BatteryReported(name, now, robot.battery)
                yield events.CargoReported(name, now, robot.cargo)
                yield events.ObstacleReported(name, now, robot.obstacle)
                orders = (order(one.id, one.start, one.end, one.status) for one in robot.orders)
                queue = order_queue(robot.last_order_id, robot.current_order_id, *orders)
                yield events.QueueReported(name, now, queue)
        yield events.MessageArrived("rosbridge", now)
        yield events.TimePassed(now, wall)
