from fleet_tui.features.desk.commands import DeskCommands
from fleet_tui.ui.screens.feature import Feature


def desk_feature(desk: DeskCommands) -> Feature:
    return Feature(actions={"desk": desk.menu}, typed=(desk.typed,))
