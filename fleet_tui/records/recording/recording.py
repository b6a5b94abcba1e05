"""A recording that can be read from any instant: all its parts, as far as they are whole."""

import math
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple, assert_never

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.config.fleet import adapters_of
from fleet_tui.config.schema import Config
from fleet_tui.model import events
from fleet_tui.model.desk.events import OperatorEvent
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import DispatchFailed, MemberFact, RequestAnswered
from fleet_tui.model.navigation_events import GoalAnswered, Navigation, QueueChange
from fleet_tui.model.vehicles.events import VehicleFact
from fleet_tui.records.recording.gzip_members import Lines, open_plain
from fleet_tui.records.recording.records import (
    EventRecord,
    Keyframe,
    Lost,
    Mark,
    ReceivedFrame,
    Record,
    RecordingError,
    RecordingHeader,
    SentFrame,
    decode,
)
from fleet_tui.text.language import EMPTY, Message

_OfRobot = (
    events.Telemetry | Navigation | VehicleFact | MemberFact | events.MapFactReceived | QueueChange
)  # made once, not for every record

LAST_SECOND = 253_402_300_799.0
"""Unix time at the end of the year 9999."""


class Instant(Struct, frozen=True):
    """An instant: monotonic seconds, and its Unix time."""

    at: float
    wall: float


class KeyframeLocation(Struct, frozen=True):
    """The location of a keyframe: its file, the gzip member, and the number of keyframes before it there."""

    path: Path
    member: int
    nth: int


@dataclass
class Recording:
    """Its begin and end, its marks (alarms, commands) and losses, and the instants of its keyframes. `part`
    is the number of the last scanned part; `notes` describe unreadable data."""

    path: Path
    header: RecordingHeader
    end: Instant = Instant(-math.inf, 0.0)  # noqa: RUF009  # a frozen value
    parts: list[Path] = field(default_factory=list)
    part: int = -1
    keyframes: list[Instant] = field(default_factory=list)
    places: list[KeyframeLocation] = field(default_factory=list)
    marks: list[Mark] = field(default_factory=list)
    lost: list[Lost] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    @property
    def config(self) -> Config:
        """Return the configuration at the time of recording, without secrets."""
        return self.header.config

    @property
    def begin(self) -> Instant:
        """Return its first keyframe."""
        return self.keyframes[0]

    @property
    def note(self) -> Message:
        """Return a note on unreadable data, empty if all could be read."""
        if not self.notes:
            return EMPTY
        more = Message(" and {count} more", count=len(self.notes) - 1) if self.notes[1:] else ""
        return Message("{note}{more}", note=self.notes[0], more=more)

    def records(self, from_at: float = -math.inf) -> Iterator[Record]:
        """Return everything from the last keyframe at or before a monotonic second, which is first.
        Unreadable data of a part is skipped: the next one begins with a keyframe."""
        chosen = max(0, bisect_right(self.keyframes, from_at, key=lambda moment: moment.at) - 1)
        place = self.places[chosen]
        last = self.keyframes[chosen].at
        for path in self.parts[self.parts.index(place.path) :]:
            to_skip = place.nth if path == place.path else 0
            for record in self._of_part(path, place.member if path == place.path else 0):
                to_skip -= isinstance(record, Keyframe)
                if isinstance(record, RecordingHeader) or to_skip >= 0:
                    continue
                if not (last <= record.at <= self.end.at and 0 <= record.wall < LAST_SECOND):
                    break
                last = record.at
                yield record

    def _of_part(self, path: Path, member: int) -> Iterator[Record]:
        try:
            with open_plain(path) as file:
                file.seek(member)
                known = _Names.of(self.config)
                for _, line in Lines(file):
                    record = decode(line, self.header.version)
                    known.check(record)
                    yield record
        except RecordingError as problem:
            note = f"{path.name}: {str(problem).removeprefix(f'{path}: ')}"
            if note not in self.notes:
                self.notes.append(note)

    def state(self, keyframe: Keyframe) -> FleetState:
        """Return a keyframe's state. Raises RecordingError, also if it does not fit the config."""
        state, config = keyframe.fleet_state(self.header.version), self.config
        fits = (
            list(state.robots) == [robot.name for robot in config.robots]
            and [(robot.name, robot.link) for robot in state.robots.values()]
            == [(robot.name, robot.link) for robot in config.robots]
            and [floor.name for floor in state.floors.values()] == [floor.name for floor in config.floors]
            and list(state.floors) == [floor.name for floor in config.floors]
            and [link.name for link in state.links.values()] == list(config.bridges) == list(state.links)
            and all(one.steps and one.command.robot in state.robots for one in state.commands)
            and all(robot.floor in {None, *state.floors} for robot in state.robots.values())
        )
        if not fits:
            raise RecordingError(
                Message(
                    "{path}: a keyframe does not match its configuration: make a new recording",
                    path=self.path,
                )
            )
        # Recordings of version 1 know no kinds.
        adapters = adapters_of(config)
        robots = {
            name: one if one.kind.name else replace(one, kind=adapters[name].kind)
            for name, one in state.robots.items()
        }
        return replace(state, robots=robots)


class _Names(NamedTuple):
    """The names in a config."""

    links: frozenset[str]
    floors: frozenset[str]
    robots: frozenset[str]

    @classmethod
    def of(cls, config: Config) -> "_Names":
        return cls(
            frozenset(config.bridges),
            frozenset(floor.name for floor in config.floors),
            frozenset(robot.name for robot in config.robots),
        )

    def check(self, record: Record) -> None:
        """Raise RecordingError for an unknown link, floor or robot."""
        match record:
            case ReceivedFrame(link=link) | SentFrame(link=link):
                known = link in self.links
            case EventRecord(event=event):
                known = self._has(event)
            case _:
                known = True
        if not known:
            raise RecordingError(Message("record of something not in its configuration"))

    def _has(self, event: events.Event) -> bool:
        """Tell whether all names of an event exist. Reports of other robots are skipped."""
        if isinstance(event, _OfRobot | OperatorEvent):
            return True
        match event:
            case (
                events.LinkChanged(link=link)
                | events.MessageArrived(link=link)
                | events.CommandPathChanged(link=link)
                | events.MessagesUnsourced(link=link)
                | events.TopicsDropped(link=link)
                | events.TopicNotAllowed(link=link)
                | events.CallNotAllowed(link=link)
                | events.SubscriptionsAdvanced(link=link)
                | events.BridgeAnswered(link=link)
                | events.FrameRejected(link=link)
            ):
                return link in self.links
            case events.FloorMapLoaded(floor=floor) | events.FloorGraphLoaded(floor=floor):
                return floor in self.floors
            case events.CommandIssued(command=command):
                return command.robot in self.robots
            case events.MessageRejected() | events.CommandAdvanced() | GoalAnswered() | events.TimePassed():
                return True
            case RequestAnswered() | DispatchFailed():
                return True
            case _:
                assert_never(event)
