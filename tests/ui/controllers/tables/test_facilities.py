"""The list of lifts, doors, dispensers and closed lanes, from the keyboard."""

import time

from fleet_tui.simulator.rmf.faults import FAULTS
from tests.support.console_pilot import console
from tests.support.rmf_site import FIRST, hospital, rmf_ready


async def test_the_key_lists_what_is_out_of_service_and_what_is_closed() -> None:
    async with hospital(robots=1) as site, console(site.config) as it:
        for name in ("fire", "dispenser", "lanes"):
            FAULTS[name][1](site.server, FIRST)
        await it.until(rmf_ready)
        await it.until(lambda state: any(one.closed for one in state.facilities.values()))
        await it.until(lambda state: sum(bool(one.fault) for one in state.facilities.values()) == 2)
        await it.press("K")
        await it.shows(f"closed lanes, {time.strftime('%H:')}")  # as of when
        for text in ("lift lift_1: fire mode", "dispenser pharmacy: offline", "fleet tiny: 2 lanes closed"):
            await it.shows(text)
        await it.press("escape", "colon")
        await it.type("facilities")
        await it.press("enter")
        await it.shows("ingestor returns: idle")
