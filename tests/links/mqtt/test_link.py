"""What only bridges have."""

from pathlib import Path

import pytest

from fleet_tui.text.errors import CommandError
from tests.support.broker import broker_in
from tests.support.vda_broker import console_on


async def test_a_broker_has_no_hand_drive_no_live_map_and_no_log(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        async with console_on(broker) as (link, store):
            with pytest.raises(CommandError, match="this kind has no driving by hand"):
                link.drive("agv")
            link.show_map("agv", "hall")
            link.subscribe_logs(True)
            assert store.state.links["broker"].commands_connected
