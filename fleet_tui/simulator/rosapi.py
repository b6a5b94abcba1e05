"""rosapi: the topics, services, nodes and types. An unknown name gets an empty answer."""

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from fleet_tui.simulator.ros.definitions import ACTIONS, MESSAGES
from fleet_tui.simulator.ros.definitions import SERVICES as DEFINED_SERVICES
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.errors import NodeDiedError
from fleet_tui.simulator.ros.filling import ServiceType, fill_request, service_type
from fleet_tui.simulator.ros.typedefs import action_typedefs, message_typedefs, service_typedefs

FLEET = "/fleet"
BRIDGE = "/rosbridge_websocket"
ROSAPI = "/rosapi"
HIDDEN = "/_action/"  # topics and services inside an action are not listed
OF_THE_BRIDGE = ("/client_count", "/connected_clients", "/rosout")
Values = dict[str, Any]

_TYPES = {"get_ros_version": "GetROSVersion", "action_servers": "GetActionServers"}


def rosapi_services(dialect: Dialect) -> Mapping[str, ServiceType]:
    """rosapi's services by name."""
    return {f"{ROSAPI}/{verb}": service_type(dialect, _type(dialect, verb)) for verb in dialect.rosapi_verbs}


def _type(dialect: Dialect, verb: str) -> str:
    return dialect.rosapi_type(_TYPES.get(verb, "".join(map(str.capitalize, verb.split("_")))))


@dataclass(frozen=True)
class RosGraph:
    """All topics and services, each name with its type; it may change later.

    `listened`: topics to which robots listen; `subscribed`: those to which the bridge is subscribed, with the
    types it asked for. `action_servers`: not those of ROS 1, where rosapi looks for the topics of an action
    in a row of the sorted list, and those of move_base have the costmaps' between them.
    """

    topics: Mapping[str, str]
    listened: Mapping[str, str]
    services: Mapping[str, ServiceType]
    subscribed: Callable[[], Mapping[str, str]]
    action_servers: Callable[[], list[str]]


