"""An app that goes on after a fault of its own."""

import logging
from collections.abc import Callable
from typing import TYPE_CHECKING

from fleet_tui.terminal.paint_first import PaintFirst
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

if TYPE_CHECKING:
    from collections.abc import Mapping

    from textual.actions import ActionParseResult
    from textual.dom import DOMNode

LOG = logging.getLogger(__name__)

MOST_FAILED_TICKS = 10
"""So many one after the other end it: what it shows would be old."""


class SteadyApp(PaintFirst):
    """Actions and ticks that fail are logged, said, and end nothing else."""

    _failed_ticks = 0
    _logged = ""

    def note(self, text: str) -> None:
        """Say something soon."""
        raise NotImplementedError

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
            self._note_fault(problem)

    async def run_action(
        self,
        action: "str | ActionParseResult",
        default_namespace: "DOMNode | None" = None,
        namespaces: "Mapping[str, DOMNode] | None" = None,
    ) -> bool:
        """Do what a key, a button or a line of the palette is for."""
        try:
            return await super().run_action(action, default_namespace, namespaces)
        except Exception as problem:
            LOG.exception("action %s", _name(action))
            self._note_fault(problem)
            return True

    def worker_failed(self, error: BaseException) -> None:
        """What was done beside the screen did not succeed; the screen still does."""
        LOG.error("worker", exc_info=error)
        self._note_fault(error)

    def _note_fault(self, problem: BaseException) -> None:
        # The words of an exception may come from anywhere, and some have none.
        words = sanitize(truncate(str(problem))) or type(problem).__name__
        self.note(f"internal error: {words} (details in the log file)")


def _name(action: "str | ActionParseResult") -> str:
    """Return the id of the key where an action is that of one, else all of it."""
    return str(action).removeprefix("screen.key('").removesuffix("')")
