"""The form of a console reads the audit log of earlier sessions when it opens first."""

from pathlib import Path

from fleet_tui.model.commands import Stage
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit, encode
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.planted_console import planted


async def test_orders_of_earlier_sessions_are_offered(tmp_path: Path) -> None:
    earlier = Origin("ana", "host:1", "earlier")
    ends = {"start": "0", "start_label": "Base", "end": "9", "end_label": "Store"}
    records = [
        earlier.record(1.0 + n, kind="command", what="order", change=Stage.SENT.value, id=n, **ends)
        for n in range(14)
    ]
    (tmp_path / FILE_NAME).write_bytes(b"".join(map(encode, records)))
    audit = Audit(audit_file(tmp_path / FILE_NAME), Origin("ana", "host:1", "now"))
    files = ConsoleFiles()
    files.audit = audit
    async with planted(files=files) as it:
        await it.press("o")
        await it.shows("Base -> Store  (last)", "matches")
        await it.press("escape")
    audit.close(it.store.state)