class RosapiServer:
    """Answers about a graph. `clock`: the wall time; `own`: whether a topic or service is a client's of the
    bridge. `distro` may be changed."""

    def __init__(
        self, dialect: Dialect, graph: RosGraph, clock: Callable[[], float], own: Callable[[str], bool]
    ) -> None:
        self._dialect = dialect
        self._clock = clock
        self._own = own
        self._graph = graph
        self.distro = dialect.distro
        self.services = rosapi_services(dialect)
        self._params = dict(dialect.params)

    def answer(self, service: str, args: object) -> Values:
        """The answer of one of its services. Raises ServiceError as every service does."""
        request = fill_request(self._dialect, self.services[service], args, self._clock())
        verb = service.removeprefix(f"{ROSAPI}/")
        if verb.endswith(("_param", "_param_names")):
            return self._about_params(verb, request)
        if verb.endswith("_details") and verb != "node_details":
            return {"typedefs": self._typedefs(verb, request["type"])}
        for field, about in (
            ("topic", self._about_topic),
            ("service", self._about_services),
            ("type", self._for_type),
        ):
            if field in request:
                return about(verb, request[field])
        return self._about_nodes(verb, request) if "node" in verb else self._about_all(verb)

    def _about_all(self, verb: str) -> Values:
        match verb:
            case "topics":
                asked = {
                    name: type_ for name, type_ in self._graph.subscribed().items() if HIDDEN not in name
                }
                found = {**asked, **self._graph.listened, **self._graph.topics}
                return {"topics": list(found), "types": list(found.values())}
            case "topics_and_raw_types":
                found = self._about_all("topics")
                texts = ["\n".join(self._fields(type_)) for type_ in found["types"]]
                return found | {"typedefs_full_text": texts}
            case "services":
                return {"services": [*self._known, *self.services]}
            case "get_time":
                return {"time": self._dialect.time(self._clock())}
            case "get_ros_version":
                return {"version": self._dialect.version, "distro": self.distro}
            case "interfaces":
                types = [self._dialect.message_type(name) for name in MESSAGES if "_Feedback" not in name]
                types += [self._dialect.action_type(name) for name in ACTIONS]
                types += [self._dialect.service_type(name) for name in DEFINED_SERVICES]
                return {"interfaces": sorted(set(types))}
            case "action_servers":
                return {"action_servers": self._graph.action_servers()}
        raise NodeDiedError  # action_type: the handler ends the whole of rosapi

    @property
    def _known(self) -> Mapping[str, ServiceType]:
        return {name: type_ for name, type_ in self._graph.services.items() if HIDDEN not in name}

    def _fields(self, type_: str) -> Iterable[str]:
        for name, field in (self._dialect.fields(type_) or {}).items():
            length = "" if field.length is None else f"[{field.length or ''}]"
            yield f"{field.type}{length} {name}"

    def _typedefs(self, verb: str, type_: str) -> list[Values]:
        if verb == "message_details":
            return message_typedefs(self._dialect, type_)
        if verb.startswith("action_"):
            return action_typedefs(self._dialect, type_, verb.split("_")[1].capitalize())
        return service_typedefs(self._dialect, type_, response="response" in verb)

    def _for_type(self, verb: str, type_: str) -> Values:
        if verb == "topics_for_type":
            found = {**self._graph.listened, **self._graph.topics}
            return {"topics": [name for name, other in found.items() if other == type_]}
        return {"services": [name for name, other in self._known.items() if other.name == type_]}

    def _about_services(self, verb: str, service: str) -> Values:
        known = self._known.get(service) or self.services.get(service)
        match verb:
            case "service_type":
                return {"type": known.name if known else ""}
            case "service_host":
                return {"host": "localhost" if known else ""}
            case "service_providers":  # in spite of its name, this argument is a type
                named = self._for_type("services_for_type", service)["services"]
                return {"providers": sorted({self._offering(name) for name in named})}
        return {"node": self._offering(service) if known else ""}

    def _about_topic(self, verb: str, topic: str) -> Values:
        if verb == "topic_type":
            if HIDDEN in topic:
                return {"type": ""}
            known = self._graph.topics.get(topic) or self._graph.listened.get(topic)
            return {"type": known or self._graph.subscribed().get(topic, "")}
        if verb == "publishers":
            return {"publishers": [self._publisher(topic)] if topic in self._graph.topics else []}
        listening = {BRIDGE: self._graph.subscribed(), FLEET: self._graph.listened}
        return {"subscribers": [node for node, topics in listening.items() if topic in topics]}

    def _about_nodes(self, verb: str, request: Values) -> Values:
        nodes = [ROSAPI, BRIDGE, FLEET]
        if verb == "nodes":
            return {"nodes": nodes}
        node = request["node"]
        if node not in nodes and self._dialect.fragile:
            raise NodeDiedError
        return {
            "subscribing": list(
                {BRIDGE: self._graph.subscribed(), FLEET: self._graph.listened}.get(node, ())
            ),
            "publishing": [name for name in self._graph.topics if self._publisher(name) == node],
            "services": [name for name in (*self._known, *self.services) if self._offering(name) == node],
        }

    def _offering(self, service: str) -> str:
        return ROSAPI if service in self.services else BRIDGE if self._own(service) else FLEET

    def _publisher(self, topic: str) -> str:
        return BRIDGE if topic in OF_THE_BRIDGE or self._own(topic) else FLEET

    def _about_params(self, verb: str, request: Values) -> Values:
        if verb == "get_param_names":
            return {"names": list(self._params)}
        name = request["name"]
        if self._dialect.fragile and verb == "has_param" and ":" not in name:
            raise NodeDiedError
        match verb:
            case "set_param":
                self._params[name] = _value(request["value"])
                return {}
            case "delete_param":
                self._params.pop(name, None)
                return {}
            case "has_param":
                return {"exists": name in self._params}
            case "search_param":
                return {"global_name": name if name in self._params else ""}
        found = json.dumps(self._params[name]) if name in self._params else None
        return self._dialect.got_param(found, request)


def _value(text: str) -> Any:
    try:
        return json.loads(text)
    except ValueError:
        return text
