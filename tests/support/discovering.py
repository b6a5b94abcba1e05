"""Discovery of a site."""

import asyncio

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.site import DiscoveredSite, start_discovery


async def discovered(url: str, watch: list[tuple[int, int, str]] | None = None) -> DiscoveredSite:
    told: list[tuple[int, int, str]] = [] if watch is None else watch
    future = start_discovery(Link(url), watch=lambda *progress: told.append(progress))
    return await asyncio.wrap_future(future)
