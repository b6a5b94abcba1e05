"""Faults to plant at a site, each by its name in docs/doctor.md: what the server or the config gets."""

import asyncio
import ssl
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import replace
from functools import partial
from http import HTTPStatus
from pathlib import Path
from typing import Any

import msgspec
from websockets.asyncio.server import ServerConnection, serve
from websockets.http11 import Request, Response

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.nav2.faults import FAULTS
from fleet_tui.simulator.navigating.faults import navigation_of
from fleet_tui.simulator.ros.errors import ServiceError
from fleet_tui.simulator.ros.filling import ServiceType
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.certificates import sign

Plant = Callable[[RosbridgeServer, Config], Config]
Message = dict[str, Any]


def says(server: RosbridgeServer, topic: str, change: Callable[[Message], Message]) -> None:
    """A topic says something else from now on."""
    said = server.bridge.topics[topic].payload

    def payload(now: float) -> Payload:
        return Payload(change(msgspec.json.decode(said(now).json)))

    server.bridge.topics[topic] = replace(server.bridge.topics[topic], payload=payload)


def renamed(server: RosbridgeServer, old: str, new: str) -> None:
    server.bridge.topics[new] = replace(server.bridge.topics.pop(old), name=new)
    server.bridge.services.types[new] = server.bridge.services.types.pop(old)


def only_listened_to(server: RosbridgeServer, *topics: str) -> None:
    """As the master lists topics that an open console asks for and nobody publishes."""
    types = {name.rpartition("/")[2]: type_ for name, type_ in server.bridge.services.types.items()}
    server.bridge.services.types |= {
        topic: types[topic.rpartition("/")[2]]
        for topic in topics
        if topic not in server.bridge.services.types
    }

    def publishers(args: dict[str, Any]) -> dict[str, Any]:
        there = args["topic"] in server.bridge.services.types and args["topic"] not in topics
        return {"publishers": ["/fleet"] if there else []}

    server.bridge.services.answers["/rosapi/publishers"] = publishers


def retyped(server: RosbridgeServer, topic: str, type_: str) -> None:
    server.bridge.topics[topic] = replace(server.bridge.topics[topic], type=type_)
    server.bridge.services.types[topic] = type_


def on_the_server(change: Callable[[RosbridgeServer], object]) -> Plant:
    def plant(server: RosbridgeServer, config: Config) -> Config:
        change(server)
        return config

    return plant


def in_the_config(**changes: Any) -> Plant:
    return lambda _server, config: msgspec.structs.replace(config, **changes)


def _remove(topic: str, server: RosbridgeServer) -> None:
    del server.bridge.topics[topic], server.bridge.services.types[topic]


def _service(old: str, new: str, server: RosbridgeServer) -> None:
    server.bridge.services.offered[f"/robot_0/Application_layout/{new}"] = server.bridge.services.offered.pop(
        f"/robot_0/Application_layout/{old}"
    )


def _service_type(server: RosbridgeServer) -> None:
    server.bridge.services.offered["/robot_1/Application_layout/Pause"] = ServiceType("std_srvs/Empty", {})


def _silent(server: RosbridgeServer) -> None:
    server.world.robots["robot_1"].silence = float("inf")


def _both(topic: str, change: Callable[[Message], Message], server: RosbridgeServer) -> None:
    """Both robots say the same of floor_0."""
    for robot in ("robot_0", "robot_1"):
        says(server, f"/{robot}/floor_0/{topic}", change)


def _without_edges(vertex: int, graph: Message) -> Message:
    edges = [edge for edge in graph["edges"] if vertex not in (edge["start"], edge["end"])]
    return {**graph, "edges": edges}


def _moved(vertex: int, x: float, graph: Message) -> Message:
    return {
        **graph,
        "vertices": [{**one, "x": x} if one["id"] == vertex else one for one in graph["vertices"]],
    }


def _off(server: RosbridgeServer) -> None:
    server.world.robots["robot_0"].pose = msgspec.structs.replace(
        server.world.robots["robot_0"].pose, x=500.0
    )


def _in_frame(frame: str, pose: Message) -> Message:
    return {**pose, "header": {**pose["header"], "frame_id": frame}}


