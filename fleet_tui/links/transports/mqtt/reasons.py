"""Reasons for a missing connection to a broker, in plain words with a remedy."""

from fleet_tui.config.schema import Link
from fleet_tui.text.language import Message

STOPPED = Message("broker not responding")
NO_ANSWER = Message("reached, but no answer: not an MQTT broker?")
LOST = Message("connection lost")

BAD_ID = 133
NO_SERVICE = 136
BAD_LOGIN = 134
NOT_ALLOWED = 135
OLD_PROTOCOL = 132
"""Reasons for which a broker rejects a connection, as MQTT 5 numbers them."""


def rejected(code: int, link: Link) -> Message:
    """Return the reason for which a broker rejected the connection."""
    match code:
        case _ if code in (BAD_LOGIN, NOT_ALLOWED):
            is_known = bool(link.user_file or link.user_env)
            remedy = (
                Message("correct user_file and password_file")
                if is_known
                else Message("set user_file and password_file")
            )
            return Message("access denied: {remedy}", remedy=remedy)
        case _ if code == NO_SERVICE:
            return Message("broker unavailable: it accepts no clients now")
        case _ if code == BAD_ID:
            return Message("broker rejects the client id: it admits only configured clients")
        case _ if code == OLD_PROTOCOL:
            return Message("broker does not accept MQTT 3.1.1")
    return Message("broker rejects the connection (reason {code})", code=code)


def dropped(link: Link) -> Message:
    """Return the reason of a connection that ended before the broker's first answer."""
    remedy = (
        Message("client_cert required?") if link.is_secure else Message("not an MQTT broker, or mqtts://?")
    )
    return Message("connection dropped at once: {remedy}", remedy=remedy)
