"""Bags converted and played."""

import math
from functools import reduce
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.features.recording.bags.convert import Report, convert
from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.frames import Frames
from fleet_tui.records.recording.recording import Recording
from fleet_tui.records.recording.records import EventRecord, Keyframe
from tests.support.bags import WALL, Said
from tests.support.fleets import F0, R0

POSE = "geometry_msgs/msg/PoseStamped"


FLOAT = "std_msgs/msg/Float32"


MAP = "nav_msgs/msg/OccupancyGrid"


def nanoseconds(at: float) -> int:
    return round((at - int(at)) * 1e9)


def pose(at: float, x: float = 0.0, robot: str = R0) -> Said:
    header = {"frame_id": F0, "stamp": {"sec": WALL + int(at), "nanosec": nanoseconds(at)}}
    place = {"position": {"x": x, "y": 2.0}, "orientation": {"w": 1.0}}
    return Said(at, f"/{robot}/pose", POSE, {"header": header, "pose": place})


def battery(at: float, percent: float) -> Said:
    return Said(at, f"/{R0}/battery", FLOAT, {"data": percent})


def night() -> list[Said]:
    """A map, a graph, labels and an order at the beginning, then poses, then a battery that runs low."""
    frame = {"resolution": 0.5, "width": 3, "height": 2, "origin": {"orientation": {"w": 1.0}}}
    vertices = [{"id": 1, "x": 1.0, "y": 2.0}, {"id": 2, "x": 3.0, "y": 4.0, "type": "charger"}]
    order = {"id": 7, "start": 1, "end": 2, "status": "Grüße ☃"}
    return [
        Said(0, f"/{R0}/{F0}/map", MAP, {"info": frame, "data": [0, 100, -1, 0, 50, 0]}),
        Said(0, f"/{R0}/{F0}/map_metadata", "nav_msgs/msg/MapMetaData", frame),
        Said(
            0,
            f"/{R0}/{F0}/graph",
            "Graph",
            {"vertices": vertices, "edges": [{"id": 5, "start": 1, "end": 2}]},
        ),
        Said(
            0,
            f"/{R0}/{F0}/labeled_vertices",
            "LabeledVertices",
            {"vertices": [{"label": "B", "vertex_id": 1}]},
        ),
        Said(
            0.25,
            f"/{R0}/queue",
            "ActionQueue",
            {"last_order_id": 7, "current_order_id": 7, "orders": [order]},
        ),
        Said(0.25, f"/{R0}/cargo", "std_msgs/msg/Bool", {"data": True}),
        *(pose(0.5 + n / 5, n / 10) for n in range(20)),
        *(battery(5 + n, 25.0 - 2.5 * n) for n in range(6)),
    ]


def played(recording: Recording, from_at: float = -math.inf) -> FleetState:
    """The state at the end, from the last keyframe before a second."""
    records = recording.records(from_at)
    first = next(records)
    assert isinstance(first, Keyframe)
    return reduce(Frames(recording.config).after, records, recording.state(first))


def made_of(bag: Path, config: Config, out: Path) -> tuple[Report, Recording]:
    report = convert(bag, config, out)
    recording = open_recording(out)
    assert recording.note == ""
    return report, recording


def ticks(recording: Recording) -> list[float]:
    return [
        record.at
        for record in recording.records()
        if isinstance(record, EventRecord) and isinstance(record.event, events.TimePassed)
    ]
