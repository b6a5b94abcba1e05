"""P30: transforms of a robot whose localisation has no topic, from the frame to its pose, in per cent of a
core: two publishers, 20 and 50 Hz, each message with the joints of an arm.

Run: python -m tests.bench.bench_transforms
"""

import json
import math
import time

import cbor2

from fleet_tui.robots.adapter import Limit, Site
from fleet_tui.robots.nav2.adapter import Nav2
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.state.store import Store
from tests.bench.rows import Row, row
from tests.support.fleets import R0, fleet

SECONDS, LOCALISED_HZ, COUNTED_HZ = 60, 20, 50
JOINTS = 8
AT_MOST = 5.0
"""Per cent of a core."""


def transform(parent: str, child: str, at: float, x: float) -> dict[str, object]:
    turn = {"x": 0.0, "y": 0.0, "z": math.sin(x / 2), "w": math.cos(x / 2)}
    return {
        "header": {"stamp": {"sec": int(at), "nanosec": int(at % 1 * 1e9)}, "frame_id": parent},
        "child_frame_id": child,
        "transform": {"translation": {"x": x, "y": 0.5, "z": 0.0}, "rotation": turn},
    }


def messages() -> list[tuple[float, dict[str, object]]]:
    """The messages of a minute by their time."""
    joints = [transform("base_link", f"joint_{number}", 0.0, number / 10) for number in range(JOINTS)]
    found = [
        (n / LOCALISED_HZ, [transform("map", "odom", n / LOCALISED_HZ, 1.0)])
        for n in range(SECONDS * LOCALISED_HZ)
    ]
    found += [
        (n / COUNTED_HZ, [transform("odom", "base_footprint", n / COUNTED_HZ, n / 500), *joints])
        for n in range(SECONDS * COUNTED_HZ)
    ]
    return [
        (at, {"op": "publish", "topic": "/tf", "msg": {"transforms": transforms}})
        for at, transforms in sorted(found, key=lambda one: one[0])
    ]


def per_cent(frames: list[tuple[float, bytes]], is_binary: bool) -> float:
    """The share of a core that the transforms of one robot take."""
    store, adapter = Store(fleet()), Nav2(Profile(kind="nav2"), Site())
    feeds = list(adapter.feeds(R0, ["floor_0"]))
    reading = FrameReader("rosbridge", Limit(64.0, ""), {R0: adapter}, feeds, None)  # type: ignore[arg-type]  # no map
    start = time.process_time()
    for at, frame in frames:
        read = reading.read(frame, is_binary, at)
        for event in read if isinstance(read, tuple) else ():
            store.apply(event)
    assert store.state.robots[R0].pose is not None
    return (time.process_time() - start) / SECONDS * 100


def main() -> list[Row]:
    made = messages()
    as_cbor = [(at, cbor2.dumps(message)) for at, message in made]
    as_json = [(at, json.dumps(message).encode()) for at, message in made]
    what = f"transforms of a robot at {LOCALISED_HZ} and {COUNTED_HZ} Hz"
    cbor, text = per_cent(as_cbor, True), per_cent(as_json, False)
    sizes = [sum(len(frame) for _, frame in frames) / SECONDS / 1000 for frames in (as_cbor, as_json)]
    return [
        row("P30", what, cbor, "% of a core", AT_MOST, text, "as JSON"),
        row("P30", f"{what} on the wire", sizes[0], "kB/s", None, sizes[1], "as JSON"),
    ]


if __name__ == "__main__":
    main()
