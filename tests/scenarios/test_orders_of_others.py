"""The history of a process that only watches, beside the console of its machine that gives the orders."""

from pathlib import Path

from fleet_tui.config.fleet import watching
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import OrderChange
from fleet_tui.records.audit.elsewhere import watched_commands
from fleet_tui.records.audit.log import auditing
from fleet_tui.records.history.observing import Observer
from tests.support.links import linked
from tests.support.move_base_site import move_base_site
from tests.support.nav2_site import keeping, nav2_ready, reached


async def test_an_order_that_is_driven_goal_by_goal_is_one_order_of_its_history(tmp_path: Path) -> None:
    observer = Observer()
    changes: list[OrderChange] = []

    def observe(_: FleetState, state: FleetState) -> None:
        changes.extend(fact for fact in observer.observe(state) if isinstance(fact, OrderChange))

    async with (
        move_base_site(tmp_path) as site,
        linked(site.config, queue=keeping(tmp_path)) as (link, store),
        linked(watching(site.config)) as (other, seen),
    ):
        seen.watchers.append(observe)
        with auditing(tmp_path, site.config, store), watched_commands(tmp_path, seen, other.post, "host:9"):
            for state in (store, seen):
                await state.until(lambda state: nav2_ready(state) and state.robots["robot_0"].goals)
            order = link.submit(site.to("Consumidores", "Base"))
            await reached(store, order, Stage.DONE)
            await seen.until(lambda _: any(one.stage == "done" for one in changes))
    (name,) = {one.order for one in changes}
    assert [one.stage for one in changes] == ["queued", "begun", "done"], name
    assert changes[-1].way == "Consumidores -> Base"
