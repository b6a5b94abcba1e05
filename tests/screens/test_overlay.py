"""Overlays: the key after the one that opened it is theirs."""

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import one_packet, sent
from tests.support.watched_store import config_of


@pytest.mark.parametrize("opener", [":", "?"])
async def test_keys_typed_right_after_the_palette_or_help_belong_to_it(
    server: RosbridgeServer, opener: str
) -> None:
    async with console(config_of(server.url, 1)) as it:
        one_packet(it, opener + "pPoxX")
        await it.shows("pPoxX")
        one_packet(it, "\x1b")
        await it.hides("pPoxX")
        assert sent(server) == []
