from fleet_tui.features.routines.page import Routines
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.screens.feature import Feature


def routines_feature(console: Console) -> Feature:
    page = Routines(console)
    return Feature(
        # A routine that runs here ends with the console: it is asked about first.
        actions={"routines": page.show, "quit": page.quit},
        overlays=(page,),
        loss=lambda: Message("a routine runs here") if page.has_losses else EMPTY,
    )
