"""Records: one JSON object per line, as docs/recordings.md describes them.

`at` is the monotonic second at which a record took effect, and never runs backwards within a recording;
`wall` is Unix time. If they diverge, a clock was set.
"""

import math
import zlib
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import numpy as np
from msgspec import Struct

from fleet_tui.config.schema import Config, Link
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.grid import OccupancyGrid, check_frame
from fleet_tui.model.occupancy import OCCUPIED, build_grid
from fleet_tui.records.recording.upgrade import upgrade_record, upgrade_state
from fleet_tui.text.errors import FleetError, MapError
from fleet_tui.text.language import Message, as_written

VERSION = 2
"""Version of the records below. It grows when an older program could not read them any more. Those of version
1 are read, too, by `upgrade`."""

T = TypeVar("T")


class RecordingError(FleetError):
    """A recording that can't be read, or written, and the remedy."""


class RecordingHeader(Struct, frozen=True, tag="header", tag_field="kind"):
    """The first line of a file. `recording` is the same in all parts of one recording, `part` counts
    them from 0; `config` is without secrets."""

    version: int
    program: str
    recording: str
    part: int
    at: float
    wall: float
    demo: bool
    config: Config


class Keyframe(Struct, frozen=True, tag="keyframe", tag_field="kind"):
    """Everything known at an instant, before the next records: MessagePack, since JSON has no infinity."""

    at: float
    wall: float
    state: bytes

    @classmethod
    def of(cls, at: float, wall: float, state: FleetState, hook: "Packer") -> "Keyframe":
        return cls(at, wall, msgspec.msgpack.encode(state, enc_hook=hook))

    def fleet_state(self, version: int = VERSION) -> FleetState:
        """Decode the state; `Recording.state` also checks whether it fits the config. `version` is that of
        its recording. Raises RecordingError."""
        return _decoded(_STATES, self.state if version >= VERSION else _upgraded_state(self.state))


class LinkFrame(Struct, frozen=True, omit_defaults=True):
    """A frame: `text`, or `data` if it is binary. `channel` is topics or commands."""

    at: float
    wall: float
    link: str
    channel: str
    text: str = ""
    data: bytes = b""


class ReceivedFrame(LinkFrame, frozen=True, omit_defaults=True, tag="heard", tag_field="kind"):
    """A received frame. `came` is its arrival, if that was before `at`: a large frame is decoded off the
    loop."""

    binary: bool = False
    came: float | None = None

    @property
    def payload(self) -> bytes:
        return self.data or self.text.encode()


class SentFrame(LinkFrame, frozen=True, omit_defaults=True, tag="sent", tag_field="kind"):
    """A sent frame. Those with a secret are not recorded."""


class EventRecord(Struct, frozen=True, tag="told", tag_field="kind"):
    """An event without a frame."""

    at: float
    wall: float
    event: Event


class Mark(Struct, frozen=True, tag="mark", tag_field="kind"):
    """A line of the audit log: the effect of the record before it on a command or an alarm."""

    at: float
    wall: float
    record: AuditRecord


class Lost(Struct, frozen=True, tag="lost", tag_field="kind"):
    """The number of records missing here. A keyframe follows as soon as there is space again."""

    at: float
    wall: float
    records: int
    why: str


Record = RecordingHeader | Keyframe | ReceivedFrame | SentFrame | EventRecord | Mark | Lost


class _Cells(Struct, frozen=True):
    """A grid: its finest level, compressed. The others are derived from it."""

    frame: MapFrame
    cells: bytes


class Packer:
    """Converts values into JSON types. A grid that was packed before is not compressed again."""

    def __init__(self) -> None:
        self._packed: dict[int, tuple[OccupancyGrid, _Cells]] = {}
        self._used: set[int] = set()

    def __call__(self, value: Any) -> Any:
        """Return a value in a form that msgspec knows."""
        if isinstance(value, Path | Message):
            return str(value)
        if not isinstance(value, OccupancyGrid):
            raise NotImplementedError(type(value))
        self._used.add(id(value))
        if id(value) not in self._packed:
            packed = zlib.compress(value.levels[0].tobytes(), 1)
            self._packed[id(value)] = value, _Cells(value.frame, packed)
        return self._packed[id(value)][1]

    def forget(self) -> None:
        """Drop the grids not packed since the last call."""
        self._packed = {key: kept for key, kept in self._packed.items() if key in self._used}
        self._used = set()


