"""Upgrades lines of the audit log from older versions."""

from typing import Any

from fleet_tui.model.audit_record import VERSION

Fields = dict[str, Any]


def upgrade_audit(record: Fields) -> Fields:
    """Upgrade a line of the audit log. Raises KeyError, TypeError, ValueError."""
    if record["version"] >= VERSION:
        return record
    return record | {name: text_id(record[name]) for name in ("start", "end", "order") if name in record}


def text_id(number: object) -> str | None:
    """Return an id as text; None stays None."""
    return None if number is None else str(int(str(number)))
