"""A ROS bag as a recording: the frames that a bridge would have sent, and their events."""

import base64
import keyword
import secrets
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import cbor2
import msgspec
from msgspec.structs import replace

from fleet_tui import __version__
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.features.recording.bags.definitions import BUILT_IN, TIMES, typestore
from fleet_tui.features.recording.bags.opening import Bag, BagError, open_bag
from fleet_tui.features.recording.bags.topics import Chosen, choose
from fleet_tui.features.recording.bags.track import FIRST_AT, Track
from fleet_tui.maps.floor_files import load_floors
from fleet_tui.model.events import MessageRejected
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import OF_BAG, Phase
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording.part_file import PartFile
from fleet_tui.records.recording.recording import LAST_SECOND
from fleet_tui.records.recording.records import VERSION, Packer, RecordingHeader, encode, public
from fleet_tui.robots.ros.cbor import INT8_ARRAY
from fleet_tui.text.language import Message, verbatim
from fleet_tui.text.limits import truncate

Spell = Callable[[Any], Any]

_encode = msgspec.json.Encoder().encode
_KEPT_EMPTY = "structure_needs_at_least_one_member"


class Framer:
    """Writes the messages of one connection. Maps as CBOR, others as JSON: NaN and infinities become null
    there, bytes base64."""

    def __init__(self, store: Any, kind: str, topic: str, is_ros1: bool, as_cbor: bool) -> None:
        self.topic = topic
        self.is_binary = as_cbor
        self._kind = kind
        self._deserialize = store.deserialize_ros1 if is_ros1 else store.deserialize_cdr
        self._spell = _message(store, kind, is_ros1, as_cbor)

    def frame(self, raw: bytes) -> bytes:
        """Return the frame of a message. Unreadable ones raise all kinds of errors."""
        msg = self._spell(self._deserialize(raw, self._kind))
        frame = {"op": "publish", "topic": self.topic, "msg": msg}
        return cbor2.dumps(frame) if self.is_binary else _encode(frame)


def _message(store: Any, kind: str, is_ros1: bool, as_cbor: bool) -> Spell:
    if kind in TIMES and is_ros1:
        # A time of ROS 1 is unsigned, rosbags reads it as signed: it would end in 2038.
        mask = 2**32 - 1 if kind == BUILT_IN["time"] else -1
        return lambda time: {"secs": time.sec & mask, "nsecs": time.nanosec}
    fields = [
        # rosbags renames Python keywords, the wire does not.
        (name, name + "_" * keyword.iskeyword(name), _field(store, desc, is_ros1, as_cbor))
        for name, desc in store.fielddefs[kind][1]
        if name != _KEPT_EMPTY
    ]

    def spell(message: Any) -> dict[str, Any]:
        return {name: write(getattr(message, attribute)) for name, attribute, write in fields}

    return spell


def _same(value: Any) -> Any:
    return value


def _field(store: Any, desc: Any, is_ros1: bool, as_cbor: bool) -> Spell:
    from rosbags.interfaces import Nodetype

    kind, what = desc
    if kind == Nodetype.BASE:
        return _same
    if kind == Nodetype.NAME:
        return _message(store, what, is_ros1, as_cbor)
    (inner_kind, inner), _ = what
    if inner_kind == Nodetype.NAME:
        write = _message(store, inner, is_ros1, as_cbor)
        return lambda values: [write(value) for value in values]
    return _array(inner[0], as_cbor)


def _array(of: str, as_cbor: bool) -> Spell:
    """Return a list of text or numbers; the latter are numpy's."""
    if of == "string":
        return list
    if of in ("uint8", "char"):
        return _bytes if as_cbor else lambda array: base64.b64encode(_bytes(array)).decode()
    if of == "int8" and as_cbor:
        return lambda array: cbor2.CBORTag(INT8_ARRAY, _bytes(array))
    return lambda array: array.tolist()


def _bytes(array: Any) -> bytes:
    content: bytes = array.tobytes()
    return content


LARGEST = 128 * 2**20
"""Maximum bytes of a message, in the bag or as a frame."""
TELL_EVERY = 200
"""Messages between two calls of the progress."""

Progress = Callable[[float], None]


@dataclass
class Report:
    """The outcome of a conversion: number of messages in the recording, of topics, and of messages that were
    unreadable, out of order, or with an impossible time; `notes` are for a person."""

    messages: int = 0
    topics: int = 0
    unreadable: int = 0
    late: int = 0
    impossible: int = 0
    seconds: float = 0.0
    notes: list[str] = field(default_factory=list)


def convert(path: Path, config: Config, out: Path, progress: Progress = lambda _share: None) -> Report:
    """Make a recording, which must not exist yet, of the configured messages of a bag. `progress` is called
    with the share done. Raises BagError, and then leaves no file."""
    with open_bag(path) as bag:
        chosen = choose(bag, config)
        try:
            file = PartFile(out, b"")
        except FileExistsError:
            raise BagError(Message("{out}: exists: choose another name, or remove it", out=out)) from None
        except OSError as problem:
            raise BagError(
                Message("{out}: not writable: {strerror}", out=out, strerror=problem.strerror)
            ) from None
        try:
            return _Conversion(bag, config, chosen, file).run(progress)
        except BaseException as problem:
            out.unlink(missing_ok=True)
            if isinstance(problem, OSError):
                raise BagError(
                    Message("{out}: not writable: {strerror}", out=out, strerror=problem.strerror)
                ) from None
            raise
        finally:
            file.close()


