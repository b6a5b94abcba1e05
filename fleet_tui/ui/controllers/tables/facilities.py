"""The list of a site's lifts, doors, dispensers and closed lanes: read-only."""

from fleet_tui.model.fleets.facility import LANES
from fleet_tui.situation.alarms.facilities import facility_text, listed
from fleet_tui.text.language import Message, counted
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Typed

VERB = "facilities"
TITLE = Message("Facilities: lifts, doors, dispensers, closed lanes")


class FacilityList:
    """Lists the facilities of all sites, those that are out of service first."""

    def __init__(self, console: Console) -> None:
        self._console = console

    def typed(self, line: str) -> Typed | None:
        """Parse `facilities`, None for any other line."""
        return Typed([(TITLE, self.menu)]) if line.strip().casefold() == VERB else None

    def menu(self) -> None:
        """Open the list, as it is now: its title has the time."""
        state = self._console.store.state
        lines = [facility_text(state, one) for one in listed(state)]
        lanes = (one for one in state.facilities.values() if one.sort == LANES and one.closed)
        lines += [
            counted(
                "fleet {name}: {count} lane closed",
                "fleet {name}: {count} lanes closed",
                len(one.closed),
                name=one.name,
            )
            for one in lanes
        ]
        if not lines:
            self._console.notices.say(Message("no lifts, doors or dispensers are reported"))
            return
        self._console.open_menu(
            Message("{title}, {clock}", title=TITLE, clock=self._console.settings.clock(state.wall)),
            [(line, lambda: None) for line in lines],
            searched=True,
        )