def _hours_late(pose: Message) -> Message:
    stamp = pose["header"]["stamp"]
    late = {**stamp, "secs": stamp["secs"] - 7200}
    return {**pose, "header": {**pose["header"], "stamp": late}}


def _tasks(queue: Message) -> Message:
    orders = queue.pop("orders")
    return {**queue, "tasks": orders}


def _no_rosapi(server: RosbridgeServer) -> None:
    server.bridge.services.rosapi_alive = False


def _no_master(server: RosbridgeServer) -> None:
    server.bridge.services.master_alive = False


def _renamed_and_listened_to(server: RosbridgeServer) -> None:
    renamed(server, "/robot_0/queue", "/robot_0/action_queue")
    only_listened_to(server, "/robot_0/queue")


def _elsewhere(server: RosbridgeServer) -> None:
    """The robots run where the bridge does not see them."""
    services = server.bridge.services
    for there in (server.bridge.topics, services.types, services.offered):
        for name in [name for name in there if name.startswith("/robot_")]:
            del there[name]


def _secure(server: RosbridgeServer, config: Config) -> Config:
    return msgspec.structs.replace(config, rosbridge=Link(server.url.replace("ws://", "wss://")))


def _alone(server: RosbridgeServer) -> None:
    """One more robot, without a namespace."""
    for end in ("odom", "amcl_pose", "battery_state"):
        topic = server.bridge.topics[f"/robot_0/{end}"]
        server.bridge.topics[f"/{end}"] = replace(topic, name=f"/{end}")
        server.bridge.services.types[f"/{end}"] = topic.type


def _slip_and_listened_to(server: RosbridgeServer, config: Config) -> Config:
    keys = ("pose", "queue", "battery", "floor_0/graph")
    only_listened_to(server, *(f"/robot_00/{key}" for key in keys))
    return msgspec.structs.replace(config, robots=ONE_ROBOT)


def _unsourced(server: RosbridgeServer) -> None:
    server.bridge.services.unsourced.add("OH_ressources")


def _unregistered(server: RosbridgeServer) -> None:
    server.bridge.services.offered.clear()


