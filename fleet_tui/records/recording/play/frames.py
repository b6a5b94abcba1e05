"""Events of a record: frames are decoded again like on the link."""

from collections.abc import Mapping
from functools import reduce

from fleet_tui.config.fleet import adapters_of, feeds_of, limit_of
from fleet_tui.config.schema import Config
from fleet_tui.maps.levels import read_levels
from fleet_tui.maps.map_process import decode_apart
from fleet_tui.maps.png_text import text_of_png
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.recording.records import EventRecord, ReceivedFrame, Record
from fleet_tui.robots.ros.operations import Fragment, ServiceResponse
from fleet_tui.robots.ros.reading import FrameReader, StreamTaken
from fleet_tui.robots.vda5050.broker_reader import MessageReader
from fleet_tui.state.reducer import apply


def _reader(config: Config, link: str) -> FrameReader | MessageReader:
    adapters = adapters_of(config)
    limit, feeds = limit_of(config, link), feeds_of(config, adapters, link)
    if config.bridges[link].is_broker:
        return MessageReader(link, limit, adapters, feeds)
    return FrameReader(
        link, limit, adapters, feeds, decode_apart, decode_pictures=read_levels, decode_png=text_of_png
    )


class Frames:
    """Decodes the frames of every bridge of a recording."""

    def __init__(self, config: Config) -> None:
        self._readings = {name: _reader(config, name) for name in config.bridges}

    @property
    def counters(self) -> Mapping[str, LinkCounter]:
        """Return the counters of each bridge since the last jump."""
        return {name: reading.counter for name, reading in self._readings.items()}

    def recount(self) -> None:
        """Reset the counters after a jump: earlier ones may lie in the future."""
        for reading in self._readings.values():
            reading.recount()

    def after(self, state: FleetState, record: Record) -> FleetState:
        """Return the state after a record. Answers are skipped: their events were recorded."""
        match record:
            case EventRecord(event=event):
                return apply(state, event)
            case ReceivedFrame(channel="topics", link=link) if link in self._readings:
                at = record.at if record.came is None else record.came
                read = self._readings[link].read(record.payload, record.binary, at)
                if not isinstance(read, ServiceResponse | Fragment | StreamTaken):
                    return reduce(apply, read, state)
        return state
