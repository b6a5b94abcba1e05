"""The audit log as text or CSV, without a console."""

import errno
from datetime import datetime
from typing import TextIO

import click

from fleet_tui.config.log_file import state_folder
from fleet_tui.records.audit.export import write_csv
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.line import line_text
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.records.audit.search import search_of
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message


def write_records(typed: str, as_csv: bool, demo: bool, out: TextIO) -> str:
    """Write the matching records, newest first. Returns a note on the log.

    Raises click's UsageError for an invalid time, FleetError if the log can't be read.
    """
    try:
        search = search_of(typed, datetime.now().astimezone(), demo)
    except FleetError as problem:
        raise click.UsageError(str(problem)) from None
    reading = AuditReader(state_folder() / FILE_NAME)
    records = filter(search.wants, reading.newest_first())
    try:
        if as_csv:
            count = write_csv(out, records)
        else:
            count = sum(bool(out.write(f"{line_text(record)}\n")) for record in records)
    except BrokenPipeError:
        raise
    except OSError as problem:
        if problem.errno in (errno.ENOSPC, errno.EDQUOT):
            raise  # by the output: the log is only read
        raise FleetError(
            Message("{path}: {strerror}", path=reading.path, strerror=problem.strerror)
        ) from None
    notes = [reading.note] if reading.note else []
    notes += [] if count else ["no matching record"]
    return f"{reading.path}: {', '.join(notes)}" if notes else ""
