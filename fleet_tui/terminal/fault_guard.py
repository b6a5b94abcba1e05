"""The fault guard: the console goes on after a fault of its own."""

import logging
from collections.abc import Callable
from typing import TYPE_CHECKING

from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

if TYPE_CHECKING:
    from textual.actions import ActionParseResult

LOG = logging.getLogger(__name__)

MOST_FAILED_TICKS = 10
"""So many one after the other end it: what it shows would be old."""


class FaultGuard:
    """Logs what fails, and has it said by `note`; nothing else ends."""

    def __init__(self, note: Callable[[str], None]) -> None:
        self._note = note
        self._failed_ticks = 0
        self._logged = ""

    def steadily(self, tick: Callable[[], None]) -> None:
        """Do what is done again soon; an error may pass until then. Raises what does not."""
        try:
            tick()
            self._failed_ticks = 0
        except Exception as problem:
            self._failed_ticks += 1
            if self._failed_ticks == MOST_FAILED_TICKS:
                raise
            if repr(problem) != self._logged:  # once: ten times a second it would be all that the log holds
                self._logged = repr(problem)
                LOG.exception("tick")
            self._tell(problem)

    def action_failed(self, action: "str | ActionParseResult", problem: Exception) -> None:
        """Log and say that an action failed, by its key where it is that of one."""
        name = str(action).removeprefix("screen.").removeprefix("key('").removesuffix("')")
        LOG.error("action %s", name, exc_info=problem)
        self._tell(problem)

    def worker_failed(self, error: BaseException) -> None:
        """Log and say that what was done beside the screen failed."""
        LOG.error("worker", exc_info=error)
        self._tell(error)

    def _tell(self, problem: BaseException) -> None:
        # The words of an exception may come from anywhere, and some have none.
        words = sanitize(truncate(str(problem))) or type(problem).__name__
        self._note(f"internal error: {words} (see the log file)")
