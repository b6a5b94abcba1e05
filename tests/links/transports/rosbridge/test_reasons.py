"""Reasons why a connection became no WebSocket, in plain words."""

import ssl

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.rosbridge.reasons import ended, failed_handshake


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("WebSocket connection upgrade failed [404]", "path not found, correct url (HTTP 404)"),
        ("peer dropped the TCP connection", "connection dropped at once: not rosbridge, or wss://?"),
        ("opening handshake timeout", "reached, but no answer"),
    ],
)
def test_a_handshake_that_fails(text: str, reason: str) -> None:
    assert failed_handshake(text, Link("ws://a"), None) == reason


def test_tls_is_the_reason_that_counts() -> None:
    problem = ssl.SSLError(1, "wrong version number")
    problem.reason = "WRONG_VERSION_NUMBER"
    assert failed_handshake("any", Link("wss://a"), problem) == "no TLS on this port: use ws://?"


def test_a_server_that_stops_says_so() -> None:
    assert ended(1001, "", Link("ws://a"), at_once=False) == "server shut down"
