"""A record of the audit log as one line of text."""

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.text.details import detail_text
from fleet_tui.text.sanitize import sanitize


def _vertex(label: str, id_: str, with_id: bool) -> str:
    return f"{label} ({id_})" if label and with_id else label or id_


def what_text(record: AuditRecord, with_ids: bool = False) -> str:
    """Return the subject of a record: `robot_0 order Base -> Store`."""
    words = [record.robot or record.link, record.what]
    if record.end is not None:
        start = [] if record.start is None else [_vertex(record.start_label, record.start, with_ids)]
        words += [*start, "->", _vertex(record.end_label, record.end, with_ids)]
    elif record.order is not None:
        words.append(f"order {record.order}")
    return sanitize(" ".join(word for word in words if word))


def line_text(record: AuditRecord) -> str:
    words = detail_text(record.words)
    return sanitize(f"{time_text(record)} {record.operator} {what_text(record)}: {record.change}{words}")


def time_text(record: AuditRecord) -> str:
    """Return month, day and time of day in the record's own time zone: `05-31 12:04:31`."""
    return record.time[5:19].replace("T", " ")