def _frozen_rosapi(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.update(server.bridge.services.rosapi.services)


def _killed_rosapi(server: RosbridgeServer) -> None:
    """As a bridge of ROS 1 answers: the master still lists its services."""

    def fail(service: str, _args: Message) -> Message:
        raise ServiceError(f"Unable to communicate with service [{service}], address [rosrpc://site:41000]")

    services = server.bridge.services
    services.answers |= {name: partial(fail, name) for name in services.rosapi.services}


def _failing_rosapi(server: RosbridgeServer) -> None:
    def fail(_args: Message) -> Message:
        detail = "service [/rosapi/topics] responded with an error: b'error processing request: boom'"
        raise ServiceError(detail)

    server.bridge.services.answers["/rosapi/topics"] = fail


def _lost_subscriptions(server: RosbridgeServer) -> None:
    """As after a restart of the master, with other clients that hold the topics."""
    server.bridge.orphaned.update(name for name in server.bridge.topics if name.startswith("/robot_0/"))


def _dead_node(server: RosbridgeServer) -> None:
    """One node of robot_0 publishes two topics and offers a service; it is killed, and stays registered."""
    dead = {"/robot_0/battery", "/robot_0/cargo", "/robot_0/Application_layout/Pause"}
    server.bridge.muted |= dead

    def publishers(args: Message) -> Message:
        return {"publishers": ["/robot_0/base" if args["topic"] in dead else "/fleet"]}

    def owner(args: Message) -> Message:
        return {"node": "/robot_0/base" if args["service"] in dead else "/fleet"}

    server.bridge.services.answers |= {"/rosapi/publishers": publishers, "/rosapi/service_node": owner}


def spelled_as_ros_2(server: RosbridgeServer) -> None:
    """Lower-case packages, CamelCase names and a middle part."""

    def spelled(type_: str, middle: str) -> str:
        package, _, name = type_.partition("/")
        camel = "".join(part[0].upper() + part[1:] for part in name.split("_"))
        return f"{package.lower()}/{middle}/{camel}"

    for topic in list(server.bridge.topics):
        retyped(server, topic, spelled(server.bridge.services.types[topic], "msg"))
    for name, type_ in server.bridge.services.offered.items():
        server.bridge.services.offered[name] = replace(type_, name=spelled(type_.name, "srv"))


AT = "/robot_0/floor_0/"
ONE_ROBOT = [RobotEntry("robot_00"), RobotEntry("robot_1")]
NO_FILE = [FloorEntry("floor_0", map="maps/ground.yaml"), FloorEntry("floor_1")]
NO_GRAPH = [FloorEntry("floor_0", graph="routes.geojson"), FloorEntry("floor_1")]

PLANTS: dict[str, Plant] = {
    "an unknown host": in_the_config(rosbridge=Link("ws://robot-server.invalid:9090")),
    "a dead port": in_the_config(rosbridge=Link("ws://127.0.0.1:9")),
    "TLS where none is spoken": _secure,
    "no ROS master": on_the_server(_no_master),
    "no rosapi": on_the_server(_no_rosapi),
    "robots at another ROS master": on_the_server(_elsewhere),
    "a misspelt robot name": in_the_config(robots=ONE_ROBOT),
    "a misspelt floor name": in_the_config(floors=[FloorEntry("floor_00"), FloorEntry("floor_1")]),
    "a silent robot": on_the_server(_silent),
    "a renamed topic": on_the_server(partial(renamed, old="/robot_0/queue", new="/robot_0/action_queue")),
    "a renamed topic whose old name a console subscribes to": on_the_server(_renamed_and_listened_to),
    "a misspelt robot name that an open console uses too": _slip_and_listened_to,
    "a message package that the bridge lacks": on_the_server(_unsourced),
    "a frozen rosapi": on_the_server(_frozen_rosapi),
    "a rosapi that was killed": on_the_server(_killed_rosapi),
    "a rosapi with an internal error": on_the_server(_failing_rosapi),
    "nodes that the ROS master does not know": on_the_server(_unregistered),
    "a bridge that lost its subscriptions": on_the_server(_lost_subscriptions),
    "a dead node": on_the_server(_dead_node),
    "a battery that is not a number": on_the_server(
        partial(says, topic="/robot_1/battery", change=lambda _: {"data": None})
    ),
    "types in ROS 2 spelling": on_the_server(spelled_as_ros_2),
    "a missing topic": on_the_server(partial(_remove, "/robot_0/cargo")),
    "a wrong type": on_the_server(partial(retyped, topic="/robot_1/battery", type_="std_msgs/Float64")),
    "a topic without messages": on_the_server(lambda server: server.bridge.muted.add("/robot_0/pose")),
    "a field with another name": on_the_server(partial(says, topic="/robot_0/queue", change=_tasks)),
    "a graph that is not latched": on_the_server(lambda server: server.bridge.muted.add(AT + "graph")),
    "a renamed service": on_the_server(partial(_service, "Pause", "Pause_robot")),
    "a service of another type": on_the_server(_service_type),
    "a map of the wrong size": on_the_server(
        partial(_both, "map_metadata", lambda metadata: {**metadata, "width": 640})
    ),
    "a missing map file": in_the_config(floors=NO_FILE),
    "a missing graph file": in_the_config(floors=NO_GRAPH),
    "an unreachable vertex": on_the_server(partial(_both, "graph", partial(_without_edges, 19))),
    "a vertex off the map": on_the_server(partial(_both, "graph", partial(_moved, 0, 400.0))),
    "a vertex in a wall": on_the_server(partial(_both, "graph", partial(_moved, 0, -1.45))),
    "a label of a missing vertex": on_the_server(
        partial(
            _both,
            "labeled_vertices",
            lambda labels: {"vertices": [*labels["vertices"], {"label": "Attic", "vertex_id": 77}]},
        )
    ),
    "an unknown frame_id": on_the_server(
        partial(says, topic="/robot_0/pose", change=partial(_in_frame, "floor_00"))
    ),
    "a robot off the map": on_the_server(_off),
    "a clock two hours behind": on_the_server(partial(says, topic="/robot_1/pose", change=_hours_late)),
}
"""The fault planted behind (or before) a rosbridge."""


def _overloaded(server: RosbridgeServer) -> None:
    server.bridge.services.capacity = (
        6.0  # messages a second, of which the robots send 40: it never answers the last call
    )


def _volatile(server: RosbridgeServer) -> None:
    """The topics of floors are not latched, and are published twice a second."""
    names = [name for name, topic in server.bridge.topics.items() if "/floor_" in name]
    server.bridge.topics |= {name: replace(server.bridge.topics[name], latched=False) for name in names}
    age = 0.0

    def step(dt: float) -> None:
        nonlocal age
        age += dt
        if age > 0.5:
            age = 0.0
            for name in names:
                server.bridge.publish(name)

    server.world.troubles.append(step)


def _small_messages(server: RosbridgeServer) -> None:
    server.bridge.max_message_size = 100_000


def _unsourced_on_ros_2(server: RosbridgeServer) -> None:
    server.bridge.services.unsourced.add("oh_ressources")


def _only_its_robots(server: RosbridgeServer) -> None:
    server.bridge.allowed["service"] = ("/robot_*",)


ROS_2_PLANTS: dict[str, Plant] = {
    "on ROS 2 topics that topics_glob lacks": on_the_server(
        lambda server: play(server, [("topics-glob", "robot_0")])
    ),
    "on ROS 2 a services_glob without rosapi": on_the_server(_only_its_robots),
    "on ROS 2 robots of another domain": on_the_server(_elsewhere),
    "on ROS 2 a message package that the bridge lacks": on_the_server(_unsourced_on_ros_2),
    "on ROS 2 floor topics published volatile, repeatedly": on_the_server(_volatile),
    "on ROS 2 a map larger than the bridge's messages": on_the_server(_small_messages),
    "on ROS 2 a bridge that falls behind": on_the_server(_overloaded),
    "on ROS 2 a frozen rosapi": on_the_server(_frozen_rosapi),
    "on ROS 2 no rosapi, and types in ROS 1 spelling": lambda server, config: msgspec.structs.replace(
        on_the_server(_no_rosapi)(server, config), profile=Profile()
    ),
    "on ROS 2 a silent robot": on_the_server(_silent),
}
"""The same for a server that speaks as ROS 2."""


async def _web(_reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    writer.write(b"HTTP/1.1 200 OK\r\nServer: nginx\r\nContent-Length: 2\r\n\r\nhi")
    await writer.drain()
    writer.close()


async def _mute(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    await reader.read()
    writer.close()


async def _deaf(connection: ServerConnection) -> None:
    async for _ in connection:
        pass


def _with_fault(name: str) -> Plant:
    return on_the_server(lambda server: FAULTS[name][1](server, "robot_0"))


def _unlocalised(server: RosbridgeServer) -> None:
    """Only its wheels have transforms, and its localisation has no topic."""
    play(server, [("tf-only", "robot_0")])
    navigation_of(server, "robot_0").robot.is_unlocalised = True


def _configured_without_pose(server: RosbridgeServer, config: Config) -> Config:
    server.bridge.withdraw("/robot_0/amcl_pose")
    return msgspec.structs.replace(config, profile=Profile(kind="nav2", topics={"pose": ""}))


def _no_waypoints(server: RosbridgeServer) -> None:
    names = [
        name
        for name in server.bridge.services.fleet_of("robot_0").actions
        if not name.endswith("/follow_waypoints")
    ]
    server.bridge.services.answers["/rosapi/action_servers"] = lambda _args: {"action_servers": names}


def _other_manager(server: RosbridgeServer) -> None:
    manager = "/robot_0/lifecycle_manager_navigation/is_active"
    server.bridge.services.offered["/robot_0/lifecycle_manager/is_active"] = (
        server.bridge.services.offered.pop(manager)
    )


def _command_of_that_name(server: RosbridgeServer) -> None:
    type_ = ServiceType("nav2_msgs/srv/ManageLifecycleNodes", {})
    server.bridge.services.offered["/robot_0/lifecycle_manager_navigation/is_active"] = type_


def _frozen_manager(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.add("/robot_0/lifecycle_manager_navigation/is_active")


def _start_without_odometry(server: RosbridgeServer) -> None:
    for fault in ("bring-up", "no-odom"):
        FAULTS[fault][1](server, "robot_0")


NAV2_PLANTS: dict[str, Plant] = {
    "with Nav2 the bridge of Humble": _with_fault("humble"),
    "with Nav2 a message package that the bridge lacks": _with_fault("unsourced"),
    "with Nav2 a misspelt robot name": in_the_config(robots=[RobotEntry("robot_00")]),
    "with Nav2 a second robot, without a namespace": on_the_server(_alone),
    "with Nav2 a renamed localisation topic": on_the_server(
        partial(renamed, old="/robot_0/amcl_pose", new="/robot_0/localization_pose")
    ),
    "with Nav2 no map": on_the_server(partial(_remove, "/map")),
    "with Nav2 no odometry": _with_fault("no-odom"),
    "with Nav2 a silent robot": _with_fault("silent"),
    "with Nav2 a bridge whose ROS thread has ended": _with_fault("half-dead"),
    "with Nav2 services that services_glob lacks": _with_fault("services-glob"),
    "with Nav2 a missing action server": on_the_server(_no_waypoints),
    "with Nav2 nodes that are not active": _with_fault("inactive"),
    "with Nav2 a dead controller": _with_fault("node-down"),
    "with Nav2 a start that waits for a pose": _with_fault("bring-up"),
    "with Nav2 a start without odometry": on_the_server(_start_without_odometry),
    "with Nav2 a frozen lifecycle manager": on_the_server(_frozen_manager),
    "with Nav2 a lifecycle manager with another name": on_the_server(_other_manager),
    "with Nav2 a command configured as that query": on_the_server(_command_of_that_name),
    "with Nav2 a robot with an uncertain position": _with_fault("lost"),
    "with Nav2 a robot that was never localised": on_the_server(
        lambda server: server.bridge.muted.add("/robot_0/amcl_pose")
    ),
    "with Nav2 a localisation that has died": on_the_server(
        lambda server: server.bridge.withdraw("/robot_0/amcl_pose")
    ),
    "with Nav2 a configuration from while no localisation ran": _configured_without_pose,
    "with Nav2 transforms without a localisation": on_the_server(_unlocalised),
    "with Nav2 a battery that reports 0 to 100": _with_fault("percent"),
    "with Nav2 a battery without measurement": _with_fault("unmeasured"),
}
"""The same for robots with Nav2."""


@asynccontextmanager
async def web_server() -> AsyncIterator[str]:
    """A web server."""
    async with await asyncio.start_server(_web, "127.0.0.1", 0) as server:
        yield f"ws://127.0.0.1:{server.sockets[0].getsockname()[1]}"


@asynccontextmanager
async def elsewhere_on_the_server() -> AsyncIterator[str]:
    """A rosbridge whose url_path is another one."""

    def only_there(connection: ServerConnection, request: Request) -> Response | None:
        return None if request.path == "/ros" else connection.respond(HTTPStatus.NOT_FOUND, "")

    async with serve(_deaf, "127.0.0.1", 0, process_request=only_there) as server:
        yield f"ws://127.0.0.1:{next(iter(server.sockets)).getsockname()[1]}/rosbridge"


@asynccontextmanager
async def mute_server() -> AsyncIterator[str]:
    """A server that takes connections and says nothing."""
    async with await asyncio.start_server(_mute, "127.0.0.1", 0) as server:
        yield f"ws://127.0.0.1:{server.sockets[0].getsockname()[1]}"


@asynccontextmanager
async def other_websocket() -> AsyncIterator[str]:
    """A WebSocket server that is no rosbridge."""
    async with serve(_deaf, "127.0.0.1", 0) as server:
        yield f"ws://127.0.0.1:{next(iter(server.sockets)).getsockname()[1]}"


@asynccontextmanager
async def tls_server(folder: Path, scheme: str) -> AsyncIterator[str]:
    """A server that speaks TLS with a certificate nobody knows."""
    context: ssl.SSLContext = sign(folder, "localhost").server()
    async with serve(_deaf, "127.0.0.1", 0, ssl=context) as server:
        yield f"{scheme}://localhost:{next(iter(server.sockets)).getsockname()[1]}"
