"""The connection on which everything arrives: subscribed again each time, decoded, told."""

import asyncio
import logging
import time
from concurrent.futures import ThreadPoolExecutor

from fleet_tui.config.schema import Config
from fleet_tui.errors import LinkError, WireError
from fleet_tui.link.calls import Calls
from fleet_tui.link.map_process import WORTH_A_PROCESS, decode_apart, topic_of
from fleet_tui.link.memory import give_back
from fleet_tui.link.subscriptions import Wanted, type_problem, wanted_topics
from fleet_tui.link.transport import Connection
from fleet_tui.link.writer import Writer
from fleet_tui.model import events
from fleet_tui.model.link import Phase
from fleet_tui.robots.interface import Interface
from fleet_tui.rosbridge import operations

LOG = logging.getLogger(__name__)

ROSAPI_TIMEOUT = 2.0
# Larger frames are decoded beside the loop, so that small ones don't wait.
HEAVY_BYTES = 100_000
# A bridge too old for CBOR says nothing: after this many seconds the map is asked for as JSON.
CBOR_PATIENCE = 20.0
# Seconds until nobody holds the frame of a large map any more, nor the map before it.
TIDY_AFTER = 1.0


class Telemetry:
    """Hears a bridge's topics. Everything runs on the network loop unless it says otherwise."""

    def __init__(self, link: str, url: str, config: Config, interface: Interface, writer: Writer) -> None:
        self._link = link
        self._profile = config.profile
        self._writer = writer
        self._wanted = {
            wanted.subscription.topic: wanted for wanted in wanted_topics(config, interface, link)
        }
        self._types: dict[str, str] = {}
        self._refused: set[str] = set()
        self._logged: set[str] = set()
        self._map: Wanted | None = None
        self._maps_heard: set[str] = set()
        self._heard = 0.0
        self._told_heard = 0.0
        self._spoke = 0.0
        self._subscribing: asyncio.Task[None] | None = None
        self._decoder = ThreadPoolExecutor(1, thread_name_prefix="fleet-tui-decode")
        self.connection = Connection(url, self)
        self._calls = Calls(self.connection)
        writer.before_tick.append(self._tell_heard)

    def _tell(self, event: events.Event) -> None:
        self._writer.store.tell(event)

    def _tell_heard(self, _now: float) -> None:
        if self._heard > self._told_heard:
            self._told_heard = self._heard
            self._tell(events.LinkHeard(self._link, self._heard))

    def silence(self) -> float:
        """Seconds since the last message on this connection, 0 as long as none has come."""
        return time.monotonic() - self._spoke if self._spoke else 0.0

    def on_connecting(self) -> None:
        """A try has begun."""
        self._tell(events.LinkChanged(self._link, time.monotonic(), Phase.CONNECTING))

    def on_open(self) -> None:
        """Subscribe to everything: the bridge remembers nothing of us."""
        self._tell(events.LinkChanged(self._link, time.monotonic(), Phase.UP))
        self._maps_heard.clear()
        self._spoke = 0.0
        self._subscribing = asyncio.ensure_future(self._subscribe_all())

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """Say so, and stop what was under way."""
        if self._subscribing is not None:
            self._subscribing.cancel()
        self._calls.on_lost()
        now = time.monotonic()
        self._tell(events.LinkChanged(self._link, now, Phase.WAITING, reason, now + next_try_in))

    async def _subscribe_all(self) -> None:
        self._types = await self._ask_types()
        self._refused.clear()
        for wanted in self._wanted.values():
            if not wanted.kind.heavy:
                self._subscribe(wanted)
        if self._map is not None:
            self._subscribe(self._map)

    async def _ask_types(self) -> dict[str, str]:
        """Type by topic, as rosapi tells; empty where it doesn't."""
        try:
            response = await self._calls.call("/rosapi/topics", {}, ROSAPI_TIMEOUT)
        except LinkError as problem:
            LOG.info("types are not checked: %s", problem)
            return {}
        values = response.values
        if not response.result or not isinstance(values, dict):
            LOG.info("types are not checked: %s", values)
            return {}
        topics, types = values.get("topics"), values.get("types")
        if not isinstance(topics, list) or not isinstance(types, list):
            return {}
        return {str(topic): str(type_) for topic, type_ in zip(topics, types, strict=False)}

    def _subscribe(self, wanted: Wanted, compression: str = "") -> None:
        problem = type_problem(wanted, self._types, self._profile)
        if problem:
            if wanted.subscription.topic not in self._refused:
                self._refused.add(wanted.subscription.topic)
                self._take(events.MessageRejected(wanted.robot, problem))
            return
        asked = wanted.subscription
        # ROS 2 writes the same type with a middle part: the bridge wants its own spelling back.
        asked = operations.Subscription(
            asked.topic,
            self._types.get(asked.topic, asked.type),
            asked.throttle_rate,
            compression or asked.compression,
        )
        try:
            self.connection.send(operations.subscribe(asked))
        except LinkError:
            return
        # Where rosapi answers it says whether there is a map at all.
        if asked.compression == "cbor" and (asked.topic in self._types or not self._types):
            asyncio.get_running_loop().call_later(CBOR_PATIENCE, self._ask_plainly, wanted)

    def _ask_plainly(self, wanted: Wanted) -> None:
        if self._map is wanted and wanted.subscription.topic not in self._maps_heard:
            self._unsubscribe(wanted)
            self._subscribe(wanted, "none")

    def _unsubscribe(self, wanted: Wanted) -> None:
        try:
            self.connection.send(operations.unsubscribe(wanted.subscription.topic))
        except LinkError:
            return

    def show_map(self, robot: str, floor: str) -> None:
        """Ask for one robot's live map of a floor, and no longer for the one before; "" for none."""
        topic = self._profile.topic("map", robot, floor) if robot else ""
        wanted = self._wanted.get(topic)
        if wanted is self._map:
            return
        if self._map is not None:
            self._unsubscribe(self._map)
        self._map = wanted
        if wanted is not None and self.connection.is_connected:
            self._subscribe(wanted)

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Decode here, or beside the loop if that takes long."""
        self._heard = self._spoke = time.monotonic()
        if len(payload) < HEAVY_BYTES:
            self._take(self._read(payload, is_binary, self._heard))
            return
        loop = asyncio.get_running_loop()
        work = loop.run_in_executor(self._decoder, self._read, payload, is_binary, self._heard)
        work.add_done_callback(lambda done: self._take(done.result()) if not done.cancelled() else None)
        if len(payload) > WORTH_A_PROCESS:
            work.add_done_callback(lambda _: loop.call_later(TIDY_AFTER, give_back))

    def _read(
        self, payload: bytes, is_binary: bool, at: float
    ) -> events.Event | operations.ServiceResponse | None:
        """One frame as what it means. Any thread."""
        if len(payload) > WORTH_A_PROCESS and not is_binary:
            wanted = self._wanted.get(topic_of(payload))
            if wanted is not None and wanted.kind.heavy:
                return self._read_apart(wanted, payload)
        try:
            operation = operations.decode_cbor(payload) if is_binary else operations.decode(payload)
        except WireError as problem:
            return events.FrameRejected(self._link, str(problem))
        match operation:
            case operations.Publish(topic, msg):
                return self._translate(topic, msg, at)
            case operations.Status(level, text):
                LOG.warning("the bridge says (%s): %s", level, text)
                return events.FrameRejected(self._link, f"the bridge says: {text}")
        return operation

    def _read_apart(self, wanted: Wanted, payload: bytes) -> events.Event:
        topic = wanted.subscription.topic
        try:
            event = decode_apart(self._profile, wanted.robot, wanted.floor, payload)
        except WireError as problem:
            return events.MessageRejected(wanted.robot, f"{topic}: {problem}")
        self._maps_heard.add(topic)
        return event

    def _translate(self, topic: str, msg: object, at: float) -> events.Event | None:
        wanted = self._wanted.get(topic)
        if wanted is None:
            return None
        try:
            event = wanted.kind.translate(wanted.robot, wanted.floor, msg, at)
        except WireError as problem:
            return events.MessageRejected(wanted.robot, f"{topic}: {problem}")
        if wanted.kind.heavy:
            self._maps_heard.add(topic)
        return event

    def _take(self, read: events.Event | operations.ServiceResponse | None) -> None:
        if isinstance(read, operations.ServiceResponse):
            self._calls.on_response(read)
        elif read is not None:
            if isinstance(read, events.MessageRejected | events.FrameRejected):
                self._log_once(read.text)
            self._tell(read)

    def _log_once(self, text: str) -> None:
        if text not in self._logged and len(self._logged) < 1000:
            self._logged.add(text)
            LOG.warning("%s", text)

    def close(self) -> None:
        """Close for good."""
        self._decoder.shutdown(wait=False, cancel_futures=True)
        self.connection.shut()
