"""Credentials for a bridge."""

import hashlib
import platform
import secrets
import time

import msgspec

from fleet_tui.config.access import secret
from fleet_tui.config.schema import Link

# Seconds of the requested session. rosauth checks it only once, when the connection begins.
SESSION = 86_400


def auth(secret: str, client: str, dest: str, rand: str, now: int) -> bytes:
    """Return the frame that proves to a rosauth server, at Unix second `now`, that we know its secret.

    Source: ROSBRIDGE_PROTOCOL.md (auth) and rosauth's ros_mac_authentication: SHA-512 over the secret and the
    fields as they are sent.
    """
    level, end = "operator", now + SESSION
    mac = hashlib.sha512(f"{secret}{client}{dest}{rand}{now}{level}{end}".encode()).hexdigest()
    fields = {"mac": mac, "client": client, "dest": dest, "rand": rand, "t": now, "level": level, "end": end}
    return msgspec.json.encode({"op": "auth", **fields})


class Credentials:
    """The secrets of one link, as of the last attempt."""

    def __init__(self, bridge: Link) -> None:
        self._bridge = bridge
        self._rosauth = ""
        self.headers: dict[str, str] = {}

    def read(self) -> None:
        """Read them again: they may have been renewed. Raises ConfigError."""
        authorization = secret(self._bridge, "authorization")
        self.headers = {"Authorization": authorization} if authorization else {}
        self._rosauth = secret(self._bridge, "rosauth")

    def frame(self, host: str) -> bytes:
        """Return the first frame of a connection, empty if the bridge needs none."""
        if not self._rosauth:
            return b""
        rand, now = secrets.token_hex(16), int(time.time())
        return auth(self._rosauth, platform.node(), host, rand, now)
