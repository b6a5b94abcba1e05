"""The main screen's part in an incident: one key packs what a ticket needs."""

import logging
from collections.abc import Callable
from functools import partial
from pathlib import Path

from textual.worker import get_current_worker

from fleet_tui.screens.part import Part

LOG = logging.getLogger(__name__)

Pack = Callable[[str, Callable[[], bool]], Path]
"""From a screenshot (SVG) to the archive; ends early once it is told so. Raises OSError."""


class IncidentActions(Part):
    """`pack` is None where there is nothing to pack."""

    pack: Pack | None = None
    _packing = False
    say: Callable[[str], None]

    def action_bundle(self) -> None:
        """Pack what belongs to an incident into one archive."""
        if self.pack is None:
            self.say("nothing to pack here: this is no live console")
        elif self._packing:
            self.say("still packing: the doctor takes up to 10 s")
        else:
            self._packing = True
            shot = self.app.export_screenshot(title="fleet-tui")
            self.say("packing an incident: the doctor looks at everything first, up to 10 s")
            self.run_worker(partial(self._pack, self.pack, shot), thread=True, exit_on_error=False)

    def _pack(self, pack: Pack, shot: str) -> None:
        """In a thread."""
        from fleet_tui.text.units import size_text

        worker = get_current_worker()
        try:
            path = pack(shot, lambda: worker.is_cancelled)
            # The usual place fits 80 columns.
            where = str(path).replace(str(Path.home()), "~", 1)
            said = f"packed {size_text(path.stat().st_size)}: {where}"
        except Exception as problem:
            # Whatever it is, the operator learns of it, and may try again.
            LOG.exception("packing")
            said = f"the incident could not be packed: {problem}"
        LOG.info("%s", said)
        self._packing = False
        if not worker.is_cancelled:
            self.app.call_from_thread(self.say, said)
