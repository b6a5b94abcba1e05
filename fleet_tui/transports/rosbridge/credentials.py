"""Credentials for a bridge."""

import platform
import secrets
import time

from fleet_tui.config.access import secret
from fleet_tui.config.schema import Link
from fleet_tui.transports.rosbridge.rosauth import auth


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
