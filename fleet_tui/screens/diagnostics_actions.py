"""The main screen's part in diagnostics: what came over the links, and the key that shows it."""

from typing import TYPE_CHECKING

from fleet_tui.view.selection import Selection

if TYPE_CHECKING:
    from fleet_tui.screens.diagnostics import Diagnostics
    from fleet_tui.screens.diagnostics_pages import RawMessages


class DiagnosticsActions:
    """`backend` is None as long as the console starts."""

    backend: "RawMessages | None" = None
    diagnostics: "Diagnostics"
    selection: Selection

    @property
    def pane_of_keys(self) -> str:
        """Whose keys help lists first, where it is not the map."""
        return "diagnostics" if self.diagnostics.is_open else "table"

    def action_diagnostics(self) -> None:
        """Links, topics, raw messages and logs, live."""
        self.diagnostics.show(self.selection.robot)
