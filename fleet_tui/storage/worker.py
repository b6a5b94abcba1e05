"""Work beside a disk, which may hang."""

import logging
import threading
import time
from collections.abc import Callable
from pathlib import Path

LOG = logging.getLogger(__name__)


class Worker:
    """Repeats a step in a thread of its own: every so many seconds (None: never by itself), at once when it
    is woken, until it is closed; then it does the end. A mistake in one of them costs that one alone."""

    def __init__(
        self, name: str, step: Callable[[], object], every: float | None, end: Callable[[], object]
    ) -> None:
        self.name = name
        self._step = step
        self._every = every
        self._end = end
        self._began: float | None = None
        self._closing = threading.Event()
        self._woken = threading.Event()
        self._thread = threading.Thread(target=self._work, name=f"fleet-tui-{name}", daemon=True)

    def start(self) -> None:
        """Do the first step."""
        self._thread.start()

    def wake(self) -> None:
        """Do the next step now, or after the present one."""
        self._woken.set()

    @property
    def is_running(self) -> bool:
        """Tell whether there are steps to come, or the end."""
        return self._thread.is_alive()

    @property
    def busy_for(self) -> float:
        """Return the seconds that the present step has taken, 0 between two."""
        began = self._began
        return time.monotonic() - began if began is not None else 0.0

    @property
    def waits_for_processor(self) -> bool:
        """Tell whether its thread could run, and does not: then no disk holds it up."""
        try:
            status = Path(f"/proc/self/task/{self._thread.native_id}/stat").read_text()
        except OSError:
            return False
        return status.rpartition(")")[2].split()[0] == "R"

    def rest(self, seconds: float) -> bool:
        """Wait within a step; tell whether the worker is to be closed."""
        return self._closing.wait(seconds)

    def close(self, within: float) -> bool:
        """Do the end after the present step; tell whether all was over within so many seconds. It may be
        called again."""
        self._closing.set()
        self._woken.set()
        if self._thread.is_alive():
            self._thread.join(within)
        return not self._thread.is_alive()

    def _work(self) -> None:
        while not self._closing.is_set():
            self._woken.clear()
            self._try(self._step)
            if not self._closing.is_set():
                self._woken.wait(self._every)
        self._try(self._end)

    def _try(self, work: Callable[[], object]) -> None:
        self._began = time.monotonic()
        try:
            work()
        except Exception:
            LOG.exception("%s", self.name)
        self._began = None
