"""Reasons for a missing WebSocket, in plain words with a remedy. No text of a server is repeated: it may
contain our secrets."""

import re
import ssl

from fleet_tui.config.schema import Link
from fleet_tui.errors import STOPPED, UNANSWERED
from fleet_tui.text.language import Message
from fleet_tui.transports.reasons import DROPS, tls_problem

_STATUSES = {
    404: "path not found, correct url",
    407: "proxy in between",
    502: "rosbridge down behind a web server",
    503: "rosbridge down behind a web server",
    504: "rosbridge down behind a web server",
}


def failed_handshake(text: str, bridge: Link, lost_by: Exception | None) -> str:
    """Return the reason that a connection did not become a WebSocket; `text` is autobahn's."""
    if isinstance(lost_by, ssl.SSLError):
        return tls_problem(lost_by, bridge)
    status = re.search(r"upgrade failed \[(\d+)\]", text)
    if status:
        return _http(int(status.group(1)), bridge)
    if "handshake timeout" in text:
        return UNANSWERED
    if "peer dropped" in text:
        remedy = "client_cert required?" if bridge.is_secure else "not rosbridge, or wss://?"
        return f"{DROPS} {remedy}"
    if "HTTP version" in text:
        return "a web server, not rosbridge"
    for wrong in ("Sec-WebSocket-Accept", "subprotocol"):
        if wrong in text:
            return Message("not rosbridge: wrong {wrong}", wrong=wrong)
    return "not rosbridge: no WebSocket"


def _http(status: int, bridge: Link) -> str:
    if status in (401, 403):
        has_one = bridge.authorization_env or bridge.authorization_file
        remedy = "authorization not accepted" if has_one else "set authorization_file"
        return Message("access denied (HTTP {status}): {remedy}", status=status, remedy=Message(remedy))
    words = _STATUSES.get(status, "a web server, not rosbridge")
    return Message("{words} (HTTP {status})", words=Message(words), status=status)


def ended(code: int, text: str, bridge: Link, at_once: bool) -> str:
    """Return the reason that an open connection has ended; `at_once`: before any data."""
    if "ping timeout" in text:
        return STOPPED
    if at_once and (bridge.rosauth_env or bridge.rosauth_file):
        return "closed at once: check the rosauth secret and the clocks"
    if at_once and code in (1000, 1005, 1008):
        return "closed at once: rosauth required (rosauth_file)?"
    closed = {1000: "closed by the server", 1001: "server shut down", 1012: "server restarting"}
    return closed.get(code, "connection lost")
