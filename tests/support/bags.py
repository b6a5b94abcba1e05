"""ROS bags for tests, written by rosbags' own writers."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import msgspec
import numpy as np
from rosbags.interfaces import Nodetype
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from fleet_tui.config.schema import Config
from fleet_tui.robots.profile import Profile
from tests.support.watched_store import config_of

WALL = 1_700_000_000
KINDS = ["ros1", "ros1-bz2", "ros1-lz4", "sqlite3", "sqlite3-message", "sqlite3-file", "mcap", "mcap-storage"]
STACK = {
    "Order": "int32 id\nint32 start\nint32 end\nstring status",
    "ActionQueue": "int32 last_order_id\nint32 current_order_id\nOrder[] orders",
    "Vertex": "int32 id\nfloat64 x\nfloat64 y\nstring type",
    "Edge": "int32 id\nint32 start\nint32 end",
    "Graph": "Vertex[] vertices\nEdge[] edges",
    "LabeledVertex": "string label\nint32 vertex_id",
    "LabeledVertices": "LabeledVertex[] vertices",
}


class Said(NamedTuple):
    """A message: when (seconds from the beginning), where, of which type, and what."""

    at: float
    topic: str
    kind: str
    msg: dict[str, Any]


def types(package: str) -> Any:
    """A store with the messages of the robots under that package's name."""
    store = get_typestore(Stores.ROS1_NOETIC if package == "OH_ressources" else Stores.ROS2_HUMBLE)
    found = {}
    for name, text in STACK.items():
        found.update(get_types_from_msg(text, f"{package}/msg/{name}"))
    store.register(found)
    return store


def package_of(form: str) -> str:
    """ROS 2 knows no capitals."""
    return "OH_ressources" if form.startswith("ros1") else "oh_ressources"


def bag_config(form: str, robots: int = 1, floors: int = 1) -> Config:
    """A config for a bag of that form."""
    config = config_of("ws://site:9090", robots, floors)
    own = {"queue": "ActionQueue", "graph": "Graph", "labels": "LabeledVertices"}
    kinds = {key: f"{package_of(form)}/{name}" for key, name in own.items()}
    return msgspec.structs.replace(config, profile=Profile(types=kinds))


def made(store: Any, kind: str, msg: Any) -> Any:
    """A message of plain values as rosbags wants it; what is missing is 0, or empty."""
    values = {
        name: value(store, desc, msg.get(name))
        for name, desc in store.fielddefs[kind][1]
        if name != "structure_needs_at_least_one_member"
    }
    return store.types[kind](*values.values())


def value(store: Any, desc: Any, given: Any) -> Any:
    kind, what = desc
    if kind == Nodetype.BASE:
        empty: Any = "" if what[0] == "string" else 0.0 if what[0].startswith("float") else 0
        return empty if given is None else given
    if kind == Nodetype.NAME:
        return made(store, what, given or {})
    (inner_kind, inner), size = what
    if inner_kind == Nodetype.NAME:
        return [made(store, inner, one) for one in given or [{}] * (size if kind == Nodetype.ARRAY else 0)]
    if given is None:
        given = [("" if inner[0] == "string" else 0)] * (size if kind == Nodetype.ARRAY else 0)
    if inner[0] == "string":
        return given
    return np.array(given, {"bool": "bool_", "char": "uint8", "byte": "uint8"}.get(inner[0], inner[0]))


def written(folder: Path, form: str, said: Iterable[Said], store: Any = None, name: str = "night") -> Path:
    """A bag in one of the KINDS; types of the robots are named without their package."""
    store = store or types(package_of(form))
    path = folder / (f"{name}.bag" if form.startswith("ros1") else name)
    with _writer(path, form) as writer:
        connections: dict[tuple[str, str], Any] = {}
        for at, topic, kind, msg in said:
            whole = f"{package_of(form)}/msg/{kind}" if "/" not in kind else kind
            key = topic, whole
            if key not in connections:
                connections[key] = writer.add_connection(topic, whole, typestore=store)
            message = made(store, whole, msg)
            is_ros1 = form.startswith("ros1")
            raw = (store.serialize_ros1 if is_ros1 else store.serialize_cdr)(message, whole)
            writer.write(connections[key], WALL * 10**9 + round(at * 1e9), bytes(raw))
    return path


def _writer(path: Path, form: str) -> Any:
    storage, _, packed = form.partition("-")
    if storage == "ros1":
        writer: Any = Writer1(path)
        if packed:
            writer.set_compression(getattr(Writer1.CompressionFormat, packed.upper()))
        return writer
    writer = Writer2(path, version=9, storage_plugin=StoragePlugin[storage.upper()])
    if packed:
        writer.set_compression(CompressionMode[packed.upper()], CompressionFormat.ZSTD)
    return writer
