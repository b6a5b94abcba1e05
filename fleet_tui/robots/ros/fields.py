"""Fields of messages: our names with their usual paths, and messages whose fields differ at a site."""

from collections.abc import Mapping
from typing import Any

from fleet_tui.text.errors import WireError


def alike(*names: str) -> Mapping[str, str]:
    """Return fields whose name on the wire is ours."""
    return {name: name for name in names}


def placed(path: str) -> Mapping[str, str]:
    """Return the fields of a geometry_msgs/Pose at a path, which ends with a dot."""
    parts = {"position": "xyz", "orientation": "xyzw"}
    names = [*parts, *(f"{part}.{axis}" for part, axes in parts.items() for axis in axes)]
    return {name: f"{path}{name}" for name in names}


HEADER = {"header": "header", "frame_id": "header.frame_id", "stamp": "header.stamp"}
POSE: Mapping[str, str] = {**HEADER, **placed("pose.")}
"""geometry_msgs/PoseStamped."""
METADATA: Mapping[str, str] = alike("resolution", "width", "height", "origin")
"""nav_msgs/MapMetaData."""
GRID: Mapping[str, str] = {"info": "info", **{name: f"info.{name}" for name in METADATA}, "data": "data"}
"""nav_msgs/OccupancyGrid."""


def rearranged(message: Any, paths: Mapping[str, tuple[str, str]]) -> dict[str, Any]:
    """Copy a message, moving each field from its path at this site to its usual one.

    `paths`: by our name of a field both paths, the usual one first. Raises WireError for a missing field.
    """
    found = {name: _value(message, there) for name, (_, there) in paths.items()}
    copy: dict[str, Any] = dict(message)
    # Deeper paths are last: they may be part of an earlier value.
    for name, (usual, _) in sorted(paths.items(), key=lambda item: item[1][0].count(".")):
        put(copy, usual, found[name])
    return copy


def put(message: dict[str, Any], path: str, value: object) -> None:
    """Put a value at a path of a message. Parents are copied: they may be shared."""
    *way, last = path.split(".")
    for step in way:
        inner = message.get(step)
        message[step] = dict(inner) if isinstance(inner, dict) else {}
        message = message[step]
    message[last] = value


def _value(message: Any, path: str) -> Any:
    for step in path.split("."):
        if not isinstance(message, dict) or step not in message:
            raise WireError(
                f"Object missing required field `{step}` - at `$.{path}`: correct the fields of its profile"
            )
        message = message[step]
    return message
