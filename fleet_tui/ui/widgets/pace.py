"""The pace of views that need not be made again at every tick."""

import math
from time import monotonic


class Pace:
    """Lets a view be made again every so many seconds, and at once for another `key`."""

    def __init__(self, every: float) -> None:
        self._every = every
        self._at = -math.inf
        self.key: object = None
        """What it was made for last."""

    def is_due(self, key: object = None) -> bool:
        """Tell whether it is to be made now."""
        now = monotonic()
        if key == self.key and now < self._at + self._every:
            return False
        self.key = key
        self._at = now
        return True
