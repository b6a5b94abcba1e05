"""Reasons for a missing connection to a broker, in plain words with a remedy."""

from fleet_tui.config.schema import Link
from fleet_tui.text.language import Message

STOPPED = "broker not responding"
NO_ANSWER = "reached, but no answer: not an MQTT broker?"
LOST = "connection lost"

BAD_ID = 133
NO_SERVICE = 136
BAD_LOGIN = 134
NOT_ALLOWED = 135
OLD_PROTOCOL = 132
"""Reasons for which a broker rejects a connection, as MQTT 5 numbers them."""


def rejected(code: int, link: Link) -> str:
    """Return the reason for which a broker rejected the connection."""
    match code:
        case _ if code in (BAD_LOGIN, NOT_ALLOWED):
            is_known = bool(link.user_file or link.user_env)
            remedy = "correct user_file and password_file" if is_known else "set user_file and password_file"
            return Message("access denied: {remedy}", remedy=Message(remedy))
        case _ if code == NO_SERVICE:
            return "broker unavailable: it accepts no clients now"
        case _ if code == BAD_ID:
            return "broker rejects the client id: it admits only configured clients"
        case _ if code == OLD_PROTOCOL:
            return "broker does not accept MQTT 3.1.1"
    return Message("broker rejects the connection (reason {code})", code=code)


def dropped(link: Link) -> str:
    """Return the reason of a connection that ended before the broker's first answer."""
    remedy = "client_cert required?" if link.is_secure else "not an MQTT broker, or mqtts://?"
    return Message("connection dropped at once: {remedy}", remedy=Message(remedy))
