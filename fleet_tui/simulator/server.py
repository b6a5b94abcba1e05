"""Serves simulated fleets as rosbridge_server serves a real one, faults included, with access for tests."""

import asyncio
import errno
import logging
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from typing import Any

from websockets.asyncio.server import Server, ServerConnection, serve

from fleet_tui.simulator.channels import resolve
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.logs import DIAGNOSTICS, ROSOUT, Talk, log_topics
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.senses.laser import frames_topic
from fleet_tui.simulator.sessions.session import Session
from fleet_tui.simulator.topics import TopicDesk
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

LARGEST = 128 * 2**20  # bytes of a message from a client
SLOW_RATE = 2.0  # Hz of everything but the poses
MADE_UP = 1.0  # seconds of world time made up for after the process was held up
COUNT = "/client_count"
CLIENTS = "/connected_clients"

# Its own logger with a place to go: a port scan must not print websockets' tracebacks on a terminal.
_LOG = logging.getLogger(__name__)
_LOG.addHandler(logging.NullHandler())


class RosbridgeServer:
    """A rosbridge server in front of one or more fleets, which it steps `rate` times a second.

    `speed`: seconds of world time in a second; the rates
    on the wire stay as they are. Port 0 takes a free one. `subscribe_delay`: seconds every subscribe takes
    (the real bridge needs 0.02).
    The attributes without an underscore are for tests: to read and to change.
    """

    def __init__(
        self,
        fleets: Fleet | Sequence[Fleet],
        host: str = "127.0.0.1",
        port: int = 0,
        rate: float = 10.0,
        subscribe_delay: float = 0.0,
        speed: float = 1.0,
        dialect: Dialect = ROS1,
    ) -> None:
        self._talk = Talk(dialect)
        fleets = fleets if isinstance(fleets, Sequence) else (fleets,)
        now = time.time()
        topics = [topic for fleet in fleets for topic in fleet.topics(now, dialect)]
        message = log_topics(fleets, dialect, self._talk)
        frames = frames_topic([robot for fleet in fleets for robot in fleet.robots], now, dialect)
        topics += [*message, frames, *self._own_topics(dialect)]
        self.bridge = TopicDesk(fleets, dialect, topics, self._talk, subscribe_delay)
        self.fleets = fleets
        self.speed = speed
        self._host = host
        self._port = port
        self._rate = rate
        self._slow_ticks = max(1, round(rate / SLOW_RATE))
        self.report_period = self._slow_ticks / rate  # seconds between two reports of a queue
        self._sessions: dict[Session, float] = {}
        self._server: Server | None = None
        self._life: asyncio.Task[None] | None = None

    @property
    def world(self) -> OhFleet:
        """The first fleet of the source's robots."""
        return next(fleet for fleet in self.fleets if isinstance(fleet, OhFleet))

    async def start(self) -> None:
        """Listen and run the world. Raises FleetError if the port is unavailable."""
        await self._listen()
        self._life = asyncio.create_task(self._live())

    async def _listen(self) -> None:
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
        self.bridge.started = time.monotonic()

    async def stop(self) -> None:
        if self._life is not None:
            self._life.cancel()
            with suppress(asyncio.CancelledError):
                await self._life
        if self._server is not None:
            self._server.close()
            await self._server.wait_closed()

    @property
    def url(self) -> str:
        """Return the address to connect to, once started."""
        return f"ws://{self._host}:{self._port}"

    async def restart_bridge(self, down: float = 0.0) -> None:
        """Stop the bridge with all its connections and restart it on the same port after `down` seconds; the
        robots keep running."""
        assert self._server is not None
        self._server.close()
        await self.drop_clients()
        await self._server.wait_closed()
        self.bridge.forget_subscriptions()
        await asyncio.sleep(down)
        await self._listen()

    async def drop_clients(self) -> None:
        """Abort every connection, like a killed bridge, and wait until all are closed."""
        connections = [session.connection for session in self._sessions]
        self.abort_clients()
        await asyncio.gather(*(connection.wait_closed() for connection in connections))

    def abort_clients(self) -> None:
        for session in self._sessions:
            session.connection.transport.abort()

    async def _attend(self, connection: ServerConnection) -> None:
        session = Session(connection, self.bridge)
        self._sessions[session] = time.time()
        self._announce()
        try:
            await session.run()
        finally:
            del self._sessions[session]
            self.bridge.services.guests.gone(session.client)
            self.bridge.services.actions.gone(session.client)
            for topic in session.client.subscriptions:
                self.bridge.leave(session.client, topic)
            self._announce()

    def _announce(self) -> None:
        for name in (COUNT, CLIENTS):
            self.bridge.publish(name)

    async def _live(self) -> None:
        clock = asyncio.get_running_loop().time
        tick, period = 0, 1.0 / self._rate
        due = clock()
        while True:
            due = max(due + period, clock() - MADE_UP)
            await asyncio.sleep(due - clock())
            tick += 1
            for fleet in self.fleets:
                fleet.step(period * self.speed)
            self._publish_telemetry(tick)

    def _publish_telemetry(self, tick: int) -> None:
        for fleet in self.fleets:
            for level, node, text in fleet.lines():
                self.bridge.publish(ROSOUT, Payload(self._talk.say(time.time(), level, node, text)))
        self.bridge.spread()
        self.bridge.services.actions.publish_feedback()
        if tick % max(1, round(self._rate)) == 0:
            self.bridge.publish(DIAGNOSTICS)
        for name in dict.fromkeys(map(resolve, self.bridge.channels)):
            topic = self.bridge.topics.get(name)
            if topic is None or topic.robot is None or topic.robot.silence > 0.0:
                continue
            # Robots take turns, so that their slow topics do not all fall into one tick.
            turn = (tick + topic.robot.index) % (self._slow_ticks * topic.turns) == 0
            if (topic.fast or turn) and (topic.due is None or topic.due()):
                self.bridge.publish(name)

    def _own_topics(self, dialect: Dialect) -> Iterator[Topic]:
        count, clients = map(dialect.message_type, ("std_msgs/Int32", "rosbridge_msgs/ConnectedClients"))
        yield Topic(COUNT, count, lambda _now: Payload({"data": len(self._sessions)}), latched=True)
        yield Topic(CLIENTS, clients, lambda _now: Payload({"clients": self._clients()}), latched=True)

    def _clients(self) -> list[dict[str, Any]]:
        return [
            {"ip_address": session.client.address, "connection_time": self.bridge.dialect.time(since)}
            for session, since in self._sessions.items()
        ]


def _refusal(host: str, port: int, error: OSError) -> Message:
    if error.errno == errno.EADDRINUSE:
        return Message(
            "port {port} on {host} is in use: stop the other program, or choose another --port",
            port=port,
            host=host,
        )
    return Message(
        "cannot listen on {host} port {port}: {strerror}; choose another --port",
        host=host,
        port=port,
        strerror=error.strerror,
    )
