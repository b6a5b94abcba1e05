"""rosapi: what topics, services and types there are. An unknown name gets an empty answer, no error."""

from collections.abc import Callable, Mapping
from typing import Any

from fleet_tui.simulator.messages import stamp
from fleet_tui.simulator.ros_types import ServiceType, fill

FLEET, BRIDGE, ROSAPI = "/fleet", "/rosbridge_websocket", "/rosapi"
Values = dict[str, Any]

_TOPIC, _SERVICE, _TYPE = {"topic": "string"}, {"service": "string"}, {"type": "string"}
_NONE: Mapping[str, str] = {}

SERVICES: Mapping[str, ServiceType] = {
    f"{ROSAPI}/{name}": ServiceType(type_, fields)
    for name, type_, fields in (
        ("topics", "rosapi/Topics", _NONE),
        ("topics_for_type", "rosapi/TopicsForType", _TYPE),
        ("services", "rosapi/Services", _NONE),
        ("nodes", "rosapi/Nodes", _NONE),
        ("topic_type", "rosapi/TopicType", _TOPIC),
        ("service_type", "rosapi/ServiceType", _SERVICE),
        ("service_node", "rosapi/ServiceNode", _SERVICE),
        ("publishers", "rosapi/Publishers", _TOPIC),
        ("subscribers", "rosapi/Subscribers", _TOPIC),
        ("message_details", "rosapi/MessageDetails", _TYPE),
        ("service_request_details", "rosapi/ServiceRequestDetails", _TYPE),
        ("get_time", "rosapi/GetTime", _NONE),
    )
}


class Rosapi:
    """Answers about the topics and services given as name -> type; both may change later."""

    def __init__(
        self,
        topics: Mapping[str, str],
        services: Mapping[str, ServiceType],
        subscribed: Callable[[str], bool],
        clock: Callable[[], float],
    ) -> None:
        self._topics, self._services = topics, services
        self._subscribed, self._clock = subscribed, clock

    def answer(self, service: str, args: object) -> Values:
        """The answer of one of SERVICES. Raises ServiceError as every service does."""
        request = fill(SERVICES[service], args)
        verb = service.removeprefix(f"{ROSAPI}/")
        match verb:
            case "topics":
                return {"topics": list(self._topics), "types": list(self._topics.values())}
            case "topics_for_type":
                return {"topics": [name for name, type_ in self._topics.items() if type_ == request["type"]]}
            case "services":
                return {"services": [*self._services, *SERVICES]}
            case "nodes":
                return {"nodes": [ROSAPI, BRIDGE, FLEET]}
            case "get_time":
                return {"time": stamp(self._clock())}
            case "message_details" | "service_request_details":
                return {"typedefs": []}
            case "service_type" | "service_node":
                return self._about_service(verb, request["service"])
            case _:
                return self._about_topic(verb, request["topic"])

    def _about_service(self, verb: str, service: str) -> Values:
        known = self._services.get(service) or SERVICES.get(service)
        if verb == "service_type":
            return {"type": known.name if known else ""}
        owner = ROSAPI if service in SERVICES else FLEET
        return {"node": owner if known else ""}

    def _about_topic(self, verb: str, topic: str) -> Values:
        if verb == "topic_type":
            return {"type": self._topics.get(topic, "")}
        if verb == "publishers":
            return {"publishers": [_publisher(topic)] if topic in self._topics else []}
        return {"subscribers": [BRIDGE] if self._subscribed(topic) else []}


def _publisher(topic: str) -> str:
    return BRIDGE if topic == "/client_count" else FLEET
