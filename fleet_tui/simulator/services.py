"""Answers service calls as the bridge words them, with doors through which tests make them fail."""

import time
from collections.abc import Callable, Mapping
from typing import Any

from fleet_tui.simulator.frames import Frame, to_json
from fleet_tui.simulator.ros_types import ROBOT_SERVICES, ServiceError, fill
from fleet_tui.simulator.rosapi import SERVICES as ROSAPI_SERVICES
from fleet_tui.simulator.rosapi import Rosapi
from fleet_tui.simulator.world import World

REMEMBERED = 10_000  # calls and operations kept for tests

Values = dict[str, Any]


class ServiceDesk:
    """The services of a world's robots and rosapi's. Its attributes are for tests to read and change."""

    def __init__(self, world: World, topics: Mapping[str, str], subscribed: Callable[[str], bool]) -> None:
        self.world = world
        self.calls: list[tuple[str, Values]] = []
        """Every call that arrived with its args, rosapi's left out; the newest last."""
        self.silent_services: set[str] = set()
        """Services that are never answered and do nothing."""
        self.frozen: dict[str, float] = {}
        """Services whose node wakes only so many seconds after a call."""
        self.answers: dict[str, Callable[[Values], Values]] = {}
        """Answers instead of the world's, made from the args; a ServiceError makes the call fail."""
        self.master_alive = True
        """False: every call fails while topics go on."""
        self.rosapi_alive = True
        """False: rosapi's services do not exist."""
        self.unsourced: set[str] = set()
        """Packages that the bridge doesn't have: it can handle none of their messages and services."""
        robots = [f"/{robot}/Application_layout/" for robot in world.robots]
        self.services = {robot + verb: type_ for robot in robots for verb, type_ in ROBOT_SERVICES.items()}
        self._rosapi = Rosapi(topics, self.services, subscribed, time.time)

    def answer(self, operation: Mapping[str, Any]) -> Frame | None:
        """The frame that answers a call_service operation, None where nothing is ever said."""
        service, args = operation["service"], operation.get("args")
        if not service.startswith("/rosapi/"):
            self.calls.append((service, args if isinstance(args, dict) else {}))
            del self.calls[:-REMEMBERED]
        if service in self.silent_services:
            return None
        values: Values | str
        try:
            values = self._values(service, args)
        except ServiceError as error:
            values = str(error)
        answer = {
            "op": "service_response",
            "service": service,
            "values": values,
            "result": not isinstance(values, str),
        }
        if operation.get("id") is not None:
            answer["id"] = operation["id"]
        return to_json(answer)

    def carry_out(self, service: str, args: object) -> Values:
        """Let a robot's service do what it is there for, and return its answer. Raises ServiceError."""
        type_ = self.services[service]
        package = type_.name.partition("/")[0]
        if package in self.unsourced:
            raise ServiceError(f"Unable to load the manifest for package {package}. Caused by: {package}")
        return self.world.answer(service, fill(type_, args))

    def _values(self, service: str, args: object) -> Values:
        if not self.master_alive:
            raise ServiceError("Unable to communicate with master!")
        if service in self.answers:
            return self.answers[service](args if isinstance(args, dict) else {})
        if service in self.services:
            return self.carry_out(service, args)
        if service in ROSAPI_SERVICES and self.rosapi_alive:
            return self._rosapi.answer(service, args)
        raise ServiceError(f"Service {service} does not exist")
