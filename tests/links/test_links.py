"""An address chooses the transport by its scheme."""

from urllib.parse import urlsplit

import pytest

from fleet_tui.config.fleet import adapters_of
from fleet_tui.config.load import from_text
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FOLDERS, link_of
from fleet_tui.links.rosbridge.link import BridgeLink
from fleet_tui.links.writer import Writer
from fleet_tui.state.store import Store


@pytest.mark.parametrize("url", ["ws://127.0.0.1:9", "wss://127.0.0.1:9", "WS://127.0.0.1:9"])
def test_web_sockets_lead_to_a_rosbridge(url: str) -> None:
    config = from_text(f'rosbridge.url = "{url}"\n[[floors]]\nname = "a"\n[[robots]]\nname = "robot_0"\n')
    writer = Writer(Store(initial_state(config, 0.0)))
    assert isinstance(link_of("rosbridge", config, adapters_of(config), writer), BridgeLink)


def test_every_scheme_that_a_configuration_accepts_has_a_link() -> None:
    for scheme in FOLDERS:
        url = f"{scheme}://127.0.0.1:9"
        text = f'rosbridge.url = "{url}"\n[[floors]]\nname = "a"\n[[robots]]\nname = "robot_0"\n'
        assert from_text(text).rosbridge.scheme == urlsplit(url).scheme
