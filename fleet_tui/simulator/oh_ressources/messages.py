"""The topics of the source's robots and floors, and their messages."""

from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache, partial
from itertools import count

from fleet_tui.simulator.floorplan import ORIGIN, Cells
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import GRID, Message, Topic, float32, grid, grid_info, raw_payload, solid
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.warehouse import SimFloor

CellsOf = Callable[[SimFloor], tuple[Cells, tuple[float, float]]]
"""Returns the cells of a floor's map, and the place of its lower left corner."""


def _whole(floor: SimFloor) -> tuple[Cells, tuple[float, float]]:
    return floor.cells, ORIGIN


def topics_of(
    world: World, loaded_at: float, dialect: Dialect = ROS1, cells: CellsOf = _whole
) -> Iterator[Topic]:
    """Every topic of a world whose maps were loaded at this wall time."""
    for robot in world.robots.values():
        type_ = dialect.message_type("geometry_msgs/PoseStamped")
        yield Topic(f"/{robot.name}/pose", type_, _poses(robot, dialect), robot, fast=True)
        for name, (type_, message) in _TELEMETRY.items():
            payload = partial(_now, message, robot, dialect, type_)
            yield Topic(f"/{robot.name}/{name}", dialect.message_type(type_), payload, robot)
    for number, floor in enumerate(world.building.floors):
        for name, type_, value in (
            ("map_metadata", "nav_msgs/MapMetaData", partial(_metadata, dialect.time(loaded_at))),
            ("graph", "OH_ressources/Graph", graph_of),
            ("labeled_vertices", "OH_ressources/LabeledVertices", labels_of),
        ):
            always = _of_floor(world, number, partial(_loaded, value, type_, loaded_at, dialect))
            for robot in world.robots.values():
                topic = f"/{robot.name}/{floor.name}/{name}"
                yield Topic(topic, dialect.message_type(type_), always, latched=True)
        yield from _maps(world, floor, loaded_at, dialect, cells)


def _loaded(
    value: Callable[[SimFloor], Message], type_: str, at: float, dialect: Dialect, floor: SimFloor
) -> Payload:
    return raw_payload(dialect, type_, at, value(floor))


def _of_floor(
    world: World, number: int, payload: Callable[[SimFloor], Payload]
) -> Callable[[float], Payload]:
    """The message of a floor, one for all robots and all subscribers until the floor is redrawn."""
    made = lru_cache(maxsize=1)(payload)
    return lambda _now: made(world.building.floors[number])


def _maps(
    world: World, floor: SimFloor, loaded_at: float, dialect: Dialect, cells: CellsOf
) -> Iterator[Topic]:
    loaded = raw_payload(dialect, GRID, loaded_at, map_of(floor, loaded_at, dialect, cells))

    def payload(now: float) -> Payload:
        is_loaded = cells(floor)[0] is floor.cells
        return loaded if is_loaded else Payload(map_of(floor, now, dialect, cells))

    for robot in world.robots.values():
        yield Topic(f"/{robot.name}/{floor.name}/map", dialect.message_type(GRID), payload, latched=True)


def _now(
    message: Callable[[SimRobot], Message], robot: SimRobot, dialect: Dialect, type_: str, now: float
) -> Payload:
    return raw_payload(dialect, type_, now, message(robot))


def _poses(robot: SimRobot, dialect: Dialect) -> Callable[[float], Payload]:
    sequence = count(1)

    def payload(now: float) -> Payload:
        header = dialect.header(next(sequence), now, robot.floor.name)
        message = {"header": header, "pose": solid(robot.belief.of(robot.pose))}
        return raw_payload(dialect, "geometry_msgs/PoseStamped", now, message)

    return payload


def _queue(robot: SimRobot) -> Message:
    return {
        "request_id": robot.request_id,
        "last_order_id": robot.last_order_id,
        "robot_id": robot.index,
        "current_order_id": robot.current_order_id,
        "orders": [
            {"id": order.id, "start": order.start, "end": order.end, "status": order.status}
            for order in (*robot.ended, *robot.orders)
        ],
    }


_TELEMETRY: Mapping[str, tuple[str, Callable[[SimRobot], Message]]] = {
    "battery": ("std_msgs/Float32", lambda robot: {"data": float32(robot.battery)}),
    "cargo": ("std_msgs/Bool", lambda robot: {"data": robot.cargo}),
    "obstacle": ("std_msgs/Float32", lambda robot: {"data": float32(robot.obstacle)}),
    "queue": ("OH_ressources/ActionQueue", _queue),
    "paused": ("std_msgs/Bool", lambda robot: {"data": robot.paused}),
}


def _metadata(loaded: Message, floor: SimFloor) -> Message:
    return grid_info(floor.cells, ORIGIN, loaded)


def graph_of(floor: SimFloor) -> Message:
    """OH_ressources/Graph."""
    return {
        "vertices": [
            {"id": vertex.id, "x": vertex.x, "y": vertex.y, "type": floor.types[vertex.id]}
            for vertex in floor.graph.vertices.values()
        ],
        "edges": [{"id": edge.id, "start": edge.start, "end": edge.end} for edge in floor.graph.edges],
    }


def labels_of(floor: SimFloor) -> Message:
    """OH_ressources/LabeledVertices."""
    return {"vertices": [{"label": label, "vertex_id": id_} for id_, label in floor.labels.items()]}


def map_of(floor: SimFloor, at: float, dialect: Dialect, cells: CellsOf) -> Message:
    """nav_msgs/OccupancyGrid, as a robot knows a floor now."""
    return grid(*cells(floor), dialect.header(1, at, floor.name), dialect.time(at))
