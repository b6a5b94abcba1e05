"""The main screen's part in the audit log: what it says of it, and who commands."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fleet_tui.audit.log import Audit
    from fleet_tui.screens.audit import AuditLog


class AuditActions:
    """`audit` is None where no log is kept."""

    audit: "Audit | None" = None
    audit_log: "AuditLog"

    @property
    def operator(self) -> str:
        """Who commands, as the log has it."""
        return self.audit.origin.operator if self.audit else ""

    def audit_notes(self) -> list[str]:
        """What is wrong with the log."""
        return self.audit.notes if self.audit else []

    def action_audit(self) -> None:
        """What was commanded, and how it went on."""
        self.audit_log.show()
