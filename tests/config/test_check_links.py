"""Addresses of brokers, and what belongs to which transport."""

import pytest

from fleet_tui.config.load import from_text
from fleet_tui.text.errors import ConfigError

ROBOT = '[[floors]]\nname = "a"\n[[robots]]\nname = "agv_1"\nlink = "site"\n[links.site]\n'


NO_ADDRESS = "is not an address, expected e.g. ws://HOST:9090 or mqtt://HOST"


@pytest.mark.parametrize(
    "url", ["mqtt://broker", "mqtt://broker:1884/", "mqtts://10.0.0.1", "mqtts://[::1]:8883"]
)
def test_a_broker_is_a_link(url: str) -> None:
    config = from_text(f'{ROBOT}url = "{url}"\nuser_env = "U"\npassword_file = "s"\nrole = "master"\n')
    assert config.bridges["site"].is_broker and config.bridges["site"].role == "master"


@pytest.mark.parametrize(
    ("lines", "problem"),
    [
        (
            'url = "mqtt://broker/topic"',
            "url: 'mqtt://broker/topic' has a path: a broker has none, remove it",
        ),
        (
            'url = "mqtt://ana:secret@broker"',
            "url: user and password not allowed: set user_file and password_file to private files",
        ),
        ('url = "mqtt://broker"\nca_file = "ca.pem"', "ca_file: mqtt:// has no TLS, use mqtts:// in the url"),
        (
            'url = "mqtt://broker"\nauthorization_file = "a"',
            "authorization_file: not for mqtt://, set user_file and password_file to private files",
        ),
        ('url = "mqtt://broker"\npassword_file = "a"', "password_file: needs user_file or user_env"),
        (
            'url = "ws://broker"\nuser_file = "a"',
            "user_file: not for ws://, set authorization_file to a file with `Basic ...`",
        ),
        ('url = "ws://broker"\nrole = "pause"', "role: ws:// has no roles, only a broker has them"),
        ('url = "mqtt://broker"\nrole = "king"', "role: 'king' is not one of watch, pause, master"),
        ('url = "ws://${HOST}:9090"', f"url: 'ws://${{HOST}}:9090' {NO_ADDRESS}"),
        ('url = "ws://[fe80::1%eth0]:9090"', f"url: 'ws://[fe80::1%eth0]:9090' {NO_ADDRESS}"),
        ('url = "ws://a b:9090"', f"url: 'ws://a b:9090' {NO_ADDRESS}"),
        (
            'url = "amqp://broker"',
            "url: 'amqp://broker' is not an address, expected e.g. ws://HOST:9090 or mqtt://HOST",
        ),
    ],
)
def test_what_does_not_fit_is_named_with_its_remedy(lines: str, problem: str) -> None:
    with pytest.raises(ConfigError) as found:
        from_text(ROBOT + lines + "\n")
    assert found.value.problems == [f"links.site.{problem}"]
