"""Reasons why there is no link, in plain words."""

import ssl

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.reasons import refusal


@pytest.mark.parametrize(
    ("reason", "words"),
    [
        ("TLSV13_ALERT_CERTIFICATE_REQUIRED", "set client_cert, client_key"),
        ("SSLV3_ALERT_BAD_CERTIFICATE", "set client_cert, client_key"),
        ("WRONG_VERSION_NUMBER", "no TLS on this port"),
        ("UNSUPPORTED_PROTOCOL", "TLS: unsupported protocol"),
    ],
)
def test_what_openssl_says_in_plain_words(reason: str, words: str) -> None:
    problem = ssl.SSLError(1, f"[SSL: {reason}] {reason.lower().replace('_', ' ')} (_ssl.c:2580)")
    problem.reason = reason
    assert words in refusal(problem, Link("wss://a"))
