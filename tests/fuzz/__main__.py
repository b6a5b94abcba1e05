"""Coverage-guided fuzzing of everything that reads what others wrote: `make fuzz SECONDS=60`.

Bytes go in, a value or one of our own errors comes out, within a second. A crash leaves its input in a
file, and with its name as the argument it is tried again. Atheris is not part of the tests' setup:
it has no wheels for some systems.
"""

import gzip
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import atheris  # type: ignore[import-not-found, import-untyped, unused-ignore]  # installed by `make fuzz` alone

with atheris.instrument_imports(include=["fleet_tui", "yaml", "tomllib", "PIL"]):
    from fleet_tui.config.load import load
    from fleet_tui.maps.images import load_floor_map
    from fleet_tui.maps.route_graphs import load_floor_graph
    from fleet_tui.model.commands import PauseRobot
    from fleet_tui.records.recording.indexing import open_recording
    from fleet_tui.records.recording.records import Keyframe, RecordingError
    from fleet_tui.robots.ros.operations import Publish, ServiceResponse, decode, decode_cbor
    from fleet_tui.text.errors import ConfigError, WireError
    from fleet_tui.text.sanitize import cell_width, fit, sanitize
    from fleet_tui.ui.themes import load_themes, read_theme
    from tests.support.adapters import adapter_of
    from tests.support.recordings import header, keyframe, packed

SLOWEST = 1.0
"""Seconds of the processor: a busy machine is no failure. What waits for ever, libFuzzer ends."""
ADAPTER = adapter_of()
FEEDS = list(ADAPTER.feeds("robot_0", ["floor_0"]))
FOLDER = Path(tempfile.mkdtemp())
THEMES = load_themes()[0]
HEAD = gzip.decompress(packed(header(), keyframe()))


def _frame(payload: bytes, binary: bool) -> None:
    try:
        operation = decode_cbor(payload) if binary else decode(payload)
    except WireError:
        return
    if isinstance(operation, ServiceResponse):
        ADAPTER.outcome(PauseRobot("robot_0"), operation.values, operation.result)
    if isinstance(operation, Publish):
        for feed in FEEDS:
            try:
                ADAPTER.read(feed, operation.msg, 0.0)
            except WireError as problem:
                assert str(problem)


def _file(name: str, payload: bytes) -> Path:
    path = FOLDER / name
    path.write_bytes(payload)
    return path


def _config(payload: bytes) -> None:
    try:
        load(_file("config.toml", payload))
    except ConfigError as refused:
        assert all(refused.problems)


def _theme(payload: bytes) -> None:
    try:
        read_theme(_file("theme.toml", payload), THEMES)
    except ConfigError as refused:
        assert all(refused.problems)


def _map(name: str, payload: bytes) -> None:
    loaded = load_floor_map("floor_0", _file(name, payload), False)
    assert (loaded.grid is None) is bool(loaded.problem)


def _graph(payload: bytes) -> None:
    loaded = load_floor_graph("floor_0", _file("graph.geojson", payload))
    assert loaded.graph is not None or loaded.problem


def _recording(payload: bytes) -> None:
    try:
        recording = open_recording(_file("recording", payload))
        for record in recording.records():
            if isinstance(record, Keyframe):
                recording.state(record)
    except RecordingError as refused:
        assert str(refused)


def _text(payload: bytes) -> None:
    text = payload.decode("utf-8", "surrogateescape")
    shown = sanitize(text)
    assert not any(ord(letter) < 0x20 or 0x7F <= ord(letter) < 0xA0 for letter in shown)
    assert cell_width(fit(text, 20)) == 20


TARGETS: list[Callable[[bytes], None]] = [
    lambda payload: _frame(payload, False),
    lambda payload: _frame(payload, True),
    _config,
    _theme,
    lambda payload: _map("map.yaml", payload),
    lambda payload: _map("map.png", payload),
    lambda payload: _map("map.pgm", payload),
    _text,
    _recording,
    lambda payload: _recording(gzip.compress(HEAD + payload, 1)),
    _graph,
]
SEEDS = [
    b'\0{"op":"publish","topic":"/a","msg":{"data":[0],"vertices":[{"id":1,"x":1,"y":1}],"edges":[]}}',
    b'\0{"op":"service_response","id":"1","values":{"status":"ok"},"result":true}',
    bytes.fromhex("01a3626f70677075626c69736865746f706963622f61636d7367a1646461746101"),
    b'\x02[rosbridge]\nurl = "ws://a:1"\n[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n',
    b'\x03dark = true\n[base]\naccent = "#000000"\n[inks]\nwall = {color = "#ffffff", bold = true}\n',
    b"\x04image: map.png\nresolution: 0.05\norigin: [0, 0, 0]\nmode: scale\n",
    b"\x06P5\n2 2\n255\n\0\0\0\0",
    "\x07a\u0301仓\u202e".encode(),
    b"\x08" + packed(header(), keyframe()),
    b'\x09{"kind":"told","at":1000,"wall":1700000000,"event":{"type":"LinkHeard","link":"rosbridge","at":1}}\n',
    b'\x0a{"type":"FeatureCollection","features":[{"properties":{"id":0},"geometry":'
    b'{"type":"Point","coordinates":[1.0,2.0]}}]}',
]


def one_input(payload: bytes) -> None:
    """The first byte chooses who reads the rest."""
    began = time.process_time()
    TARGETS[payload[0] % len(TARGETS) if payload else 0](payload[1:])
    assert time.process_time() - began < SLOWEST


if __name__ == "__main__":
    corpus = Path(tempfile.mkdtemp())
    for n, seed in enumerate(SEEDS):
        (corpus / str(n)).write_bytes(seed)
    is_replay = any(not argument.startswith("-") for argument in sys.argv[1:])
    atheris.Setup(sys.argv if is_replay else [*sys.argv, str(corpus)], one_input)
    atheris.Fuzz()
