"""Replay of a recording of robots with Nav2 gives the same state at every instant as the live run did."""

from pathlib import Path

import pytest

from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.links.transports.rosbridge import connection
from fleet_tui.model.commands import CancelOrder, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.link import Phase
from fleet_tui.records.recording import recorder
from tests.support.links import finished, phase
from tests.support.nav2_site import Site, nav2_ready, nav2_site, reached
from tests.support.ticking import Ticking, taped

R0, R1 = "robot_0", "robot_1"


@pytest.fixture(autouse=True)
def often(monkeypatch: pytest.MonkeyPatch) -> None:
    """A keyframe every half second; a lost connection comes back at once."""
    monkeypatch.setattr(recorder, "KEYFRAME_EVERY", 0.5)
    monkeypatch.setattr(connection, "FIRST_DELAY", 0.05)


async def eventful(site: Site, link: FleetLink, store: Ticking) -> None:
    """Goals of ours and of others, kept orders, a pause, an abort, a cut link, an obstacle, a lost robot."""
    await store.until(nav2_ready)
    link.show_map(R0, "floor_0")
    first = await finished(link, store, site.to("Receiving", "Base"))
    second = link.submit(site.to("Receiving"))
    await reached(store, second, Stage.WAITING)
    await finished(link, store, PauseRobot(R0))
    await finished(link, store, ResumeRobot(R0))
    await reached(store, first.id, Stage.DONE)
    site.navigation(R1).give(35.0, 20.0)
    state = await store.until(lambda state: state.robots[R1].orders.open)
    await finished(link, store, CancelOrder(R1, state.robots[R1].orders.open[0].id))
    await reached(store, second, Stage.DONE)
    await site.server.drop_clients()
    await store.until(lambda state: not phase(Phase.UP)(state))
    await store.until(lambda state: phase(Phase.UP)(state) and nav2_ready(state))
    third = await finished(link, store, site.to("Consumidores"))
    site.navigation().robot.block()
    await store.until(lambda state: state.robots[R0].blocked)
    site.navigation().abort(106, "no valid control")
    await reached(store, third.id, Stage.FAILED)
    site.navigation().robot.lose()
    await store.until(lambda state: (one := state.robots[R0].variance) is not None and one.value > 1.0)
    await store.until(lambda state: state.floors["floor_0"].live)


async def test_every_instant_is_as_it_was_and_every_keyframe_can_be_gone_to(tmp_path: Path) -> None:
    async with nav2_site(tmp_path) as site:
        with taped(site.config, tmp_path) as (link, store):
            await eventful(site, link, store)
