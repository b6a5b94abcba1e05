"""The interface profile: what a robot stack calls its topics, services, types and fields.

The defaults are the robots this console was made for; every name can be overridden in the config.
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

import msgspec

TOPICS: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "pose": ("/{robot}/pose", "geometry_msgs/PoseStamped"),
        "queue": ("/{robot}/queue", "OH_ressources/ActionQueue"),
        "obstacle": ("/{robot}/obstacle", "std_msgs/Float32"),
        "battery": ("/{robot}/battery", "std_msgs/Float32"),
        "cargo": ("/{robot}/cargo", "std_msgs/Bool"),
        "paused": ("", "std_msgs/Bool"),
        "map_metadata": ("/{robot}/{floor}/map_metadata", "nav_msgs/MapMetaData"),
        "graph": ("/{robot}/{floor}/graph", "OH_ressources/Graph"),
        "labels": ("/{robot}/{floor}/labeled_vertices", "OH_ressources/LabeledVertices"),
        "map": ("/{robot}/{floor}/map", "nav_msgs/OccupancyGrid"),
    }
)
FLOOR_TOPICS = frozenset({"map_metadata", "graph", "labels", "map"})

SERVICES: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "order": ("/{robot}/Application_layout/Execute_order", "OH_ressources/Execute_manual_order"),
        "order_with_cargo": (
            "/{robot}/Application_layout/Execute_order_with_cargo",
            "OH_ressources/Execute_manual_order_with_cargo",
        ),
        "cancel": ("/{robot}/Application_layout/Cancel_order", "OH_ressources/Cancel_order"),
        "clear": ("/{robot}/Application_layout/Clear_orders", "OH_ressources/Clear_orders"),
        "pause": ("/{robot}/Application_layout/Pause", "std_srvs/Trigger"),
        "resume": ("/{robot}/Application_layout/Resume", "std_srvs/Trigger"),
    }
)

# Only names the source doesn't give can differ.
_FIELDS_OF: Mapping[str, tuple[str, ...]] = {
    "graph": ("vertices", "edges"),
    "vertex": ("id", "x", "y", "type"),
    "edge": ("id", "start", "end"),
    "labels": ("vertices",),
    "label": ("label", "vertex_id"),
    "queue": ("last_order_id", "current_order_id", "orders"),
    "order": ("id", "start", "end", "status"),
    "order_call": ("request_id", "initial_point", "end_point"),
    "cargo_call": ("request_id", "agent", "end_point"),
    "cancel_call": ("robot", "ind"),
}
FIELDS = frozenset(f"{message}.{field}" for message, fields in _FIELDS_OF.items() for field in fields)

# A robot refuses in the text of an answer that says the call itself went well.
REFUSALS = (
    r"(?i)\b(reject|refus|fail|invalid|denied|unknown|unable|cannot|can't|impossible)",
    r"(?i)\bno such\b",
    r"(?i)(?<!without )(?<!without an )(?<!no )\berror",
)

VERTEX_TYPES: Mapping[str, Literal["plain", "elevator", "docking"]] = MappingProxyType(
    {"elevator": "elevator", "charger": "docking", "docking": "docking", "docking_station": "docking"}
)


class Profile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`[profile]`: overrides only. `origin = "added"` where the stack adds the map's origin."""

    name: str = "oh_ressources"
    topics: dict[str, str] = {}
    types: dict[str, str] = {}
    services: dict[str, str] = {}
    service_types: dict[str, str] = {}
    fields: dict[str, str] = {}
    refusals: tuple[str, ...] = REFUSALS
    vertex_types: dict[str, Literal["plain", "elevator", "docking"]] = msgspec.field(
        default_factory=lambda: dict(VERTEX_TYPES)
    )
    directed: bool = False
    origin: Literal["ros", "added"] = "ros"

    def topic(self, key: str, robot: str, floor: str = "") -> str:
        """The name of a topic, empty where this stack has none."""
        template = self.topics.get(key, TOPICS[key][0])
        return template.replace("{robot}", robot).replace("{floor}", floor)

    def type(self, key: str) -> str:
        """The ROS type of a topic."""
        return self.types.get(key, TOPICS[key][1])

    def service(self, key: str, robot: str) -> str:
        """The name of a service."""
        return self.services.get(key, SERVICES[key][0]).replace("{robot}", robot)

    def service_type(self, key: str) -> str:
        """The ROS type of a service. Calls don't name it: only the doctor looks."""
        return self.service_types.get(key, SERVICES[key][1])

    def names(self, message: str) -> dict[str, str]:
        """Our field names to the wire's, for one message of FIELDS, overridden ones only."""
        prefix = message + "."
        return {key[len(prefix) :]: name for key, name in self.fields.items() if key.startswith(prefix)}
