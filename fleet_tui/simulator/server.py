"""Serves a world the way rosbridge_server serves a fleet, faults included, with doors for tests."""

import asyncio
import errno
import logging
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from websockets.asyncio.server import Server, ServerConnection, serve

from fleet_tui.errors import FleetError
from fleet_tui.simulator.frames import Frame, Payload, Publication
from fleet_tui.simulator.messages import Topic, topics_of
from fleet_tui.simulator.services import REMEMBERED, ServiceDesk
from fleet_tui.simulator.session import Operation, Session
from fleet_tui.simulator.words import DIAGNOSTICS, ROSOUT, Talk, word_topics
from fleet_tui.simulator.world import World

LARGEST = 128 * 2**20  # bytes of a message from a client
SLOW_RATE = 2.0  # Hz of everything but the poses
MADE_UP = 1.0  # seconds of world time made up for after the process was held up
COUNT = "/client_count"

# Its own logger with a place to go: a port scan must not print websockets' tracebacks on a terminal.
_LOG = logging.getLogger(__name__)
_LOG.addHandler(logging.NullHandler())


class RosbridgeServer(ServiceDesk):
    """A rosbridge server in front of `world`, which it steps `rate` times a second.

    `speed`: seconds of world time in a second; the rates on the wire stay as they are. Port 0 takes a free
    one. `subscribe_delay`: seconds every subscribe takes (the real bridge needs 0.02).
    The attributes without an underscore are for tests: to read and to change.
    """

    def __init__(
        self,
        world: World,
        host: str = "127.0.0.1",
        port: int = 0,
        rate: float = 10.0,
        subscribe_delay: float = 0.0,
        speed: float = 1.0,
    ) -> None:
        found = (*topics_of(world, time.time()), *word_topics(world.robots))
        self.topics = {topic.name: topic for topic in found}
        """What is published, by name."""
        self.topics[COUNT] = Topic(COUNT, "std_msgs/Int32", self._client_count, latched=True)
        self.types = {topic.name: topic.type for topic in self.topics.values()}
        """What rosapi tells of the topics."""
        super().__init__(world, self.types, lambda topic: self.subscribers(topic) > 0)
        self.subscribe_delay, self.speed = subscribe_delay, speed
        self.received: deque[Operation] = deque(maxlen=REMEMBERED)
        """Every operation that arrived; the newest last."""
        self.muted: set[str] = set()
        """Topics that are not published."""
        self.deliveries: dict[str, Callable[[Session, Frame], None]] = {}
        """How the answers of a service are brought to the client, where not at once."""
        self.orphaned: set[str] = set()
        """Topics that come no more, as after a restart of roscore, until nobody holds them."""
        self._host, self._port, self._rate = host, port, rate
        self._slow_ticks = max(1, round(rate / SLOW_RATE))
        self.report_period = self._slow_ticks / rate  # seconds between two reports of a queue
        self._subscribed: dict[str, set[Session]] = {}
        self._sessions: set[Session] = set()
        self._server: Server | None = None
        self._life: asyncio.Task[None] | None = None
        self._talk = Talk()

    async def start(self) -> None:
        """Listen and let the world run. Raises FleetError where the port can't be had."""
        try:
            self._server = await serve(
                self._attend,
                self._host,
                self._port,
                compression=None,
                max_size=LARGEST,
                ping_interval=20.0,
                ping_timeout=20.0,
                close_timeout=1.0,
                logger=_LOG,
            )
        except OSError as error:
            raise FleetError(_refusal(self._host, self._port, error)) from error
        self._port = next(iter(self._server.sockets)).getsockname()[1]
        self._life = asyncio.create_task(self._live())

    async def stop(self) -> None:
        """Close every connection and stop the world."""
        if self._life is not None:
            self._life.cancel()
            with suppress(asyncio.CancelledError):
                await self._life
        if self._server is not None:
            self._server.close()
            await self._server.wait_closed()

    @property
    def url(self) -> str:
        """Where to connect to, once started."""
        return f"ws://{self._host}:{self._port}"

    def subscribed(self) -> set[str]:
        """The topics that somebody is subscribed to."""
        return set(self._subscribed)

    def subscribers(self, topic: str) -> int:
        """How many clients are subscribed to a topic."""
        return len(self._subscribed.get(topic, ()))

    async def drop_clients(self) -> None:
        """Abort every connection, as a bridge does that is killed, and wait until all are gone."""
        connections = [session.connection for session in self._sessions]
        self.abort_clients()
        await asyncio.gather(*(connection.wait_closed() for connection in connections))

    def abort_clients(self) -> None:
        """The same, without waiting."""
        for session in self._sessions:
            session.connection.transport.abort()

    def call(self, session: Session, operation: Operation) -> None:
        """Answer a service call, once its node is awake."""
        delay = self.frozen.get(operation["service"])
        if delay is None:
            self._answer(session, operation)
        else:
            asyncio.get_running_loop().call_later(delay, self._answer, session, operation)

    def _answer(self, session: Session, operation: Operation) -> None:
        answer = self.answer(operation)
        if answer is not None:
            self.deliveries.get(operation["service"], Session.reply)(session, answer)

    def publish_raw(self, topic: str, msg: dict[str, Any] | str | bytes) -> int:
        """Send a message, or as it is a text or binary frame, to the topic's subscribers, past throttle
        and queue. Returns how many there are."""
        publication = Publication(topic, Payload(msg))
        for session in self._subscribed.get(topic, ()):
            compression = session.subscriptions[topic].compression
            session.reply(publication.frame(compression) if isinstance(msg, dict) else msg)
        return self.subscribers(topic)

    def note(self, operation: Operation) -> None:
        """Take note of an operation that arrived."""
        self.received.append(operation)

    def admit(self, topic: str, type_: str | None) -> bool:
        """Whether a topic may be subscribed to: with its type or none; one that is to come, with a type."""
        known = self.topics.get(topic)
        if known is not None and known.type.partition("/")[0] in self.unsourced:
            return False
        return type_ is not None if known is None else type_ in (None, known.type)

    def welcome(self, session: Session, topic: str) -> None:
        """Tell a subscriber the topic's latched value."""
        self._subscribed.setdefault(topic, set()).add(session)
        known = self.topics.get(topic)
        if known is not None and known.latched and topic not in self.muted:
            session.offer(topic, Publication(topic, known.payload(time.time())))

    def leave(self, session: Session, topic: str) -> None:
        """Forget a subscriber."""
        self._subscribed[topic].discard(session)
        if not self._subscribed[topic]:
            del self._subscribed[topic]
            self.orphaned.discard(topic)

    async def _attend(self, connection: ServerConnection) -> None:
        session = Session(connection, self)
        self._sessions.add(session)
        self._publish(COUNT)
        try:
            await session.run()
        finally:
            self._sessions.discard(session)
            for topic in session.subscriptions:
                self.leave(session, topic)
            self._publish(COUNT)

    async def _live(self) -> None:
        clock = asyncio.get_running_loop().time
        tick, period = 0, 1.0 / self._rate
        due = clock()
        while True:
            due = max(due + period, clock() - MADE_UP)
            await asyncio.sleep(due - clock())
            tick += 1
            self.world.step(period * self.speed)
            self._publish_telemetry(tick)

    def _publish_telemetry(self, tick: int) -> None:
        for line in self._talk.lines(self.world.robots, time.time()):
            self._publish(ROSOUT, Payload(line))
        if tick % max(1, round(self._rate)) == 0:
            self._publish(DIAGNOSTICS)
        for name in self._subscribed:
            topic = self.topics.get(name)
            if topic is None or topic.robot is None or topic.robot.silence > 0.0:
                continue
            # Robots take turns, so that their slow topics do not all fall into one tick.
            if topic.fast or (tick + topic.robot.index) % self._slow_ticks == 0:
                self._publish(name)

    def _publish(self, name: str, payload: Payload | None = None) -> None:
        sessions = self._subscribed.get(name)
        if not sessions or name in self.muted or name in self.orphaned:
            return
        publication = Publication(name, payload or self.topics[name].payload(time.time()))
        for session in sessions:
            session.offer(name, publication)

    def _client_count(self, _now: float) -> Payload:
        return Payload({"data": len(self._sessions)})


def _refusal(host: str, port: int, error: OSError) -> str:
    if error.errno == errno.EADDRINUSE:
        return f"port {port} on {host} is taken: stop what listens there, or choose another with --port"
    return f"can't listen on {host} port {port}: {error.strerror}; choose another with --port"
