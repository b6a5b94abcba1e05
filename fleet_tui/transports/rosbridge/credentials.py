"""Credentials for a bridge, which appear in no message."""

import platform
import secrets
import time

from fleet_tui.config.access import secret
from fleet_tui.config.schema import Link
from fleet_tui.transports.rosbridge.rosauth import auth

SHORTEST = 6
"""Minimum characters of a secret to mask: shorter ones occur in too many texts."""


class Credentials:
    """The secrets of one link, as of the last attempt."""

    def __init__(self, bridge: Link) -> None:
        self._bridge = bridge
        self._rosauth = ""
        self.headers: dict[str, str] = {}
        self._secrets: list[bytes] = []

    def read(self) -> None:
        """Read them again: they may have been renewed. Raises ConfigError."""
        authorization = secret(self._bridge, "authorization")
        self.headers = {"Authorization": authorization} if authorization else {}
        self._rosauth = secret(self._bridge, "rosauth")
        words = [*authorization.split(), self._rosauth]
        self._secrets = [word.encode() for word in words if len(word) >= SHORTEST]

    def frame(self, host: str) -> bytes:
        """Return the first frame of a connection, empty if the bridge needs none."""
        if not self._rosauth:
            return b""
        rand, now = secrets.token_hex(16), int(time.time())
        return auth(self._rosauth, platform.node(), host, rand, now)

    def hidden(self, said: bytes) -> bytes:
        """Return a server's text, which may repeat secrets, with those masked, at the same length."""
        for word in self._secrets:
            said = said.replace(word, b"*" * len(word))
        return said
