"""The list of a site's lifts, doors, dispensers and closed lanes: read-only."""

from collections.abc import Callable

from fleet_tui.controllers.parts import SetUpParts
from fleet_tui.controllers.typed import Typed
from fleet_tui.model.fleets.facility import LANES
from fleet_tui.rules.alarms.facilities import facility_text, listed
from fleet_tui.text.language import Message, counted

VERB = "facilities"
TITLE = Message("Facilities: lifts, doors, dispensers, closed lanes")


class FacilityList:
    """Lists the facilities of all sites, those that are out of service first."""

    def __init__(self, parts: SetUpParts, clock: Callable[[float], str]) -> None:
        self._parts = parts
        self._clock = clock

    def typed(self, line: str) -> Typed | None:
        """Parse `facilities`, None for any other line."""
        return Typed([(TITLE, self.menu)]) if line.strip().casefold() == VERB else None

    def menu(self) -> None:
        """Open the list, as it is now: its title has the time."""
        state = self._parts.store.state
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
            self._parts.notices.say(Message("no lifts, doors or dispensers are reported"))
            return
        self._parts.open_menu(
            Message("{title}, {clock}", title=TITLE, clock=self._clock(state.wall)),
            [(line, lambda: None) for line in lines],
            searched=True,
        )
