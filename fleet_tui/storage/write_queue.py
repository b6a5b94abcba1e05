"""What waits for a disk."""

import threading
from collections import deque
from typing import TypeVar

T = TypeVar("T")


class WriteQueue(deque[T]):
    """A bounded queue: of more than so many entries the oldest are lost, and counted."""

    def __init__(self, most: int) -> None:
        super().__init__(maxlen=most)
        self.lost = 0
        self._lock = threading.Lock()

    def append(self, entry: T) -> None:
        """Add the newest entry."""
        with self._lock:
            self.lost += len(self) == self.maxlen
            super().append(entry)

    def put_back(self, entry: T) -> None:
        """Return the oldest entry, which could not be written; it is lost if others have taken its place."""
        with self._lock:  # the newest would be lost, without a count
            if len(self) == self.maxlen:
                self.lost += 1
            else:
                self.appendleft(entry)
