"""What the bridge knows of one connected client: its subscriptions, and its outbox with all answers and only
the newest few messages of each topic."""

import asyncio
import heapq
import sys
import uuid
from collections import deque
from dataclasses import dataclass, field
from itertools import count

from fleet_tui.simulator.frames import Compression, Frame

COMPRESSIONS: tuple[Compression, ...] = (
    "cbor-raw",
    "cbor",
    "png",
    "none",
)  # the first one that a client requests is used
UNBUFFERED = 1000  # the real bridge blocks all clients at queue_length 0; here a slow client loses the oldest
SLACK = 0.005  # seconds a throttled message may come early, so that a 10 Hz topic fits a throttle of 100 ms


@dataclass
class SubscribeRequest:
    """The options of one subscribe: throttle in seconds, queue length in messages."""

    throttle: float = 0.0
    queue_length: int = 0
    compression: Compression = "none"


@dataclass
class ClientSubscription:
    """A client's interest in one topic: all its subscribes together, by id, make one stream of frames."""

    requests: dict[str | None, SubscribeRequest] = field(default_factory=dict)
    waiting: deque[Frame] = field(default_factory=deque)
    due: float = 0.0
    throttle: float = 0.0
    queue_length: int = 0
    compression: Compression = "none"

    def settle(self) -> None:
        """Take the strictest of all requests, as the bridge does."""
        requests = self.requests.values()
        self.throttle = min(request.throttle for request in requests)
        self.queue_length = min(request.queue_length for request in requests)
        asked = {request.compression for request in requests}
        self.compression = next(one for one in COMPRESSIONS if one in asked)
        self.waiting = deque(self.waiting, maxlen=self.queue_length or UNBUFFERED)

    def sent(self, now: float) -> None:
        """Hold the next frame back for the throttle, without adding up how late this one was."""
        self.due = max(self.due, now - SLACK) + self.throttle


class Outbox:
    """Frames for one client in the order in which they fall due. `now` is monotonic, in seconds."""

    def __init__(self) -> None:
        self._due: list[tuple[float, int, ClientSubscription]] = []
        self._number = count()

    def reply(self, frame: Frame, now: float) -> None:
        """Queue a frame that nothing may replace or hold back."""
        self.offer(ClientSubscription(), frame, now)

    def offer(self, subscription: ClientSubscription, frame: Frame, now: float) -> None:
        """Queue a topic's frame; throttled and without a queue it is lost, with one the newest stay."""
        early = subscription.due > now + SLACK
        if early and subscription.queue_length == 0:
            return
        if not subscription.waiting:
            self._plan(subscription, now)
        subscription.waiting.append(frame)
        if subscription.queue_length == 0:
            subscription.sent(now)

    def take(self, now: float) -> Frame | None:
        """The next frame to send now, None if none is due."""
        while self._due and self._due[0][0] <= now + SLACK:
            subscription = heapq.heappop(self._due)[2]
            if not subscription.waiting:  # unsubscribed meanwhile
                continue
            frame = subscription.waiting.popleft()
            if subscription.queue_length:
                subscription.sent(now)
            if subscription.waiting:
                self._plan(subscription, now)
            return frame
        return None

    @property
    def next_due(self) -> float | None:
        """Return the time at which the next frame is due, if none is added."""
        return self._due[0][0] if self._due else None

    def _plan(self, subscription: ClientSubscription, now: float) -> None:
        at = max(now, subscription.due) if subscription.queue_length else now
        heapq.heappush(self._due, (at, next(self._number), subscription))


class Client:
    """Frames are taken by the one coroutine that writes them."""

    def __init__(self, address: str) -> None:
        self.id = uuid.uuid4()
        self.address = address
        self.subscriptions: dict[str, ClientSubscription] = {}
        self.fragment_size = sys.maxsize
        """Characters of a text frame that is sent whole."""
        self._outbox = Outbox()
        self._wake = asyncio.Event()
        self._loop = asyncio.get_running_loop()

    def offer(self, topic: str, frame: Frame) -> None:
        """Send a topic's frame as this client subscribed to it: throttled, the newest kept."""
        self._outbox.offer(self.subscriptions[topic], frame, self._loop.time())
        self._wake.set()

    def reply(self, frame: Frame) -> None:
        """Send a frame as it is, after those that are already due."""
        self._outbox.reply(frame, self._loop.time())
        self._wake.set()

    async def next_frame(self) -> Frame:
        """Return the next frame, once it is due."""
        while (frame := self._outbox.take(self._loop.time())) is None:
            self._wake.clear()
            due = self._outbox.next_due
            timer = None if due is None else self._loop.call_at(due, self._wake.set)
            await self._wake.wait()
            if timer is not None:
                timer.cancel()
        return frame
