"""Profiles: the differences of one site's robots from the usual ones of their kind, as in the config."""

from typing import Annotated, Any, Literal

import msgspec

VertexRole = Literal["plain", "elevator", "docking"]


class DriveConfig(msgspec.Struct, frozen=True):
    """`[drive]`, or that of a profile: the highest speeds of a robot that is driven by hand, in metres and
    radians per second. `robot_timeout`: seconds after which it stops by itself without a message, None:
    unknown. `holonomic`: it can move sideways."""

    max_linear: Annotated[float, msgspec.Meta(gt=0, le=2)] = 0.3
    max_angular: Annotated[float, msgspec.Meta(gt=0, le=4)] = 0.6
    robot_timeout: Annotated[float, msgspec.Meta(gt=0, le=10)] | None = None
    holonomic: bool = False


class Profile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`[profile]` or `[profiles.NAME]`: overrides only. None means as usual for the kind.

    `name` and `kind` mean the same. `fields` maps our name of a field to its path in the site's message,
    `scales` to its factor; `silence`: seconds after which a missing value is old. `origin = "added"` if the
    stack adds the map's origin. `settings`: tables of single kinds, by kind. `requests`: the fields of
    services, with {robot} in texts, for maps saved by the robot also {name} and {floor}, for graphs that it
    loads {path} and {floor}; `answers`: by
    service the fields of an answer that mean success; `modes`: the meanings of a robot's words for its mode;
    `pose_frame`: the frame of poses that are set, with {robot} and {floor}, empty for the usual one;
    `base_frame`: the frame of the robot itself, with {robot}, empty for `base_link` or `base_footprint`;
    `drive` replaces `[drive]` as a whole: a timeout of other robots must not count for these.
    """

    name: str = ""
    kind: str = ""
    topics: dict[str, str] = {}
    types: dict[str, str] = {}
    services: dict[str, str] = {}
    service_types: dict[str, str] = {}
    actions: dict[str, str] = {}
    action_types: dict[str, str] = {}
    fields: dict[str, str] = {}
    scales: dict[str, float] = {}
    silence: dict[str, float] = {}
    refusals: tuple[str, ...] | None = None
    vertex_types: dict[str, VertexRole] | None = None
    directed: bool = False
    origin: Literal["ros", "added"] = "ros"
    settings: dict[str, dict[str, Any]] = {}
    requests: dict[str, dict[str, Any]] = {}
    answers: dict[str, dict[str, bool | int | str]] = {}
    modes: dict[str, Literal["mapping", "navigation"]] = {}
    pose_frame: str = ""
    base_frame: str = ""
    drive: DriveConfig | None = None
