"""The audit log as CSV, for a spreadsheet: nothing in it is run as a formula."""

import csv
import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import TextIO

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.text.sanitize import sanitize

COLUMNS = AuditRecord.__struct_fields__
# Full-width forms are formulas, too, where the spreadsheet speaks Japanese or Chinese.
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "\uff1d", "\uff0b", "\uff0d", "\uff20")
# One that writes decimals with a comma takes a semicolon for the end of a cell.
_NEXT_CELL = re.compile(r"""(;[\s"']*)(?=[=+\-@\uff1d\uff0b\uff0d\uff20])""")


def cell(value: object) -> str:
    """A value as the text of a cell; one that a spreadsheet would run gets an apostrophe in front."""
    if value is None:
        return ""
    if not isinstance(value, str):
        return str(value)
    text = _NEXT_CELL.sub(r"\1'", sanitize(value))
    return f"'{text}" if value.startswith(_FORMULA) or text.startswith(_FORMULA) else text


def write_csv(file: TextIO, records: Iterable[AuditRecord]) -> int:
    """Write a line of names and one for each record. Returns how many records there were."""
    writer = csv.writer(file)
    writer.writerow(COLUMNS)
    count = 0
    for count, record in enumerate(records, 1):  # noqa: B007  # the count is what is returned
        writer.writerow([cell(getattr(record, name)) for name in COLUMNS])
    return count


def export(path: Path, records: Iterable[AuditRecord]) -> int:
    """Write a new file that only its owner reads, whole or not at all. Returns how many records are in
    it. Raises OSError, also where the file is there already."""
    fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
    try:
        with open(fd, "w", encoding="utf-8", newline="") as file:  # noqa: PTH123  # a Path can't open a descriptor
            return write_csv(file, records)
    except OSError:
        path.unlink(missing_ok=True)
        raise