class _Conversion:
    """Reads a bag from its first message to its last."""

    def __init__(self, bag: Bag, config: Config, chosen: Chosen, file: PartFile) -> None:
        self._bag = bag
        self._config = config
        self._chosen = chosen
        self._file = file
        self._report = Report(notes=list(chosen.notes))
        self._framers: dict[int, Framer | None] = {}
        self._track: Track | None = None
        self._first = 0

    def run(self, progress: Progress) -> Report:
        connections = self._chosen.connections
        total = max(1, sum(connection.msgcount for connection in connections))
        done = 0
        try:
            for connection, stamp, raw in self._bag.messages(connections):
                self._take(connection, stamp, raw)
                done += 1
                if done % TELL_EVERY == 0:
                    progress(min(1.0, done / total))
        except BagError as problem:
            if self._report.messages == 0:
                raise
            self._report.notes.insert(0, f"read only in part: {problem}")
        if self._track is None:
            raise BagError(Message("{path}: no message of the configured topics in it", path=self._bag.path))
        self._file.end()
        progress(1.0)
        return self._finished(self._track)

    def _finished(self, track: Track) -> Report:
        report = self._report
        report.seconds = track.at - FIRST_AT
        report.topics = len({framer.topic for framer in self._framers.values() if framer})
        if report.unreadable:
            report.notes.append(f"{report.unreadable:,} messages unreadable: see the robots' rows")
        if report.late:
            report.notes.append(f"{report.late:,} messages out of time order")
        if report.impossible:
            report.notes.append(f"{report.impossible:,} messages with an impossible time left out")
        what = "a bag has no console commands and no link states"
        report.notes.insert(0, f"from ROS bag {self._bag.path.name}: {what}")
        return report

    def _take(self, connection: Any, stamp: int, raw: bytes) -> None:
        # A database may hold anything in place of a number.
        if not (isinstance(stamp, int) and 0 <= stamp < LAST_SECOND * 1e9 and isinstance(raw, bytes)):
            self._report.impossible += 1
            return
        if self._track is None:
            self._first = stamp
            self._track = self._begin(stamp / 1e9)
        track = self._track
        if not track.advance((stamp - self._first) / 1e9):
            self._report.late += 1
        framer = self._framer(track, connection)
        if framer is None:
            return
        frame, problem = b"", f"{len(raw):,} bytes: the limit for bag messages is {LARGEST:,}"
        if len(raw) <= LARGEST:
            frame, problem = _frame(framer, raw)
        if problem or len(frame) > LARGEST:
            self._report.unreadable += 1
            self._reject(track, connection.topic, f"{connection.topic}: {problem}")
            return
        self._report.messages += 1
        for link, _ in self._chosen.by_topic[connection.topic]:
            track.on_received(link, frame, framer.is_binary)

    def _framer(self, track: Track, connection: Any) -> Framer | None:
        """Return the writer of a connection's messages, None if its type can't be read."""
        key = id(connection)
        if key not in self._framers:
            as_cbor = any(one.large for _, one in self._chosen.by_topic[connection.topic])
            try:
                store = typestore(connection)
                self._framers[key] = Framer(
                    store, connection.msgtype, connection.topic, self._bag.is_ros1, as_cbor
                )
            except Exception as problem:  # noqa: BLE001  # rosbags runs code that it made of the definition
                self._framers[key] = None
                text = truncate(f"{connection.topic}: {problem}")
                self._report.notes.append(text)
                self._reject(track, connection.topic, text)
        return self._framers[key]

    def _reject(self, track: Track, topic: str, text: str) -> None:
        for _, one in self._chosen.by_topic[topic]:
            track.on_event(MessageRejected(one.robot, verbatim(truncate(text))))

    def _begin(self, wall: float) -> Track:
        name, config = self._bag.path.name, public(self._config)
        header = RecordingHeader(VERSION, __version__, secrets.token_hex(8), 0, FIRST_AT, wall, False, config)
        self._file.write(encode(header, Packer()))
        origin = Origin("", OF_BAG + name, "")
        track = Track(self._file, self._config, self._first_state(wall), origin, wall)
        for loaded in load_floors(self._config):
            track.on_event(loaded)
        for robot, problem in self._chosen.refused:
            track.on_event(MessageRejected(robot, verbatim(problem)))
        return track

    def _first_state(self, wall: float) -> FleetState:
        """Return the state before the first message. The links are up, or all would count as lost; the bag is
        named in place of the bridge's address."""
        state = initial_state(self._config, FIRST_AT)
        url = OF_BAG + self._bag.path.name
        links = {name: replace(link, url=url, phase=Phase.UP) for name, link in state.links.items()}
        return replace(state, links=links, wall=wall)


def _frame(framer: Framer, raw: bytes) -> tuple[bytes, str]:
    """Return the frame of a message, or the reason that it has none."""
    try:
        return framer.frame(raw), ""
    except Exception as problem:  # noqa: BLE001  # a hostile message leads rosbags into errors of every kind
        return b"", str(problem) or type(problem).__name__
