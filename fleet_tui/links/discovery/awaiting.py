"""Waiting for a discovery, with a line of progress on a terminal if it takes long."""

import os
import sys
from concurrent.futures import wait

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.site import WITHIN, DiscoveredSite, start_discovery

QUIET = 1.0
EVERY = 0.2
"""Seconds until progress is shown, and between two updates."""


class Discovering:
    """A running discovery. Its progress line is erased at the end."""

    def __init__(self, bridge: Link, within: float = WITHIN) -> None:
        self._bridge = bridge
        self._done = 0
        self._total = 0
        self._doing = ""
        self._future = start_discovery(bridge, within, self._watch)
        self._shown = False

    def _watch(self, done: int, total: int, doing: str) -> None:
        """Record progress, on the network's thread."""
        self._done = done
        self._total = total
        self._doing = doing

    def result(self) -> DiscoveredSite:
        """Wait for the result. Raises LinkError if the bridge can't be reached, FleetError if rosapi
        fails."""
        try:
            wait([self._future], QUIET)
            while not self._future.done():
                self._show()
                wait([self._future], EVERY)
        finally:
            self._future.cancel()
            self._erase()
        return self._future.result()

    def _show(self) -> None:
        if sys.stderr.isatty() and os.environ.get("TERM") != "dumb":
            count = f" {self._done} of {self._total}" if self._total else ""
            message = f"{self._bridge.shown}: {self._doing}{count}"
            sys.stderr.write(f"\r\x1b[K{message[: os.get_terminal_size(2).columns - 1]}")
            sys.stderr.flush()
            self._shown = True

    def _erase(self) -> None:
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
