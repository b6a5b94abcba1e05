from collections.abc import Callable

from fleet_tui.features.history.note import NoteCommand
from fleet_tui.features.history.overlay import HistoryOverlay
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.screens.feature import Feature
from fleet_tui.ui.view.map.layers import MapOptions


def history_feature(
    console: Console, options: Callable[[], MapOptions], loss: Callable[[], Message]
) -> Feature:
    """`loss`: why the console can't be left for a replay now."""
    pages = HistoryOverlay(console, options, loss)
    return Feature(actions={"history": pages.show}, overlays=(pages,), typed=(NoteCommand(console).typed,))
