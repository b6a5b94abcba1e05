"""Faults of services and topics on the wire, while the robot itself works correctly."""

import asyncio
import json
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from fleet_tui.simulator.faults.plays import Play, every
from fleet_tui.simulator.ros.errors import HandlerError, NodeDiedError

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.calls import Call
    from fleet_tui.simulator.frames import Frame
    from fleet_tui.simulator.server import RosbridgeServer

Values = dict[str, Any]

ORDERS = "Execute_order"
LATE = 8.0  # seconds after which `late` answers, and `late-call` begins
SLOW = 6.0  # seconds after which `slow-answer` answers: a ROS 2 bridge abandons a call after 5
OBEYS = 12.0  # seconds from the answer of `obeys-late` until the command is carried out
CARRIED = 40.0  # messages a second that an `overloaded` bridge carries: those of two robots
AGAIN = 3.0  # seconds after which what is not latched is published again
GONE = 5.0  # seconds after which `unregistered` has no services


def _services(server: "RosbridgeServer", robot: str, verb: str = "") -> list[str]:
    own = [name for name in server.bridge.services.offered if name.startswith(f"/{robot}/")]
    return [name for name in own if name.rpartition("/")[2].startswith(verb)]


def _answered(answer: Callable[["RosbridgeServer", str, Values], Values], verb: str = "") -> Play:
    """Return a fault of the services themselves: `answer` replaces their answers."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        for service in _services(server, robot, verb):
            server.bridge.services.answers[service] = partial(answer, server, service)

    return play


def _refused(_server: "RosbridgeServer", _service: str, args: Values) -> Values:
    return {"request_id": args.get("request_id", 0), "status": "REJECTED: the simulator was asked to refuse"}


def _obeyed_late(server: "RosbridgeServer", service: str, args: Values) -> Values:
    asyncio.get_running_loop().call_later(OBEYS, server.bridge.services.carry_out, service, args)
    verb = service.rpartition("/")[2]
    if verb.startswith(ORDERS):
        return {"request_id": args.get("request_id", 0), "status": "executed"}
    return {"success": True, "message" if verb in ("Pause", "Resume") else "status": "executed"}


def _died(server: "RosbridgeServer", service: str, args: Values) -> Values:
    server.bridge.services.carry_out(service, args)
    raise NodeDiedError


def _thrown(_server: "RosbridgeServer", _service: str, _args: Values) -> Values:
    raise HandlerError("no route")


refuse, dies, throws = (_answered(answer, ORDERS) for answer in (_refused, _died, _thrown))
obeys_late = _answered(_obeyed_late)


def never(server: "RosbridgeServer", robot: str) -> None:
    """Neither answer nor carry out a command."""
    server.bridge.services.silent_services.update(_services(server, robot))


def late_call(server: "RosbridgeServer", robot: str) -> None:
    """Begin an order only when the frozen node wakes."""
    server.bridge.services.frozen.update(dict.fromkeys(_services(server, robot, ORDERS), LATE))


def _delivered(deliver: Callable[["RosbridgeServer", "Call", "Frame"], None]) -> Play:
    """Return a fault in the delivery of answers; the service itself works correctly."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        for service in _services(server, robot):
            server.bridge.services.deliveries[service] = lambda call, frame: deliver(server, call, frame)

    return play


def _late(_server: "RosbridgeServer", call: "Call", frame: "Frame") -> None:
    call.reply_in(LATE, frame)


def _slow(_server: "RosbridgeServer", call: "Call", frame: "Frame") -> None:
    call.reply_in(SLOW, frame)


def _twice(_server: "RosbridgeServer", call: "Call", frame: "Frame") -> None:
    call.reply(frame)
    call.reply(frame)


def _wrong_id(_server: "RosbridgeServer", call: "Call", frame: "Frame") -> None:
    answer = json.loads(frame)
    call.reply(json.dumps(answer | {"id": f"not-{answer.get('id')}"}))


def _drop(server: "RosbridgeServer", _call: "Call", _frame: "Frame") -> None:
    server.abort_clients()


late, slow_answer, twice, wrong_id, drop = map(_delivered, (_late, _slow, _twice, _wrong_id, _drop))


def without(topic: str) -> Play:
    """Return a fault that a robot does not publish a topic."""
    return lambda server, robot: server.bridge.muted.add(f"/{robot}/{topic}")


def _lose_services(server: "RosbridgeServer", robot: str) -> None:
    for service in _services(server, robot):
        del server.bridge.services.offered[service]


def unregistered(server: "RosbridgeServer", robot: str) -> None:
    """Lose the services, as after a restart of the ROS master; telemetry flows on."""
    every(server, robot, GONE, lambda: _lose_services(server, robot))


def _disallowed(what: str, *allowed: str) -> Play:
    """Return a fault that clients may use no `topic`, `service` or `action` of a robot."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        others = [f"/{name}/*" for name in server.bridge.services.robots if name != robot]
        server.bridge.allowed[what] = (*allowed, *others)

    return play


topics_glob = _disallowed("topic", "/rosout", "/diagnostics")
services_glob = _disallowed("service", "/rosapi/*")
actions_glob = _disallowed("action")


def lost_master(server: "RosbridgeServer", robot: str) -> None:
    """Restart the ROS master without rosapi: no service is known any more, not even the bridge's own."""
    dead_rosapi(server, robot)
    server.bridge.services.answers.clear()
    _lose_services(server, robot)


def frozen_rosapi(server: "RosbridgeServer", _robot: str) -> None:
    server.bridge.services.silent_services.update(server.bridge.services.rosapi.services)


def unsourced(*packages: str) -> Play:
    """Return a fault that the bridge lacks packages of messages."""

    def play(server: "RosbridgeServer", _robot: str) -> None:
        dialect = server.bridge.dialect
        names = [dialect.short(dialect.message_type(f"{package}/Any")) for package in packages]
        server.bridge.services.unsourced.update(name.partition("/")[0] for name in names)

    return play


def overloaded(server: "RosbridgeServer", _robot: str) -> None:
    server.bridge.services.capacity = CARRIED


def dead_rosapi(server: "RosbridgeServer", _robot: str) -> None:
    server.bridge.services.rosapi_alive = False


def half_dead(server: "RosbridgeServer", _robot: str) -> None:
    """End the bridge's ROS thread: it sends no topic, and no call of an existing service is answered."""
    services = server.bridge.services
    server.bridge.muted.update(server.bridge.topics)
    services.silent_services.update([*services.offered, *services.rosapi.services, *services.answers])


def volatile_maps(server: "RosbridgeServer", robot: str) -> None:
    """Publish maps, graphs and labels repeatedly instead of latched."""
    topics = server.bridge.topics.items()
    _repeat(
        server, robot, [name for name, topic in topics if topic.latched and name.startswith(f"/{robot}/")]
    )


def volatile_pose(server: "RosbridgeServer", robot: str) -> None:
    """Publish the place of the localisation repeatedly instead of latched, as slam_toolbox does."""
    _repeat(server, robot, [f"/{robot}/amcl_pose"])


def _repeat(server: "RosbridgeServer", robot: str, names: list[str]) -> None:
    server.bridge.topics |= {name: replace(server.bridge.topics[name], latched=False) for name in names}

    def publish() -> None:
        for name in names:
            kept = server.bridge.topics[name].history
            for payload in (None,) if kept is None else kept():
                server.bridge.publish(name, payload)

    every(server, robot, AGAIN, publish)
