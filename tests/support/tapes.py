"""Recordings for the tests of the player: of a live run, or made up record by record."""

from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.schema import Alarms, Config
from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import CommandPathChanged, Event, MessageArrived, TimePassed
from fleet_tui.model.link import CommandPath
from fleet_tui.records.audit.entries import Origin, alarm_records, command_records
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.recording import Recording
from fleet_tui.records.recording.records import EventRecord, Keyframe, Lost, Mark, Record
from fleet_tui.state.reducer import apply
from fleet_tui.text.language import Message
from tests.support.fleets import LINK, R0, T0, WALL, battery, commanded, graph, labels, link_up, pose, queue
from tests.support.recordings import PACKER, header, written
from tests.support.watched_store import config_of

ORIGIN = Origin("ana", "here:1", "r")


def recording_of(path: Path, config: Config, records: list[Record]) -> Recording:
    """The records as a file, with a gzip member for each keyframe."""
    members: list[list[Record]] = [[header(config, at=records[0].at)]]
    for record in records:
        if isinstance(record, Keyframe):
            members.append([])
        members[-1].append(record)
    return open_recording(written(path, *members))


class MadeUp:
    """A recording that is told, not lived: the state goes along, marks are made of it."""

    def __init__(self, config: Config, keyframe_every: float = 60.0) -> None:
        self.config = config
        self.state = initial_state(config, T0)
        self.records: list[Record] = []
        self._every, self._due = keyframe_every, T0

    def tell(self, at: float, *facts: Event) -> None:
        """Facts that come at a second after the beginning."""
        at, wall = T0 + at, WALL + at
        if at >= self._due:
            self._due = at + self._every
            self.records.append(Keyframe.of(at, wall, self.state, PACKER))
        for fact in facts:
            before, self.state = self.state, apply(self.state, fact)
            self.records.append(EventRecord(at, wall, fact))
            marks = [
                *command_records(ORIGIN, before, self.state, lambda _: wall),
                *alarm_records(ORIGIN, before, self.state, wall),
            ]
            self.records += [Mark(at, wall, mark) for mark in marks]

    def lose(self, at: float, why: str) -> None:
        """Records that are missing."""
        self.records.append(Lost(T0 + at, WALL + at, 12, why))
        self._due = 0.0

    def written(self, path: Path) -> Recording:
        return recording_of(path, self.config, self.records)


def shift(path: Path, seconds: int = 300) -> Recording:
    """A robot that drives, falls silent from 100 s to 130 s and is paused at 200 s; at 250 s something is
    lost. A tick a second, at x as many metres as seconds."""
    bells = Alarms(bell=["high", "medium", "low"], notify=["high", "medium", "low"])
    made = MadeUp(replace(config_of("ws://site:9090"), alarms=bells))
    made.tell(
        0.0,
        link_up(T0),
        graph(1, 2),
        labels({1: "Base"}),
        CommandPathChanged(LINK, CommandPath.ALIVE, Message(""), True),
    )
    for second in range(seconds):
        at = T0 + second
        if not 100 <= second < 130:
            made.tell(
                second, MessageArrived(LINK, at), pose(at, x=float(second)), battery(at, 90.0), queue(at)
            )
        if second == 200:
            made.tell(
                second, *commanded(7, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, at=at)
            )
        if second == 250:
            made.lose(second, "the disk was full")
        made.tell(second, TimePassed(at, WALL + second))
    return made.written(path)
