"""The orders given so far: by this console in this session, and those of earlier ones in the audit log."""

from collections.abc import Callable, Iterator
from itertools import islice
from typing import Any

from fleet_tui.commands.language.favourites import Given, given_here
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import Stage
from fleet_tui.records.audit.log import Audit
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.ui.controllers.console import Console

MOST_READ = 2000
"""Number of records of the audit log that are read, the newest ones."""

InBackground = Callable[[Callable[[], object], Callable[[Any], None]], None]
"""Does work in a thread, then calls with its result on the loop."""


class PastOrders:
    """Reads the audit log once, in a thread: a disk may hang."""

    def __init__(self, console: Console) -> None:
        self._store = console.store
        self._files = console.files
        self._in_background = console.in_background
        self._earlier: list[Given] = []
        self._has_read = False

    def newest_first(self) -> list[Given]:
        """Return the orders, as far as they are read."""
        return [*given_here(self._store.state), *self._earlier]

    def read(self, then: Callable[[], object]) -> None:
        """Read the orders of earlier sessions, at the first call only; `then` is called afterwards."""
        if self._has_read or (audit := self._files.audit) is None:
            return
        self._has_read = True

        def keep(found: list[Given]) -> None:
            self._earlier = found
            then()

        self._in_background(lambda: earlier_orders(audit), keep)


def earlier_orders(audit: Audit) -> list[Given]:
    """Return the orders that the newest records have, without those of this run; none if the log can't be
    read. Records of the demo and of real fleets are never mixed."""
    origin = audit.origin
    try:
        records = list(islice(AuditReader(audit.file.path).newest_first(), MOST_READ))
    except OSError:
        return []
    return list(_given(one for one in records if one.demo == origin.demo and one.run != origin.run))


def _given(records: Iterator[AuditRecord]) -> Iterator[Given]:
    seen: set[tuple[str, int | None]] = set()
    for one in records:
        is_order = one.kind == "command" and one.what == "order" and one.change == Stage.SENT.value
        # One that a pause had stopped was sent twice.
        if not is_order or (one.run, one.id) in seen or one.start is None or one.end is None:
            continue
        seen.add((one.run, one.id))
        yield Given(one.start, one.start_label or one.start, one.end, one.end_label or one.end)
