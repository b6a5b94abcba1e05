"""What waits for a disk."""

from collections import deque
from typing import TypeVar

T = TypeVar("T")


class WriteQueue(deque[T]):
    """A bounded queue: of more than so many entries the oldest are lost, and counted."""

    def __init__(self, most: int) -> None:
        super().__init__(maxlen=most)
        self.lost = 0

    def append(self, entry: T) -> None:
        """Add the newest entry."""
        self.lost += len(self) == self.maxlen
        super().append(entry)

    def put_back(self, entry: T) -> None:
        """Return the oldest entry, which could not be written; it is lost if others have taken its place."""
        if len(self) == self.maxlen:
            self.lost += 1
        else:
            self.appendleft(entry)
