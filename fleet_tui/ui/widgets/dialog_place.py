"""The place of dialogs about the map."""

from textual.widget import Widget

from fleet_tui.ui.view.layout import DialogBox

BELOW = 2
"""Lines of the screen below its panes: message, footer."""


class DialogPlace:
    """Keeps dialogs at the bottom of the screen in one box, without one where the style sheet has them."""

    def __init__(self, *dialogs: Widget) -> None:
        self._dialogs = dialogs
        self._box: DialogBox | None = None

    def move_to(self, box: DialogBox | None) -> None:
        """Move them, if it is another box."""
        if box == self._box:
            return
        self._box = box
        for dialog in self._dialogs:
            # One that is docked at the side has a whole column.
            here = box if dialog.styles.dock == "bottom" else None
            dialog.styles.offset = (here.left, 0) if here else None
            dialog.styles.width = here.cells if here else None
            dialog.styles.max_height = here.lines if here else None


def lines_below(overlay: Widget) -> int:
    """Return the lines of panes at the bottom of the screen that an overlay covers: 1 of one beside the map,
    for which no pane may take its place."""
    if overlay.display and overlay.styles.dock == "bottom" and overlay.styles.offset.x.value == 0:
        return overlay.outer_size.height + overlay.styles.margin.bottom - BELOW
    return int(overlay.display)
