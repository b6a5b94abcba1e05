"""What the bridge knows of one connected client: its subscriptions, and the frames that wait for it."""

import asyncio
import sys
import uuid

from fleet_tui.simulator.frames import Frame
from fleet_tui.simulator.sessions.outbox import ClientSubscription, Outbox


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
