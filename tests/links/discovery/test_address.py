"""An address as a person types it: what was meant is said."""

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.address import bridge_at
from fleet_tui.text.errors import ConfigError


def test_an_address_is_a_bridge_reached_as_a_known_one_is() -> None:
    known = Link("ws://old", max_message_mb=7)
    assert bridge_at(" ws://robot:9090 ", known) == Link("ws://robot:9090", max_message_mb=7)


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ("http://robot:9090", "did you mean ws://robot:9090?"),
        ("HTTPS://robot", "did you mean wss://robot?"),
        ("robot:9090", "did you mean ws://robot:9090?"),
        ("mqtt://", "is not an address"),
        ("", "is not an address"),
        ("ftp://robot", "is not an address"),
    ],
)
def test_what_is_none_says_what_was_probably_meant(typed: str, words: str) -> None:
    with pytest.raises(ConfigError) as caught:
        bridge_at(typed)
    assert words in str(caught.value)


def test_a_password_in_it_is_not_repeated() -> None:
    with pytest.raises(ConfigError) as caught:
        bridge_at("http://ana:hush@robot")
    assert "hush" not in str(caught.value)
