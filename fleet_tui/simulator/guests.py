"""Topics that clients publish and services that clients offer, through the bridge."""

import time
from collections.abc import Collection, Mapping, MutableMapping
from dataclasses import dataclass, field, replace
from itertools import count

from fleet_tui.simulator.calls import Call
from fleet_tui.simulator.channels import resolve
from fleet_tui.simulator.frames import Payload, to_json
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.ros.definitions import SERVICES
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.errors import ServiceError
from fleet_tui.simulator.ros.filling import ServiceType, fill, fill_request
from fleet_tui.simulator.sessions.client import Client
from fleet_tui.simulator.sessions.operations import Operation


@dataclass(eq=False)
class _Offer:
    """A service that a client offers, and the calls that it has not answered yet."""

    client: Client
    type: str
    waiting: dict[str, "Call"] = field(default_factory=dict)
    number: "count[int]" = field(default_factory=lambda: count(1))


class Guests:
    """Keeps the publications and services of clients in `topics`, `types` and `services` while they are
    there.

    `listened`: the topics to which robots listen, with their types; `unsourced`: packages that the bridge
    doesn't have."""

    def __init__(
        self,
        dialect: Dialect,
        topics: MutableMapping[str, Topic],
        types: MutableMapping[str, str],
        services: MutableMapping[str, ServiceType],
        listened: Mapping[str, str],
        unsourced: Collection[str] = (),
    ) -> None:
        self._dialect = dialect
        self._topics = topics
        self._types = types
        self._services = services
        self._listened = listened
        self._offers: dict[str, _Offer] = {}
        self._advertised: dict[str, set[Client]] = {}
        self._unsourced = unsourced
        self.connects_in = 0.0
        """Seconds from a client's advertisement until robots receive its messages."""
        self._since: dict[tuple[Client, str], float] = {}
        self._sequences: dict[str, count[int]] = {}

    def owns(self, name: str) -> bool:
        """Tell whether a topic or a service is a client's."""
        return name in self._advertised or name in self._offers

    def offers(self, service: str) -> bool:
        return service in self._offers

    def advertise(self, client: Client, name: str, type_: str, latched: bool) -> None:
        """Advertise a topic for a client. Raises ServiceError."""
        name = resolve(name)
        short = self._dialect.short(type_)
        package = short.partition("/")[0]
        if self._dialect.fields(short) is None or package in self._unsourced:
            raise ServiceError(self._dialect.unknown_package(package, "msg"))
        known = self._topics.get(name)
        established = known.type if known else self._listened.get(name)
        if established is not None and self._dialect.short(established) != short:
            raise ServiceError(f"Tried to advertise {name} with type {type_}, established is {established}")
        self._since.setdefault((client, name), time.monotonic())
        if known is None:
            full_name = self._dialect.message_type(short)
            nothing = tuple[Payload, ...]()
            self._types[name] = full_name
            self._topics[name] = Topic(
                name, full_name, lambda _now: Payload({}), None, False, latched, lambda: nothing
            )
            self._advertised[name] = set()
        if name in self._advertised:  # otherwise a robot publishes it as well, and continues
            self._advertised[name].add(client)

    def unadvertise(self, client: Client, name: str) -> None:
        name = resolve(name)
        self._since.pop((client, name), None)
        clients = self._advertised.get(name, set())
        clients.discard(client)
        if name in self._advertised and not clients:
            del self._advertised[name]
            del self._topics[name], self._types[name]

    def published(self, client: Client, operation: Operation) -> tuple[str, Payload]:
        """The topic and the message that a client publishes, completed. Raises ServiceError."""
        name = resolve(operation["topic"])
        known = self._topics.get(name)
        if known is None or operation.get("type") or (client, name) not in self._since:
            type_ = operation.get("type") or self._listened.get(name) or (known.type if known else "")
            self.advertise(client, name, type_, bool(operation.get("latch")))
            known = self._topics[name]
        short, now = self._dialect.short(known.type), time.time()
        msg = fill(self._dialect, short, self._dialect.fields(short) or {}, operation["msg"], now)
        if "seq" in msg.get("header", {}):  # of ROS 1, where a publisher counts its messages
            msg["header"]["seq"] = next(self._sequences.setdefault(name, count(1)))
        payload = Payload(msg)
        if known.latched and name in self._advertised:
            self._topics[name] = replace(known, history=lambda: (payload,))
        return name, payload

    def connected(self, client: Client, name: str) -> bool:
        """Tell whether robots receive a client's messages on a topic."""
        return time.monotonic() - self._since[client, name] >= self.connects_in

    def offer(self, client: Client, name: str, type_: str) -> None:
        """Advertise a service for a client. Raises ServiceError."""
        for defined, (request, _) in SERVICES.items():
            full_name = self._dialect.service_type(defined)
            if type_ in (full_name, self._dialect.short(full_name)):
                self._offers[resolve(name)] = _Offer(client, self._dialect.short(full_name))
                self._services[resolve(name)] = ServiceType(full_name, request)
                return
        raise ServiceError(self._dialect.unknown_package(type_.partition("/")[0], "srv"))

    def withdraw(self, client: Client, name: str) -> None:
        offer = self._offers.get(resolve(name))
        if offer is not None and offer.client is client:
            del self._offers[resolve(name)], self._services[resolve(name)]

    def forward(self, service: str, call: "Call") -> None:
        """Bring a call to the client that offers the service. Raises ServiceError."""
        offer = self._offers[service]
        request = fill_request(
            self._dialect, self._services[service], call.operation.get("args"), time.time()
        )
        id_ = f"service_request:{service}:{next(offer.number)}"
        offer.waiting[id_] = call
        offer.client.reply(to_json({"op": "call_service", "id": id_, "service": service, "args": request}))

    def answered(self, operation: Operation) -> None:
        """Pass a client's answer to the caller."""
        offer = self._offers.get(resolve(operation["service"]))
        call = offer.waiting.pop(str(operation.get("id")), None) if offer else None
        if call is not None:
            call.answer(operation.get("values", {}), bool(operation.get("result", True)))

    def gone(self, client: Client) -> None:
        """End everything that a client published and offered."""
        for name in [name for one, name in self._since if one is client]:
            self.unadvertise(client, name)
        for name in [name for name, offer in self._offers.items() if offer.client is client]:
            self.withdraw(client, name)
