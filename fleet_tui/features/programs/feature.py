from fleet_tui.features.programs.page import Programs
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.screens.feature import Feature


def programs_feature(console: Console) -> Feature:
    page = Programs(console)
    return Feature(actions={"programs": page.show}, overlays=(page,))
