"""Replay of a recording of robots with move_base gives the same state at every instant as the live run
did."""

from pathlib import Path

import pytest

from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import CancelOrder, PauseRobot, ResumeRobot, Stage
from fleet_tui.records.recording import recorder
from tests.support.links import finished
from tests.support.move_base_site import MoveBaseSite, move_base_site
from tests.support.nav2_site import nav2_ready, reached
from tests.support.ticking import Ticking, taped

R0, R1 = "robot_0", "robot_1"


@pytest.fixture(autouse=True)
def often(monkeypatch: pytest.MonkeyPatch) -> None:
    """A keyframe every half second."""
    monkeypatch.setattr(recorder, "KEYFRAME_EVERY", 0.5)


async def eventful(site: MoveBaseSite, link: FleetLink, store: Ticking) -> None:
    """Goals of ours with two stops and of others, kept orders, a pause, a restart."""
    await store.until(nav2_ready)
    first = await finished(link, store, site.to("Consumidores", "Base"))
    second = link.submit(site.to("Receiving"))
    await reached(store, second, Stage.WAITING)
    await finished(link, store, PauseRobot(R0))
    await finished(link, store, ResumeRobot(R0))
    site.navigation(R1).give(35.0, 20.0)
    state = await store.until(lambda state: state.robots[R1].orders.open)
    await finished(link, store, CancelOrder(R1, state.robots[R1].orders.open[0].id))
    await reached(store, first.id, Stage.DONE)
    await reached(store, second, Stage.DONE)
    third = await finished(link, store, site.to("Consumidores"))
    site.navigation().restart()
    await reached(store, third.id, Stage.LOST)


async def test_every_instant_is_as_it_was(tmp_path: Path) -> None:
    async with move_base_site(tmp_path) as site:
        with taped(site.config, tmp_path) as (link, store):
            await eventful(site, link, store)
