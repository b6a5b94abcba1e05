"""Goals that clients send to action servers through the bridge, with their feedback and results."""

import asyncio
import time
import uuid
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from fleet_tui.simulator.channels import resolve
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.frames import to_json
from fleet_tui.simulator.ros.definitions import ACTIONS
from fleet_tui.simulator.ros.dialect import Dialect, Message
from fleet_tui.simulator.ros.errors import BridgeError, ServiceError
from fleet_tui.simulator.ros.filling import fill
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.sessions.client import Client
from fleet_tui.simulator.sessions.operations import Operation

REMEMBERED = 1000  # goals whose clients wait for the result
SOUGHT = 1.0  # seconds for which the bridge waits for an action server to appear

Ended = asyncio.Future[None]
"""Done once the result has been sent to the client."""


@dataclass(eq=False)
class _Given:
    client: Client
    operation: Operation
    fleet: Fleet
    server: ActionServer
    goal: ServedGoal
    ended: Ended = field(default_factory=asyncio.Future)


class ActionDesk:
    """Its attributes are for tests to read and change."""

    def __init__(self, fleets: Iterable[Fleet], dialect: Dialect, unsourced: set[str]) -> None:
        self._dialect = dialect
        self._unsourced = unsourced
        self._servers = {name: (fleet, server) for fleet in fleets for name, server in fleet.actions.items()}
        self._given: list[_Given] = []
        self.reports_failure = True
        """False: a goal that is rejected, or for which there is no server, is never answered."""

    @property
    def names(self) -> list[str]:
        """The action servers that are there."""
        return [name for name, (_, server) in self._servers.items() if server.alive]

    def send(self, client: Client, operation: Operation) -> Ended:
        name = resolve(operation["action"])
        fleet, server = self._servers.get(name, (None, None))
        try:
            type_ = self._type(operation["action_type"])
            request = self._request(type_, operation.get("args"))
        except ServiceError as error:
            return self._fail(client, operation, str(error))
        if fleet is None or server is None or server.type != type_ or not server.alive:
            return self._fail(client, operation, "No action server available", SOUGHT)
        goal = server.take(uuid.uuid4().bytes, time.time_ns(), request)
        if goal is None:
            if not self.reports_failure:
                return asyncio.Future()
            return self._fail(client, operation, "Action goal was rejected")
        given = _Given(client, operation, fleet, server, goal)
        self._given.append(given)
        del self._given[:-REMEMBERED]
        return given.ended

    def cancel(self, client: Client, operation: Operation) -> None:
        """Cancel the newest goal of this id that the same client sent. Raises BridgeError."""
        for given in reversed(self._given):
            if given.client is client and given.operation.get("id") == operation.get("id"):
                given.server.cancel(given.goal.id, 0)
                return
        raise BridgeError(f"No goal with id {operation.get('id')} to cancel")

    def publish_feedback(self) -> None:
        for given in self._given:
            if given.operation.get("feedback") and given.server.alive and not given.goal.over:
                values = given.fleet.feedback(given.server, given.goal, self._dialect)
                if values is not None:
                    self._send(given.client, given.operation, "action_feedback", {"values": values})

    def send_results(self) -> None:
        """Send the results of ended goals; a dead server never sends any."""
        for given in list(self._given):
            if not given.server.alive:
                self._given.remove(given)
            elif given.goal.over and (values := given.fleet.result(given.server, given.goal)) is not None:
                self._given.remove(given)
                self._send_result(given.client, given.operation, values, given.goal.status, True)
                given.ended.set_result(None)

    def gone(self, client: Client) -> None:
        """Forget a client; its goals continue."""
        self._given = [given for given in self._given if given.client is not client]

    def _type(self, asked: str) -> str:
        type_ = self._dialect.short(asked)
        package, _, name = type_.partition("/")
        packages = {action.partition("/")[0] for action in ACTIONS}
        if package in self._unsourced or package not in packages:
            raise ServiceError(self._dialect.unknown_package(package, "action"))
        if type_ not in ACTIONS:
            why = f"module '{package}.action' has no attribute '{name}'"
            raise ServiceError(
                f"Unable to import action class {name} from package {package}. Caused by {why}"
            )
        return type_

    def _request(self, type_: str, args: object) -> Message:
        return fill(self._dialect, f"{type_}_Goal", ACTIONS[type_][0], args, time.time())

    def _fail(self, client: Client, operation: Operation, message: str, delay: float = 0.0) -> Ended:
        ended = Ended()

        def fail() -> None:
            self._send_result(client, operation, message, 0, False)
            ended.set_result(None)

        if delay == 0.0:
            fail()
        elif self.reports_failure:
            asyncio.get_running_loop().call_later(delay, fail)
        return ended

    def _send_result(
        self, client: Client, operation: Operation, values: Any, status: int, result: bool
    ) -> None:
        content = {"values": values, "status": status, "result": result}
        self._send(client, operation, "action_result", content)

    def _send(self, client: Client, operation: Operation, op: str, content: Message) -> None:
        id_ = {"id": operation["id"]} if operation.get("id") is not None else {}
        client.reply(to_json({"op": op, "action": operation["action"], **content, **id_}))