def _unpacked(kind: type, value: Any) -> Any:
    if issubclass(kind, Path):
        return Path(value)
    if kind is Message:
        return as_written(kind, value)
    packed = msgspec.convert(value, _Cells)
    frame = packed.frame
    check_frame(frame)
    size = frame.width * frame.height
    # A few bytes can expand to more than fits into memory.
    cells = zlib.decompressobj().decompress(packed.cells, size + 1)
    if len(cells) != size:
        raise MapError(
            Message(
                "a map of {width} x {height} px with {cells} cells",
                width=frame.width,
                height=frame.height,
                cells=len(cells),
            )
        )
    levels = np.frombuffer(cells, np.uint8).reshape(frame.height, frame.width)
    return build_grid(frame, np.minimum(levels, OCCUPIED))


_STATES = msgspec.msgpack.Decoder(FleetState, dec_hook=_unpacked)
# Not strict: "-inf" is a number, too.
_RECORDS: msgspec.json.Decoder[Record] = msgspec.json.Decoder(Record, dec_hook=_unpacked, strict=False)


def encode(record: Record, packer: Packer) -> bytes:
    """Return a record as a line. Raises ValueError for unsupported text, such as half a surrogate pair."""
    return encode_all([plain(record, packer)], packer)


def encode_all(records: list[Any], packer: Packer) -> bytes:
    """Return records, each already converted by `plain`, as lines. Raises ValueError."""
    return msgspec.json.Encoder(enc_hook=packer).encode_lines(records)


def plain(record: Record, packer: Packer) -> Any:
    """Return a record in a form in which every number can be written."""
    if isinstance(record, EventRecord):
        return _spelled(msgspec.to_builtins(record, enc_hook=packer, str_keys=True))
    return record


def _spelled(value: Any) -> Any:
    """Replace numbers that JSON does not have by text."""
    if isinstance(value, float):
        return value if math.isfinite(value) else str(value)
    if isinstance(value, dict):
        return {key: _spelled(one) for key, one in value.items()}
    return [_spelled(one) for one in value] if isinstance(value, list | tuple) else value


def decode(line: bytes, version: int = VERSION) -> Record:
    """Return the record of a line; `version` is that of its recording. Raises RecordingError."""
    if version < VERSION and not line.startswith(_FRAMES):
        line = _upgraded(line)
    return _decoded(_RECORDS, line)


# Wire data is the same in every version.
_FRAMES = (b'{"kind":"heard"', b'{"kind":"sent"')
_BROKEN = (KeyError, TypeError, AttributeError, ValueError, RecursionError, msgspec.MsgspecError)


def _upgraded(line: bytes) -> bytes:
    try:
        return msgspec.json.encode(upgrade_record(msgspec.json.decode(line)))
    except _BROKEN as problem:
        raise RecordingError(Message("unreadable record: {problem}", problem=f"{problem!r}")) from None


def _upgraded_state(state: bytes) -> bytes:
    try:
        return msgspec.msgpack.encode(upgrade_state(msgspec.msgpack.decode(state)))
    except _BROKEN as problem:
        raise RecordingError(Message("unreadable record: {problem}", problem=f"{problem!r}")) from None


def _decoded(decoder: "msgspec.json.Decoder[T] | msgspec.msgpack.Decoder[T]", content: bytes) -> T:
    try:
        return decoder.decode(content)
    except (msgspec.MsgspecError, ValueError, RecursionError, MapError, zlib.error, MemoryError) as problem:
        raise RecordingError(Message("unreadable record: {problem}", problem=problem)) from None


def public(config: Config) -> Config:
    """Return a config without secrets, their locations, and settings of this machine or operator only.

    The names of environment variables are removed too: a secret may have been entered there by mistake.
    """
    names = {"rosbridge": config.rosbridge, **config.links}
    links = {
        name: Link(link.shown, link.max_message_mb, profile=link.profile) for name, link in names.items()
    }
    first = links.pop("rosbridge")
    return msgspec.structs.replace(config, rosbridge=first, links=links, keys={}, path=Path())
