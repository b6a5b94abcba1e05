"""Tests of links/transports/mqtt/reasons."""

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.mqtt import reasons


@pytest.mark.parametrize(
    ("code", "reason"),
    [
        (reasons.BAD_LOGIN, "access denied: set user_file and password_file"),
        (reasons.NOT_ALLOWED, "access denied: set user_file and password_file"),
        (reasons.NO_SERVICE, "broker unavailable: it accepts no clients now"),
        (reasons.BAD_ID, "broker rejects the client id: it admits only configured clients"),
        (reasons.OLD_PROTOCOL, "broker does not accept MQTT 3.1.1"),
        (199, "broker rejects the connection (reason 199)"),
    ],
)
def test_each_rejection_has_its_remedy(code: int, reason: str) -> None:
    assert reasons.rejected(code, Link("mqtt://a")) == reason


def test_a_drop_without_an_answer_names_the_likeliest_cause() -> None:
    assert reasons.dropped(Link("mqtt://a")).endswith("not an MQTT broker, or mqtts://?")
    assert reasons.dropped(Link("mqtts://a")).endswith("client_cert required?")
