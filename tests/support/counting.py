"""Counters of a link, and waiting for them."""

from collections.abc import Callable

from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.counters import LinkCounter
from tests.support.watched_store import WatchedStore


def counter(link: FleetLink) -> LinkCounter:
    return link.counters["rosbridge"]


async def until(store: WatchedStore, holds: Callable[[], object]) -> None:
    await store.until(lambda _: holds())
