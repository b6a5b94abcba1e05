"""Reasons for a missing WebSocket, in plain words with a remedy. No text of a server is repeated: it may
contain our secrets."""

import re
import ssl

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.reasons import DROPS, tls_problem
from fleet_tui.text.errors import STOPPED, UNANSWERED
from fleet_tui.text.language import Message

_STATUSES = {
    404: Message("path not found, correct url"),
    407: Message("proxy in between"),
    502: Message("rosbridge down behind a web server"),
    503: Message("rosbridge down behind a web server"),
    504: Message("rosbridge down behind a web server"),
}


def failed_handshake(text: str, bridge: Link, lost_by: Exception | None) -> Message:
    """Return the reason that a connection did not become a WebSocket; `text` is autobahn's."""
    if isinstance(lost_by, ssl.SSLError):
        return tls_problem(lost_by, bridge)
    status = re.search(r"upgrade failed \[(\d+)\]", text)
    if status:
        return _http(int(status.group(1)), bridge)
    if "handshake timeout" in text:
        return UNANSWERED
    if "peer dropped" in text:
        remedy = (
            Message("client_cert required?") if bridge.is_secure else Message("not rosbridge, or wss://?")
        )
        return Message("{drops} {remedy}", drops=DROPS, remedy=remedy)
    if "HTTP version" in text:
        return Message("a web server, not rosbridge")
    for wrong in ("Sec-WebSocket-Accept", "subprotocol"):
        if wrong in text:
            return Message("not rosbridge: wrong {wrong}", wrong=wrong)
    return Message("not rosbridge: no WebSocket")


def _http(status: int, bridge: Link) -> Message:
    if status in (401, 403):
        has_one = bridge.authorization_env or bridge.authorization_file
        remedy = Message("authorization not accepted") if has_one else Message("set authorization_file")
        return Message("access denied (HTTP {status}): {remedy}", status=status, remedy=remedy)
    words = _STATUSES.get(status, Message("a web server, not rosbridge"))
    return Message("{words} (HTTP {status})", words=words, status=status)


def ended(code: int, text: str, bridge: Link, at_once: bool) -> Message:
    """Return the reason that an open connection has ended; `at_once`: before any data."""
    if "ping timeout" in text:
        return STOPPED
    if at_once and (bridge.rosauth_env or bridge.rosauth_file):
        return Message("closed at once: check the rosauth secret and the clocks")
    if at_once and code in (1000, 1005, 1008):
        return Message("closed at once: rosauth required (rosauth_file)?")
    closed = {
        1000: Message("closed by the server"),
        1001: Message("server shut down"),
        1012: Message("server restarting"),
    }
    return closed.get(code, Message("connection lost"))
