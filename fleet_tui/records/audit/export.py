"""The audit log as CSV, for a spreadsheet: no value is run as a formula."""

import csv
import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import TextIO

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.text.sanitize import sanitize

COLUMNS = AuditRecord.__struct_fields__
# Full-width forms are formulas, too, in a Japanese or Chinese spreadsheet.
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "\uff1d", "\uff0b", "\uff0d", "\uff20")
# One with decimal commas treats a semicolon as the end of a cell.
_NEXT_CELL = re.compile(r"""(;[\s"']*)(?=[=+\-@\uff1d\uff0b\uff0d\uff20])""")


def cell(value: object) -> str:
    """Return a value as the text of a cell; one that a spreadsheet would run gets an apostrophe in front."""
    if value is None:
        return ""
    if not isinstance(value, str):
        return str(value)
    text = _NEXT_CELL.sub(r"\1'", sanitize(value))
    return f"'{text}" if value.startswith(_FORMULA) or text.startswith(_FORMULA) else text


def write_csv(file: TextIO, records: Iterable[AuditRecord]) -> int:
    """Write a line of names and one for each record. Returns the number of records."""
    writer = csv.writer(file)
    writer.writerow(COLUMNS)
    count = 0
    for count, record in enumerate(records, 1):  # noqa: B007  # the count is what is returned
        writer.writerow([cell(getattr(record, name)) for name in COLUMNS])
    return count


def export(path: Path, records: Iterable[AuditRecord]) -> int:
    """Write a new file of mode 600, whole or not at all. Returns the number of records. Raises OSError, also
    if the file exists."""
    fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
    try:
        with open(fd, "w", encoding="utf-8", newline="") as file:  # noqa: PTH123  # a Path can't open a descriptor
            return write_csv(file, records)
    except OSError:
        path.unlink(missing_ok=True)
        raise
