"""The fault guard: keeps the console running after an internal error."""

import logging
from collections.abc import Callable
from typing import TYPE_CHECKING

from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

if TYPE_CHECKING:
    from textual.actions import ActionParseResult

LOG = logging.getLogger(__name__)

MOST_FAILED_TICKS = 10
"""This many errors in a row end it: the screen would be out of date."""


class FaultGuard:
    """Logs errors, and reports them by `note`; nothing else ends."""

    def __init__(self, note: Callable[[str], None]) -> None:
        self._note = note
        self._failed_ticks = 0
        self._logged = ""

    def steadily(self, tick: Callable[[], None]) -> None:
        """Run a repeated function; errors are tolerated up to the limit, then raised."""
        try:
            tick()
            self._failed_ticks = 0
        except Exception as problem:
            self._failed_ticks += 1
            if self._failed_ticks == MOST_FAILED_TICKS:
                raise
            if repr(problem) != self._logged:  # once: ten times a second would fill the log
                self._logged = repr(problem)
                LOG.exception("tick")
            self._report(problem)

    def action_failed(self, action: "str | ActionParseResult", problem: Exception) -> None:
        """Log and report that an action failed, with its key if it has one."""
        name = str(action).removeprefix("screen.").removeprefix("key('").removesuffix("')")
        LOG.error("action %s", name, exc_info=problem)
        self._report(problem)

    def worker_failed(self, error: BaseException) -> None:
        """Log and report that a background task failed."""
        LOG.error("worker", exc_info=error)
        self._report(error)

    def _report(self, problem: BaseException) -> None:
        # The text of an exception may contain anything, or be empty.
        message = sanitize(truncate(str(problem))) or type(problem).__name__
        self._note(Message("internal error: {message} (see the log file)", message=message))
