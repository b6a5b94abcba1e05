"""ROS messages as typed structs, field names as in `robot-interface`.

If a robot stack names a field differently, the profile has its name and `reader` reads it under that name.
Text frames contain JSON, CBOR ones plain objects.
"""

from collections.abc import Callable, Mapping
from typing import Annotated, Any, TypeVar, cast

import cbor2
import msgspec

from fleet_tui.robots.ros.cbor import INT8_ARRAY
from fleet_tui.robots.ros.fields import rearranged
from fleet_tui.text.errors import WireError

LARGEST = 8 * 2**20
"""Maximum bytes of a message other than a map, as JSON."""

Int32 = Annotated[int, msgspec.Meta(ge=-(2**31), le=2**31 - 1)]
Int64 = Annotated[int, msgspec.Meta(ge=-(2**63), le=2**63 - 1)]


class Stamp(msgspec.Struct, frozen=True):
    """A time: ROS 1 names it secs/nsecs, ROS 2 sec/nanosec."""

    secs: Int64 | None = None
    nsecs: Int64 = 0
    sec: Int64 | None = None
    nanosec: Int64 = 0

    @property
    def seconds(self) -> float | None:
        """Return the seconds since the epoch, None for a stamp that was never set."""
        whole = self.secs if self.secs is not None else self.sec
        found = (whole or 0) + (self.nsecs or self.nanosec) * 1e-9
        return found or None


class TimeAnswer(msgspec.Struct, frozen=True):
    """rosapi_msgs/GetTime: the clock of a site."""

    time: Stamp


class Header(msgspec.Struct, frozen=True):
    """std_msgs/Header."""

    frame_id: str
    stamp: Stamp = Stamp()


class Point(msgspec.Struct, frozen=True):
    """geometry_msgs/Point, metres."""

    x: float
    y: float
    z: float = 0.0


class Quaternion(msgspec.Struct, frozen=True):
    """geometry_msgs/Quaternion."""

    x: float
    y: float
    z: float
    w: float


class RosPose(msgspec.Struct, frozen=True):
    """geometry_msgs/Pose."""

    position: Point
    orientation: Quaternion


class PoseStamped(msgspec.Struct, frozen=True):
    """geometry_msgs/PoseStamped."""

    header: Header
    pose: RosPose


class Bool(msgspec.Struct, frozen=True):
    """std_msgs/Bool."""

    data: bool


class Float32(msgspec.Struct, frozen=True):
    """std_msgs/Float32."""

    data: float


class MapMetadata(msgspec.Struct, frozen=True):
    """nav_msgs/MapMetaData: metres per pixel, pixels, pose of the lower-left pixel."""

    resolution: float
    width: int
    height: int
    origin: RosPose


class OccupancyGridMessage(msgspec.Struct, frozen=True):
    """nav_msgs/OccupancyGrid; `data` holds int8, a list in JSON, bytes from CBOR."""

    info: MapMetadata
    data: bytes | list[Annotated[int, msgspec.Meta(ge=-128, le=127)]]


class GraphVertex(msgspec.Struct, frozen=True):
    """One of a graph's vertices, metres."""

    id: Int32
    x: float
    y: float
    type: str = ""


class GraphEdge(msgspec.Struct, frozen=True):
    """One of a graph's edges, between vertex ids."""

    id: Int32
    start: Int32
    end: Int32


class GraphMessage(msgspec.Struct, frozen=True):
    """OH_ressources/Graph, its parts unread: one bad vertex must not cost the others."""

    vertices: list[Any]
    edges: list[Any]


class LabeledVertex(msgspec.Struct, frozen=True):
    label: str
    vertex_id: Int32


class LabeledVertices(msgspec.Struct, frozen=True):
    """OH_ressources/LabeledVertices, its parts unread."""

    vertices: list[Any]


class QueuedOrder(msgspec.Struct, frozen=True):
    """One order of an ActionQueue."""

    id: Int32
    start: Int32
    end: Int32
    status: str


class ActionQueue(msgspec.Struct, frozen=True):
    """OH_ressources/ActionQueue, its orders unread."""

    last_order_id: Int32
    current_order_id: Int32
    orders: list[Any]
    request_id: Any = None


S = TypeVar("S", bound=msgspec.Struct)

Paths = Mapping[str, tuple[str, str]]


def _from_cbor(value: object) -> object:
    """Convert the typed arrays of cbor2, tagged bytes that msgspec doesn't know."""
    if isinstance(value, cbor2.CBORTag) and value.tag == INT8_ARRAY and isinstance(value.value, bytes):
        return value.value
    return value


def _renamed(struct: type[S], paths: Paths) -> type[S]:
    """Give a struct the site's names of its fields."""
    fields = [
        (field.name, field.type) if field.required else (field.name, field.type, field.default)
        for field in msgspec.structs.fields(struct)
    ]
    names = dict(paths.values())
    return cast("type[S]", msgspec.defstruct(struct.__name__, fields, frozen=True, rename=names))


def _check_size(msg: msgspec.Raw) -> None:
    size = memoryview(msg).nbytes
    if size > LARGEST:
        raise WireError(f"{size:,} bytes: the limit is {LARGEST:,}")


NOT_A_NUMBER = ("Expected `float`, got `null`", "NaN (null in JSON) is not a number")


def reader(struct: type[S], paths: Paths | None = None) -> Callable[[object], S]:
    """Return a function that reads a message's encoded JSON, or a plain object, into `struct`.

    `paths`: by our name of a field its usual path in the message and the one at this site. The function
    raises WireError with the field's name.
    """
    bounded = not issubclass(struct, OccupancyGridMessage)
    moved = paths if paths and any("." in path for pair in paths.values() for path in pair) else None
    if paths and not moved:
        struct = _renamed(struct, paths)
    decoder = msgspec.json.Decoder(struct)

    def read(msg: object) -> S:
        try:
            if isinstance(msg, msgspec.Raw):
                if bounded:
                    _check_size(msg)
                if not moved:
                    return decoder.decode(msg)
                msg = msgspec.json.decode(msg)
            if moved:
                msg = rearranged(msg, moved)
            if isinstance(msg, dict) and "data" in msg:
                msg = {**msg, "data": _from_cbor(msg["data"])}
            return msgspec.convert(msg, struct)
        except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as problem:
            # NaN and the infinities are no JSON: a bridge writes null.
            raise WireError(str(problem).replace(*NOT_A_NUMBER)) from None

    return read
