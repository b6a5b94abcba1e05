"""When frames are handed to the socket."""

import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from fleet_tui.links.transports.rosbridge.connection import Connection


@contextmanager
def wiretap(counts: Callable[[dict[str, Any]], object], times: list[float]) -> Iterator[None]:
    """Note the time (perf_counter) of each frame that counts."""
    send = Connection.send

    def tapped(self: Connection, payload: bytes) -> None:
        send(self, payload)
        at = time.perf_counter()
        if counts(json.loads(payload)):
            times.append(at)

    Connection.send = tapped  # type: ignore[method-assign]  # the one place where the frame leaves us
    try:
        yield
    finally:
        Connection.send = send  # type: ignore[method-assign]  # as it was
