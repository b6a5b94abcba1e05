"""Lines of the audit log of older versions in the form of today's."""

from typing import Any

from fleet_tui.model.audit_record import VERSION

Fields = dict[str, Any]


def upgrade_audit(record: Fields) -> Fields:
    """Bring a line of the audit log to today's form. Raises KeyError, TypeError."""
    if record["version"] >= VERSION:
        return record
    return record | {name: text_id(record[name]) for name in ("start", "end", "order") if name in record}


def text_id(number: object) -> str | None:
    """Return an id as text; what was no id stays none."""
    return None if number is None else str(int(str(number)))
