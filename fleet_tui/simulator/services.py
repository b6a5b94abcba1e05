"""Answers service calls with the bridge's texts, with switches for tests to make them fail."""

import asyncio
import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from fleet_tui.simulator.actions import ActionDesk
from fleet_tui.simulator.calls import Call, response
from fleet_tui.simulator.channels import resolve
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.frames import Frame
from fleet_tui.simulator.guests import Guests
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.errors import HandlerError, NodeDiedError, ServiceError
from fleet_tui.simulator.ros.filling import fill_request
from fleet_tui.simulator.rosapi import BRIDGE, HIDDEN, RosapiServer, RosGraph
from fleet_tui.simulator.sessions.client import Client
from fleet_tui.simulator.sessions.operations import Operation
from fleet_tui.simulator.world import Body

WAITING = 1000  # messages that wait for an overloaded bridge; those after them are lost
REMEMBERED = 10_000  # calls and operations kept for tests

Values = dict[str, Any]


class ServiceDesk:
    """The services of all robots and rosapi's. Its attributes are for tests to read and change."""

    capacity: float | None = None
    """Messages a second that the bridge carries; further ones wait. None: no limit."""
    lag = 0.0
    """Seconds by which all messages are late."""
    master_alive = True
    """False: every call fails, topics continue."""
    rosapi_alive = True
    """False: rosapi's services do not exist."""
    _busy_until = 0.0

    def __init__(
        self,
        fleets: Sequence[Fleet],
        dialect: Dialect,
        topics: dict[str, Topic],
        subscribed: Callable[[], Mapping[str, str]],
    ) -> None:
        self.fleets = fleets
        self.dialect = dialect
        self.topics = topics
        self.robots: dict[str, Body] = {name: one for fleet in fleets for name, one in fleet.robots.items()}
        """The robots of all fleets by name."""
        self.types = {topic.name: topic.type for topic in topics.values() if HIDDEN not in topic.name}
        """The types of topics as rosapi lists them."""
        self.calls: list[tuple[str, Values]] = []
        """Every call that arrived with its args, rosapi's left out; the newest last."""
        self.silent_services: set[str] = set()
        """Services that are never answered and do nothing."""
        self.frozen: dict[str, float] = {}
        """Services whose node reacts only this many seconds after a call."""
        is_ros2 = dialect.call_timeout is not None
        of_node: Values = {"values": []} if is_ros2 else {"loggers": []}
        own = f"{BRIDGE}/get_parameters" if is_ros2 else f"{BRIDGE}/get_loggers"
        self.answers: dict[str, Callable[[Values], Values]] = {own: lambda _: of_node}
        """Answers instead of the world's, made from the args; a ServiceError makes the call fail."""
        self.deliveries: dict[str, Callable[[Call, Frame], None]] = {}
        """Functions that deliver the answers of a service, if not immediately."""
        self.unsourced: set[str] = set()
        """Packages that the bridge lacks: it cannot handle their messages and services."""
        self.offered = {name: type_ for fleet in fleets for name, type_ in fleet.services(dialect).items()}
        self.call_timeout = dialect.call_timeout
        """Seconds after which a call without a limit is abandoned, None: never."""
        self.actions = ActionDesk(fleets, dialect, self.unsourced)
        self._connect(subscribed)

    def _connect(self, subscribed: Callable[[], Mapping[str, str]]) -> None:
        dialect = self.dialect
        subscriptions = {name: what for fleet in self.fleets for name, what in fleet.subscriptions().items()}
        self.subscriptions = {name: take for name, (_, take) in subscriptions.items()}
        """The listeners to messages that clients publish to robots, by topic."""
        listened = {name: dialect.message_type(type_) for name, (type_, _) in subscriptions.items()}
        self.guests = Guests(dialect, self.topics, self.types, self.offered, listened, self.unsourced)
        graph = RosGraph(self.types, listened, self.offered, subscribed, lambda: self.actions.names)
        self.rosapi = RosapiServer(dialect, graph, time.time, self.guests.owns)

    def fleet_of(self, robot: str) -> Fleet:
        return next(fleet for fleet in self.fleets if robot in fleet.robots)

    def call(self, client: Client, operation: Operation) -> Call | None:
        """Answer a call once its node reacts, unless the bridge has abandoned it before."""
        service, limit = resolve(operation["service"]), self.call_timeout
        if self.dialect.call_timeout is not None and operation.get("timeout") is not None:
            if not isinstance(operation["timeout"], (int, float)):
                given = type(operation["timeout"]).__name__
                text = f"'>' not supported between instances of '{given}' and 'int'"
                client.reply(response(operation, text, False))
                return None
            limit = operation["timeout"] if operation["timeout"] > 0 else None
        call = Call(client, operation, limit)
        self.in_turn(lambda: self._reply(call, service), self.frozen.get(service, 0.0))
        return call

    def in_turn(self, send: Callable[[], None], delay: float = 0.0) -> None:
        """Send a message `delay` seconds after the bridge has reached it, which is at once unless it lags or
        is overloaded."""
        if self.capacity is not None:
            now = time.monotonic()
            if self._busy_until - now > WAITING / self.capacity:
                return
            self._busy_until = max(self._busy_until, now) + 1.0 / self.capacity
            delay += self._busy_until - now
        delay += self.lag
        if delay:
            asyncio.get_running_loop().call_later(delay, send)
        else:
            send()

    def answer(self, operation: Mapping[str, Any]) -> Frame | None:
        """Return the frame that answers a call_service operation, None if it is never answered."""
        service, args = resolve(operation["service"]), operation.get("args")
        if not service.startswith(("/rosapi/", f"{BRIDGE}/")):
            self.calls.append((service, args if isinstance(args, dict) else {}))
            del self.calls[:-REMEMBERED]
        if service in self.silent_services:
            return None
        try:
            return response(dict(operation), self._values(service, args), True)
        except ServiceError as error:
            failure = self._failure(service, error)
        return None if failure is None else response(dict(operation), failure, False)

    def carry_out(self, service: str, args: object) -> Values:
        """Run a robot's service and return its answer. Raises ServiceError."""
        type_ = self.offered[service]
        package = type_.name.partition("/")[0]
        if package in self.unsourced:
            raise ServiceError(self.dialect.unknown_package(package, "srv"))
        request = fill_request(self.dialect, type_, args, time.time())
        return self.fleet_of(service.split("/")[1]).answer(service, request)

    def _reply(self, call: Call, service: str) -> None:
        if call.given_up:
            return
        if self.guests.offers(service):
            try:
                self.guests.forward(service, call)
            except ServiceError as error:
                call.answer(str(error), False)
            return
        answer = self.answer(call.operation)
        if answer is not None:
            self.deliveries.get(service, Call.reply)(call, answer)

    def _failure(self, service: str, error: ServiceError) -> str | None:
        match error:
            case NodeDiedError():
                if service.startswith("/rosapi/"):
                    self.rosapi_alive = False
                return self.dialect.died()
            case HandlerError():
                return self.dialect.thrown(service, str(error))
        return str(error)

    def _values(self, service: str, args: object) -> Values:
        if not self.master_alive:
            raise ServiceError("Unable to communicate with master!")
        if service in self.answers:
            return self.answers[service](args if isinstance(args, dict) else {})
        if service in self.offered:
            return self.carry_out(service, args)
        if service in self.rosapi.services and self.rosapi_alive:
            return self.rosapi.answer(service, args)
        raise ServiceError(f"Service {service} does not exist")
