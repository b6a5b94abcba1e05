from fleet_tui.features.audit.page import AuditLog
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.screens.feature import Feature


def audit_feature(console: Console) -> Feature:
    page = AuditLog(console.files, console.notices.say)
    return Feature(actions={"audit": page.show}, overlays=(page,))
